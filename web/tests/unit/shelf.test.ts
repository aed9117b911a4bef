import 'fake-indexeddb/auto';
import { openDB } from 'idb';
import { beforeEach, expect, it } from 'vitest';
import type { Document } from '../../document/document';
import { emptyDocument } from '../../document/document';
import { addPart, changePart } from '../../document/editing';
import { amend, type History, record, redo, startHistory, undo } from '../../document/history';
import { Shelf } from '../../document/shelf';
import { randomNumbers } from './random';

let name = 0;
let shelf: Shelf;
beforeEach(async () => {
  name++;
  shelf = await Shelf.open(`shelf ${name}`);
});

function drawing(bytes: number[]): Document['drawing'] {
  return { name: 'a.png', kind: 'image', mime: 'image/png', bytes: new Uint8Array(bytes) };
}

function drawn(history: History, gesture: string | null = null): History {
  const at = 10 * history.document.parts.length;
  return record(history, 'draw', addPart(history.document, 'part', [[at, 0], [at + 9, 0], [at, 9]]), gesture);
}

function times(count: number, history: History, step: (history: History) => History): History {
  return Array.from({ length: count }).reduce<History>((now) => step(now), history);
}

it('loads every state and the undo history, saved step by step or at once', async () => {
  const begun = startHistory({ ...emptyDocument(), drawing: drawing([1, 2, 3]) });
  let stepwise = begun;
  for (let i = 0; i < 12; i++) {
    stepwise = drawn(stepwise);
    await shelf.save('stepwise', stepwise);
  }
  await shelf.save('at once', stepwise);
  const fresh = await Shelf.open(`shelf ${name}`);
  for (const id of ['stepwise', 'at once']) {
    const entry = await fresh.entry(id);
    expect(entry?.versions.length).toBe(13);
    expect(entry?.versions.map(({ label }) => label)).toEqual(['', ...Array<string>(12).fill('draw')]);
    for (const [i, { number }] of (entry?.versions ?? []).entries()) expect((await fresh.version(id, number))?.parts.length).toBe(i);
    const history = (await fresh.load(id)) as History;
    expect(history.document).toEqual(stepwise.document);
    expect(times(12, history, undo).document).toEqual(begun.document);
    expect(times(12, times(12, history, undo), redo).document).toEqual(stepwise.document);
    // States share their common values.
    expect(undo(history).document.drawing).toBe(history.document.drawing);
  }
});

it('saves the position in the undo history, and makes no version of a saved state', async () => {
  const history = times(3, times(8, startHistory(emptyDocument()), drawn), undo);
  await shelf.save('a', history);
  const fresh = await Shelf.open(`shelf ${name}`);
  const loaded = (await fresh.load('a')) as History;
  expect([loaded.done.length, loaded.undone.length]).toEqual([5, 3]);
  expect(times(3, loaded, redo).document.parts.length).toBe(8);
  await fresh.save('a', redo(loaded));
  expect((await fresh.entry('a'))?.versions.length).toBe(9);
  await fresh.save('a', drawn(undo(loaded)));
  expect((await fresh.entry('a'))?.versions.length).toBe(10);
  expect(((await fresh.load('a')) as History).undone.length).toBe(0);
});

it('survives random sequences of steps, undo, redo, amendments and reopening', async () => {
  const random = randomNumbers(3);
  let history = startHistory(emptyDocument());
  for (let i = 0; i < 120; i++) {
    const [first] = history.document.parts;
    const deed = Math.floor(6 * random());
    if (deed < 2) history = drawn(history);
    else if (deed === 2) history = undo(history);
    else if (deed === 3) history = redo(history);
    else if (deed === 4 && first) history = record(history, 'c', changePart(history.document, first.id, { c: random() }), 'slide');
    else if (first) history = amend(history, changePart(history.document, first.id, { d: random() }));
    if (random() < 0.5) await shelf.save('a', history);
    if (random() < 0.1) {
      await shelf.save('a', history);
      shelf = await Shelf.open(`shelf ${name}`);
      const loaded = (await shelf.load('a')) as History;
      expect(loaded.document).toEqual(history.document);
      expect([loaded.done.length, loaded.undone.length]).toEqual([Math.min(100, history.done.length), history.undone.length]);
      history = loaded;
    }
  }
});

it('opens the newest intact state if the last one is damaged', async () => {
  await shelf.save('a', times(4, startHistory(emptyDocument()), drawn));
  const database = await openDB(`shelf ${name}`);
  const newest = (await database.get('versions', ['a', 5])) as { fields: Record<string, string> };
  await database.put('versions', { ...newest, fields: { ...newest.fields, parts: '[]' } });
  expect((await shelf.load('a'))?.document.parts.length).toBe(3);
  expect(await shelf.version('a', 5)).toBeNull();
  database.close();
});

it('thins old versions but no undo history, and deletes pictures that no state uses', async () => {
  let history = startHistory(emptyDocument());
  for (let i = 0; i < 450; i++) {
    history = record(history, 'draw', { ...history.document, drawing: drawing([i % 256, i >> 8]) });
    if (i % 90 === 89) await shelf.save('a', history);
  }
  const entry = await shelf.entry('a');
  expect(entry?.versions.length).toBeLessThan(400);
  expect(entry?.versions.length).toBeGreaterThan(200);
  const database = await openDB(`shelf ${name}`);
  expect(await database.count('pictures')).toBe(entry?.versions.filter(({ label }) => label !== '').length);
  database.close();
  expect((await shelf.load('a'))?.done.length).toBe(100);
});

it('takes over the documents of an early editor', async () => {
  const old = await openDB('old', 1, { upgrade: (fresh) => void fresh.createObjectStore('generations', { keyPath: 'number' }) });
  for (const [number, called] of ['wolf', 'bear', 'wolf'].entries())
    await old.put('generations', { number, document: { ...times(number, startHistory(emptyDocument()), drawn).document, name: called } });
  old.close();
  const found = await (await Shelf.open('old')).list();
  expect(found.map((entry) => entry.name).sort()).toEqual(['bear', 'wolf']);
  const wolf = found.find((entry) => entry.name === 'wolf');
  expect((await (await Shelf.open('old')).load(wolf?.id ?? ''))?.document.parts.length).toBe(2);
});

it('lets thrown away documents be brought back', async () => {
  await shelf.save('a', startHistory(emptyDocument()));
  await shelf.remove('a');
  expect(await shelf.list()).toEqual([]);
  await shelf.bringBack('a');
  expect((await shelf.list()).length).toBe(1);
});
