import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const web = fileURLToPath(new URL('../..', import.meta.url));

/** Who may import whom: data flows from the document through tools and view to the page. */
const allowed: Record<string, string[]> = {
  words: [],
  document: [],
  engine: [],
  view: ['document', 'engine'],
  tools: ['document', 'view'],
  app: ['words', 'document', 'engine', 'view', 'tools'],
};

function sources(folder: string): string[] {
  return readdirSync(join(web, folder)).filter((name) => /\.tsx?$/.test(name));
}

it.each(Object.keys(allowed))('%s imports only what it may', (folder) => {
  for (const name of sources(folder)) {
    const text = readFileSync(join(web, folder, name), 'utf8');
    for (const [, path] of text.matchAll(/from '(\.[^']*)'/g)) {
      const target = normalize(join(folder, dirname(name), path ?? '')).split('/')[0] ?? '';
      if (target in allowed && target !== folder) expect(allowed[folder]).toContain(target);
    }
  }
});

it('has no circle of imports, of types neither', () => {
  const imports = new Map<string, string[]>();
  for (const folder of Object.keys(allowed))
    for (const name of sources(folder)) {
      const text = readFileSync(join(web, folder, name), 'utf8');
      const targets = [...text.matchAll(/from '(\.[^']*)'/g)].map(([, path]) => normalize(join(folder, path ?? '')));
      imports.set(join(folder, name).replace(/\.tsx?$/, ''), targets);
    }
  const done = new Set<string>();
  const walk = (file: string, trail: string[]): void => {
    expect(trail, `${[...trail, file].join(' -> ')}`).not.toContain(file);
    if (done.has(file)) return;
    for (const target of imports.get(file) ?? []) walk(target, [...trail, file]);
    done.add(file);
  };
  expect(imports.size).toBeGreaterThan(50);
  for (const file of imports.keys()) walk(file, []);
});

it.each(Object.keys(allowed))('%s has small files and no untyped values', (folder) => {
  for (const name of sources(folder)) {
    const text = readFileSync(join(web, folder, name), 'utf8');
    expect(text.split('\n').length, name).toBeLessThanOrEqual(300);
    expect(text, name).not.toMatch(/: any\b|<any>|as any\b|innerHTML|@ts-ignore/);
  }
});
