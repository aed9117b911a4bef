import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const web = fileURLToPath(new URL('../..', import.meta.url));

/** The rooms of the page in the order of their imports, each with exactly the rooms that it imports. */
const allowed: Record<string, string[]> = {
  words: [],
  document: [],
  engine: [],
  view: ['document', 'engine'],
  tools: ['document', 'view'],
  'app/state': ['document', 'engine', 'view', 'tools'],
  'app/files': ['words', 'document', 'engine', 'view'],
  'app/control': ['words', 'document', 'engine', 'view', 'app/state', 'app/files'],
  'app/widgets': ['words', 'document', 'app/state'],
  'app/panes': ['words', 'document', 'engine', 'view', 'tools', 'app/state'],
  'app/bars': ['words', 'document', 'view', 'tools', 'app/state', 'app/control', 'app/widgets'],
  'app/panels': ['words', 'document', 'engine', 'view', 'app/state', 'app/control', 'app/widgets'],
  'app/shell': [
    'words', 'document', 'engine', 'view', 'tools',
    'app/state', 'app/control', 'app/widgets', 'app/panes', 'app/bars', 'app/panels',
  ],
  app: ['words', 'document', 'engine', 'app/state', 'app/files', 'app/control', 'app/panes', 'app/shell'],
};

/** Folders that are not rooms of the page. */
const outside = ['.', 'tests', 'node_modules', 'public', 'thumbnails'];

/** A source by its path below web, with the files that it imports, including workers and modules loaded later. */
interface Source {
  readonly path: string;
  readonly text: string;
  readonly imports: readonly string[];
}

function read(path: string): Source {
  const text = readFileSync(join(web, path), 'utf8');
  const named = /(?:from |import\(|new URL\()'(\.[^'?]*)(?:\?url)?'/g;
  const imports = [...text.matchAll(named)].map(([, name]) => normalize(join(dirname(path), name ?? '')).replace(/\.tsx?$/, ''));
  return { path, text, imports };
}

const sources = readdirSync(web, { recursive: true, encoding: 'utf8' })
  .filter((path) => /\.tsx?$/.test(path) && !outside.includes(dirname(path).split('/')[0] ?? ''))
  .map(read);

const sourcesOf = (room: string): Source[] => sources.filter(({ path }) => dirname(path) === room);

it('has every source in a room', () => {
  expect(sources.length).toBeGreaterThan(100);
  for (const { path } of sources) expect(Object.keys(allowed), path).toContain(dirname(path));
});

it('has rooms in an order, in which none imports a later one', () => {
  const rooms = Object.keys(allowed);
  rooms.forEach((room, at) => {
    for (const other of allowed[room] ?? []) expect(rooms.slice(0, at), `${room} imports ${other}`).toContain(other);
  });
});

it.each(Object.keys(allowed))('%s imports exactly the rooms that are listed', (room) => {
  const used = new Set<string>();
  for (const { path, imports } of sourcesOf(room))
    for (const target of imports) {
      const other = dirname(target);
      if (other === room || !(other in allowed)) continue;
      used.add(other);
      expect(allowed[room], `${path} imports ${target}`).toContain(other);
    }
  expect([...used].sort()).toEqual([...(allowed[room] ?? [])].sort());
});

it('has no cycle of imports, not even of types', () => {
  const imports = new Map(sources.map(({ path, imports: targets }) => [path.replace(/\.tsx?$/, ''), targets]));
  const done = new Set<string>();
  const walk = (file: string, trail: string[]): void => {
    expect(trail, `${[...trail, file].join(' -> ')}`).not.toContain(file);
    if (done.has(file)) return;
    for (const target of imports.get(file) ?? []) walk(target, [...trail, file]);
    done.add(file);
  };
  for (const file of imports.keys()) walk(file, []);
});

it.each(Object.keys(allowed))('%s has small files and no untyped values', (room) => {
  for (const { path, text } of sourcesOf(room)) {
    expect(text.split('\n').length, path).toBeLessThanOrEqual(300);
    expect(text, path).not.toMatch(/: any\b|<any>|as any\b|innerHTML|@ts-ignore/);
  }
});

it.each(Object.keys(allowed))('%s has at most 30 files', (room) => {
  expect(sourcesOf(room).length).toBeLessThanOrEqual(30);
});
