import { english, type MessageKey, type Words } from './english';

export type { MessageKey } from './english';

/** The languages of the page, by their own names. */
export const languages = { en: 'English', de: 'Deutsch', fr: 'Français', es: 'Español', ja: '日本語' };

export type Language = keyof typeof languages;

/** Loads the words of one language; only the chosen one is ever loaded. */
const others: Record<Exclude<Language, 'en'>, () => Promise<Words>> = {
  de: async () => (await import('./german')).german,
  fr: async () => (await import('./french')).french,
  es: async () => (await import('./spanish')).spanish,
  ja: async () => (await import('./japanese')).japanese,
};

/** The current language. */
export let language: Language = 'en';
let words: Words = english;

const chosenKey = 'language';

const isLanguage = (name: string): name is Language => Object.hasOwn(languages, name);

/** Returns the language chosen earlier, else the first language of the browser that the page has, else English. */
export function preferredLanguage(chosen: string | null, browser: readonly string[]): Language {
  const wanted = [chosen ?? '', ...browser.map((name) => name.slice(0, 2).toLowerCase())];
  return wanted.find(isLanguage) ?? 'en';
}

/** Returns the language for this visit. */
export function visitorsLanguage(): Language {
  let chosen: string | null = null;
  try {
    chosen = localStorage.getItem(chosenKey);
  } catch {
    // Without storage the browser's languages decide.
  }
  return preferredLanguage(chosen, navigator.languages);
}

/** Remembers a language for later visits. */
export function chooseLanguage(name: Language): void {
  try {
    localStorage.setItem(chosenKey, name);
  } catch {
    // Without storage the choice holds for this visit only.
  }
}

/** Switches to a language. If its words cannot be loaded, the current language stays. */
export async function speak(wanted: Language): Promise<void> {
  try {
    words = wanted === 'en' ? english : await others[wanted]();
    language = wanted;
  } catch {
    // Without a network the words loaded so far must do.
  }
  if (typeof document !== 'undefined') document.documentElement.lang = language;
}

/** Returns the text of a key with each {name} replaced by its value. */
export function t(key: MessageKey, values: Record<string, string | number> = {}): string {
  return words[key].replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ''));
}
