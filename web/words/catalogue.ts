import { english, type MessageKey, type Words } from './english';

export type { MessageKey } from './english';

/** The languages that the page speaks, by their own names. */
export const languages = { en: 'English', de: 'Deutsch', fr: 'Français', es: 'Español', ja: '日本語' };

export type Language = keyof typeof languages;

/** Whoever needs one of these loads it alone. */
const others: Record<Exclude<Language, 'en'>, () => Promise<Words>> = {
  de: async () => (await import('./german')).german,
  fr: async () => (await import('./french')).french,
  es: async () => (await import('./spanish')).spanish,
  ja: async () => (await import('./japanese')).japanese,
};

/** The language that is spoken now. */
export let language: Language = 'en';
let words: Words = english;

const chosenKey = 'language';

const isLanguage = (name: string): name is Language => Object.hasOwn(languages, name);

/** The one that was chosen here before, else the first of the browser's own that the page speaks. */
export function preferredLanguage(chosen: string | null, browser: readonly string[]): Language {
  const wanted = [chosen ?? '', ...browser.map((name) => name.slice(0, 2).toLowerCase())];
  return wanted.find(isLanguage) ?? 'en';
}

/** The language of this visit; storage may be refused. */
export function visitorsLanguage(): Language {
  let chosen: string | null = null;
  try {
    chosen = localStorage.getItem(chosenKey);
  } catch {
    // The browser's own languages it is.
  }
  return preferredLanguage(chosen, navigator.languages);
}

/** From the next visit on. */
export function chooseLanguage(name: Language): void {
  try {
    localStorage.setItem(chosenKey, name);
  } catch {
    // Then only now.
  }
}

/** Speaks `wanted` from here on; where its words cannot be loaded, what was spoken before. */
export async function speak(wanted: Language): Promise<void> {
  try {
    words = wanted === 'en' ? english : await others[wanted]();
    language = wanted;
  } catch {
    // Without a network the words that are there must do.
  }
  if (typeof document !== 'undefined') document.documentElement.lang = language;
}

/** The text of a key, with {names} filled in. */
export function t(key: MessageKey, values: Record<string, string | number> = {}): string {
  return words[key].replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ''));
}
