import { expect, it } from 'vitest';
import { catalogues, t } from '../../app/catalogue';

it('says everything in every language, with the same values', () => {
  const values = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();
  const { en, de } = catalogues;
  for (const key of Object.keys(en) as (keyof typeof en)[]) {
    expect(de[key].trim()).not.toBe('');
    expect(values(de[key])).toEqual(values(en[key]));
  }
});

it('fills in values', () => {
  expect(t('goOn', { name: 'wolf' })).toContain('wolf');
});
