import { expect, it } from 'vitest';
import { language, preferredLanguage, speak, t } from '../../words/catalogue';
import { english, type MessageKey, type Words } from '../../words/english';
import { french } from '../../words/french';
import { german } from '../../words/german';
import { japanese } from '../../words/japanese';
import { spanish } from '../../words/spanish';

const keys = Object.keys(english) as MessageKey[];
const translations: Record<string, Words> = { german, french, spanish, japanese };

it.each(Object.keys(translations))('has every text in %s, with the same values', (name) => {
  const values = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();
  const words = translations[name] as Words;
  expect(Object.keys(words).sort()).toEqual([...keys].sort());
  for (const key of keys) {
    expect(words[key].trim()).not.toBe('');
    expect(values(words[key]), key).toEqual(values(english[key]));
  }
});

it.each(Object.keys(translations))('leaves no sentence of %s in English', (name) => {
  const words = translations[name] as Words;
  const same = keys.filter((key) => words[key] === english[key] && english[key].split(' ').length > 3);
  expect(same).toEqual([]);
});

it('prefers the chosen language, else the first language of the browser that it has', () => {
  expect(preferredLanguage('ja', ['de-AT', 'en'])).toBe('ja');
  expect(preferredLanguage(null, ['nl', 'fr-CA', 'en'])).toBe('fr');
  expect(preferredLanguage('xx', ['nl'])).toBe('en');
});

it('fills in values, in the current language', async () => {
  expect(t('goOn', { name: 'wolf' })).toContain('Continue with “wolf”');
  await speak('es');
  expect(language).toBe('es');
  expect(t('goOn', { name: 'wolf' })).toBe('Seguir con «wolf»');
  await speak('en');
});
