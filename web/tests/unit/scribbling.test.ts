import { describe, expect, it } from 'vitest';
import { noteCorrections } from '../../document/corrections';
import { type Document, emptyDocument, type Point } from '../../document/document';
import {
  addJoin, addPart, addRange, bringBefore, changePart, joinParts, movePart, relate, removeJoin, removePart, removeRanges,
  renamePart,
} from '../../document/editing';
import { amend, type History, record, redo, startHistory, undo } from '../../document/history';
import { readProject, writeProject } from '../../document/project_file';
import { sceneText } from '../../document/scene_text';
import {
  addStroke, adopt, canScribble, clearStrokes, eraseStrokes, partOfStroke, scribblesOf, segmentationOf, strokeAt, type Understood,
} from '../../document/scribbling';
import { type Corrections, emptySegmentation, recordText, type Segmentation } from '../../document/segmentation';
import { randomNumbers } from './random';

function box(x: number, y: number, width: number, height: number): Point[] {
  return [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
}

const shapes: Record<string, Point[]> = {
  body: box(200, 200, 300, 200), head: box(150, 120, 120, 130), arm: box(400, 300, 60, 250),
};

/** A segmented flat drawing with a body, a head and an arm; labels 1, 2, 3. */
function flat(): Document {
  const bytes = new Uint8Array([1, 2, 3]);
  let document: Document = { ...emptyDocument(), drawing: { name: 'a.png', kind: 'image', mime: 'image/png', bytes } };
  for (const [id, ring] of Object.entries(shapes)) document = addPart(document, id, ring);
  document = joinParts(document, 'head', 'body');
  const parts = Object.keys(shapes).map((id, i) => ({ label: i + 1, id, completion: 'whole' }));
  const segmentation: Segmentation = { ...emptySegmentation(), parts, labels: new Uint8Array([7]) };
  return { ...document, parts: document.parts.map(({ color: _color, ...part }) => part), segmentation };
}

function edited(document: Document, change: (document: Document) => Document): Document {
  return noteCorrections(document, change(document));
}

function corrections(document: Document): Corrections {
  return document.segmentation!.corrections;
}

/** Imitates an engine that finds the parts of the document, and a new part for each new name. */
function understoodAsIs(document: Document): Understood {
  const { parts, scribbles } = segmentationOf(document);
  const isThere = (id: string): boolean => document.parts.some((part) => part.id === id);
  const fresh = parts.filter(({ id }) => scribbles.parts.includes(id) && !isThere(id));
  const outline = (label: number): Point[][] => [box(10 * label, 10, 50, 60)];
  const scene = { ...document, parts: [...document.parts, ...fresh.map(({ id, label }) => ({ id, outline: outline(label), c: 2, d: 1 }))] };
  return { project: recordText(segmentationOf(document)), scene: sceneText(scene), labels: new Uint8Array([parts.length]) };
}

describe('strokes', () => {
  const line: Point[] = [[300, 300], [320, 320]];

  it('take over the guessed part that they cover, continue the stroke on which they begin, or make a new part', () => {
    const document = flat();
    expect(partOfStroke(document, line, 5)).toBe('body');
    const first = addStroke(document, { kind: 'hard', part: 'body', width: 8, points: line });
    expect(partOfStroke(first, [[310, 312], [420, 500]], 5)).toBe('body');
    expect(partOfStroke(first, [[250, 350], [260, 380]], 5)).toBe('part-4');
    expect(partOfStroke(first, [[430, 500], [440, 520]], 5)).toBe('arm');
    expect(partOfStroke(first, [[800, 700]], 5)).toBe('part-4');
  });

  it('keep their names and widths, are found again, rubbed out and cleared', () => {
    let document = addStroke(flat(), { kind: 'hard', part: 'body', width: 8, points: line });
    document = addStroke(document, { kind: 'outside', width: 8, points: [[900, 700]] });
    expect(scribblesOf(document).parts).toEqual(['body']);
    expect(strokeAt(scribblesOf(document), [310, 310], 1)?.part).toBe('body');
    expect(strokeAt(scribblesOf(document), [310, 340], 1)).toBeUndefined();
    expect(eraseStrokes(document, [[600, 600]], 4)).toBe(document);
    expect(scribblesOf(eraseStrokes(document, [[312, 308]], 4)).strokes.map(({ kind }) => kind)).toEqual(['outside']);
    expect(scribblesOf(clearStrokes(document, { kind: 'outside' })).strokes.length).toBe(1);
    expect(scribblesOf(clearStrokes(document, { part: 'body' })).parts).toEqual([]);
    expect(clearStrokes(document, { part: 'head' })).toBe(document);
  });

  it('are for flat pictures whose parts did not come from elsewhere', () => {
    expect(canScribble(flat())).toBe(true);
    expect(canScribble({ ...flat(), segmentation: null })).toBe(false);
    expect(canScribble(emptyDocument())).toBe(false);
  });

  it('are removed and renamed with their part', () => {
    const document = addStroke(flat(), { kind: 'hard', part: 'head', width: 8, points: [[180, 150]] });
    expect(scribblesOf(removePart(document, 'head')).strokes).toEqual([]);
    const renamed = renamePart(document, 'head', 'skull');
    expect(scribblesOf(renamed)).toMatchObject({ parts: ['skull'], strokes: [{ part: 'skull' }] });
    expect(corrections(renamed).parts).toEqual([{ label: 2, id: 'skull' }]);
  });
});

describe('a change by the user', () => {
  it('of a part is recorded with its last value', () => {
    let document = edited(flat(), (before) => changePart(before, 'arm', { c: 1 }));
    document = edited(document, (before) => changePart(before, 'arm', { c: 2 }));
    document = edited(document, (before) => changePart(before, 'arm', { d: -1 }));
    document = edited(document, (before) => changePart(before, 'arm', { flat: 0.5 }));
    document = edited(document, (before) => changePart(before, 'arm', { lean: [0, 0] }));
    document = edited(document, (before) => changePart(before, 'body', { outline: [box(0, 0, 9, 9)] }));
    expect(corrections(document).parts).toEqual([
      { label: 1, outline: [box(0, 0, 9, 9)] },
      { label: 3, c: 2, d: -1, flat: 0.5, lean: [0, 0] },
    ]);
  });

  it('of the order is recorded for every pair that changed places, and never in a cycle', () => {
    let document = edited(flat(), (before) => movePart(before, 'body', 2));
    expect(corrections(document).order).toEqual([{ upper: 1, lower: 2 }, { upper: 1, lower: 3 }]);
    document = edited(document, (before) => bringBefore(before, 'arm', 'body'));
    expect(corrections(document).order).toEqual([{ upper: 1, lower: 2 }, { upper: 3, lower: 1 }]);
  });

  it('of joins is recorded when they are made, moved or removed, not when they only turned', () => {
    const without = edited(flat(), (before) => removeJoin(before, 'head', 'body'));
    expect(corrections(without)).toMatchObject({ joins: [], no_joins: [{ upper: 2, lower: 1 }] });
    const again = edited(without, (before) => joinParts(before, 'head', 'body'));
    expect(corrections(again).no_joins).toEqual([]);
    expect(corrections(again).joins).toMatchObject([{ upper: 2, lower: 1, line: again.joins[0]!.line }]);
    const moved = edited(flat(), (before) => addJoin(before, { upper: 'head', lower: 'body', line: [[1, 1], [2, 2]] }));
    expect(corrections(moved).joins).toEqual([{ upper: 2, lower: 1, line: [[1, 1], [2, 2]] }]);
    const turned = edited(flat(), (before) => movePart(before, 'body', 2));
    expect(turned.joins[0]).toMatchObject({ upper: 'body', lower: 'head' });
    expect(corrections(turned)).toMatchObject({ joins: [], no_joins: [] });
    expect(corrections(edited(again, (before) => movePart(before, 'body', 2))).joins).toMatchObject([{ upper: 1, lower: 2 }]);
  });

  it('of relations and ranges is recorded, and taken back', () => {
    const related = edited(flat(), (before) => relate(before, 'arm', 'body', 'equal'));
    expect(corrections(related).relations).toEqual([{ upper: 3, lower: 1, relation: 'equal' }]);
    expect(corrections(edited(related, (before) => relate(before, 'arm', 'body', null))).relations).toEqual([]);
    const ranged = edited(flat(), (before) => addRange(before, 'head', [270, 250], [200, 250]));
    expect(corrections(ranged).robin).toMatchObject([{ upper: 2, lower: 1 }]);
    const cleared = edited(ranged, (before) => removeRanges(before, 'head', 'body'));
    expect(corrections(cleared).robin).toEqual([]);
    expect(corrections(cleared).joins.length).toBe(1);
  });

  it('of parts drawn by hand is not recorded', () => {
    const document = edited(flat(), (before) => addPart(before, 'hat', box(150, 90, 80, 60)));
    const joined = edited(document, (before) => joinParts(before, 'hat', 'head'));
    expect(joined.joins.length).toBe(2);
    expect(corrections(joined)).toEqual(corrections(flat()));
  });
});

describe('a new interpretation', () => {
  it('leaves drawn parts and their colours as they are, and may have no parts', () => {
    const document = edited(flat(), (before) => addPart(before, 'hat', box(150, 90, 80, 60)));
    const next = adopt(document, understoodAsIs(document));
    expect(next.parts.find((part) => part.id === 'hat')).toBe(document.parts.find((part) => part.id === 'hat'));
    const none = adopt(document, { ...understoodAsIs(document), scene: '' });
    expect(none).toMatchObject({ parts: [], joins: [], cues: [] });
    expect(none.segmentation!.parts).toEqual(document.segmentation!.parts);
  });

  it('that equals the one before keeps the same parts, so that nothing is built again', () => {
    const before = flat();
    const stroke = { kind: 'outside' as const, width: 9, points: [[900, 20] as Point] };
    const next = adopt(before, understoodAsIs(addStroke(before, stroke)));
    for (const key of ['parts', 'joins', 'relations', 'robin'] as const) expect(next[key]).toBe(before[key]);
    expect(next.segmentation!.scribbles.strokes.length).toBe(1);
  });

  it('brings in the part of a new stroke', () => {
    const stroke = { kind: 'hard' as const, part: 'part-4', width: 9, points: [[700, 700] as Point] };
    const next = adopt(flat(), understoodAsIs(addStroke(flat(), stroke)));
    expect(next.parts.map((part) => part.id)).toEqual(['body', 'head', 'arm', 'part-4']);
  });
});

function anyStep(history: History, random: () => number): History {
  const { document } = history;
  const pick = (): string => document.parts[Math.floor(random() * document.parts.length)]?.id ?? '';
  const spot = (): Point => [Math.round(1000 * random()), Math.round(800 * random())];
  const stroke = (): Document => {
    const points = [spot(), spot()];
    return addStroke(document, { kind: 'hard', part: partOfStroke(document, points, 4), width: 8, points });
  };
  const understood = (changed: Document): Document => adopt(changed, understoodAsIs(changed));
  const steps = [
    () => understood(stroke()),
    () => understood(addStroke(document, { kind: random() < 0.5 ? 'outside' : 'hole', width: 5, points: [spot()] })),
    () => understood(eraseStrokes(document, [spot(), spot()], 100)),
    () => edited(document, (before) => movePart(before, pick(), Math.floor(5 * random()))),
    () => edited(document, (before) => removePart(before, pick())),
    () => edited(document, (before) => changePart(before, pick(), { c: 1 + random() })),
    () => edited(document, (before) => renamePart(before, pick(), `name ${Math.floor(9 * random())}`)),
    () => edited(document, (before) => addPart(before, 'drawn', box(...spot(), 80, 90))),
    () => edited(document, (before) => joinParts(before, pick(), pick())),
  ];
  const next = record(history, 'step', steps[Math.floor(random() * steps.length)]!());
  return random() < 0.2 ? amend(next, understood(next.document)) : next;
}

it('is undone and redone to the same project, byte for byte, for random strokes and corrections', () => {
  for (let seed = 1; seed <= 100; seed++) {
    const random = randomNumbers(seed);
    let history = startHistory(flat());
    const first = writeProject(history.document, null);
    for (let i = 0; i < 40; i++) history = random() < 0.15 ? undo(history) : anyStep(history, random);
    while (history.undone.length > 0) history = redo(history);
    const last = writeProject(history.document, null);
    expect(readProject(last)).toEqual(history.document);
    const ids = history.document.parts.map((part) => part.id);
    expect(new Set(ids).size).toBe(ids.length);
    while (history.done.length > 0) history = undo(history);
    expect(writeProject(history.document, null)).toEqual(first);
    while (history.undone.length > 0) history = redo(history);
    expect(writeProject(history.document, null)).toEqual(last);
  }
});
