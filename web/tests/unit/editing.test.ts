import { describe, expect, it } from 'vitest';
import { type Document, emptyDocument, partIndex, type Point } from '../../document/document';
import {
  addJoin, addOpenPart, addPart, addRange, bringBefore, changePart, changeSettings, colorPart, joinOfLine, joinParts, movePart,
  isMovable, neighbours, relate, removePart, renamePart, shiftPart,
} from '../../document/editing';
import { area, contains, longestRunInside, nearestPlace } from '../../document/outline';
import { record, redo, startHistory, undo } from '../../document/history';
import { pushOutline } from '../../document/reshape';
import { sceneContent, sceneText } from '../../document/scene_text';
import { randomNumbers } from './random';
import { box } from './shapes';

/** A body with a head and an arm that reach into it. */
function figure(): Document {
  let document = addPart(emptyDocument(), 'body', box(200, 200, 300, 200));
  document = addPart(document, 'head', box(150, 120, 120, 130));
  return addPart(document, 'arm', box(400, 300, 60, 250));
}

/** Checks everything that a scene file demands of pairs of parts. */
function expectSound(document: Document): void {
  const ids = document.parts.map((part) => part.id);
  expect(new Set(ids).size).toBe(ids.length);
  for (const pair of [...document.joins, ...document.relations, ...document.robin]) {
    expect(partIndex(document, pair.lower)).toBeGreaterThanOrEqual(0);
    expect(partIndex(document, pair.upper)).toBeGreaterThan(partIndex(document, pair.lower));
  }
}

describe('drawing parts', () => {
  it('joins an open stroke to what lies under its open side', () => {
    const leg: Point[] = [[300, 380], [300, 500], [340, 500], [340, 380]];
    const document = addOpenPart(figure(), 'leg', leg);
    const join = document.joins[0]!;
    expect(join).toMatchObject({ upper: 'leg', lower: 'body' });
    const outline = document.parts[partIndex(document, 'leg')]!.outline;
    for (const point of join.line) expect(nearestPlace(outline, point).distance).toBeLessThan(1e-9);
  });

  it('leaves an open stroke over nothing as a part of its own', () => {
    const document = addOpenPart(figure(), 'cloud', [[700, 10], [720, 60], [760, 60], [780, 10]]);
    expect(document.joins).toEqual([]);
    expect(document.parts.length).toBe(4);
  });
});

describe('order', () => {
  it('turns joins and relations when their parts change places, and drops those that no longer fit', () => {
    let document = joinParts(figure(), 'head', 'body');
    document = relate(document, 'arm', 'body', 'free');
    document = addRange(document, 'head', [270, 250], [200, 250]);
    expect(document.robin.length).toBe(1);
    const moved = movePart(document, 'body', 2);
    expectSound(moved);
    expect(moved.joins[0]).toMatchObject({ upper: 'body', lower: 'head' });
    expect(moved.relations[0]).toMatchObject({ upper: 'body', lower: 'arm', relation: 'free' });
    expect(moved.robin).toEqual([]);
  });

  it('brings a part before another and never behind where it was', () => {
    const document = bringBefore(figure(), 'body', 'head');
    expect(document.parts.map((part) => part.id)).toEqual(['head', 'body', 'arm']);
    expect(bringBefore(document, 'arm', 'head')).toBe(document);
  });
});

describe('joins', () => {
  it('are found from a line across a root, with their ends on the upper outline', () => {
    const join = joinOfLine(figure(), [[395, 320], [430, 310], [465, 320]], 20)!;
    expect(join).toMatchObject({ upper: 'arm', lower: 'body' });
    const arm = figure().parts[2]!;
    for (const point of join.line) expect(nearestPlace(arm.outline, point).distance).toBeLessThan(1e-9);
    expectSound(addJoin(figure(), join));
  });

  it('run inside the lower part', () => {
    const { parts } = figure();
    for (const point of longestRunInside(parts[1]!, parts[0]!)!)
      expect(contains(parts[0]!.outline, point)).toBe(true);
  });
});

it('finds the parts that overlap one', () => {
  expect(neighbours(figure(), 'body').map((part) => part.id)).toEqual(['arm', 'head']);
  expect(neighbours(figure(), 'head').map((part) => part.id)).toEqual(['body']);
});

it('renames a part everywhere', () => {
  const document = renamePart(joinParts(figure(), 'head', 'body'), 'head', 'skull');
  expectSound(document);
  expect(document.joins[0]?.upper).toBe('skull');
  expect(renamePart(document, 'skull', 'body')).toBe(document);
});

it('measures areas with a sign, positive clockwise on the screen', () => {
  expect(area(box(0, 0, 3, 2))).toBe(6);
  expect(area(box(0, 0, 3, 2).reverse())).toBe(-6);
});

function pushedAnywhere(document: Document, id: string, spot: Point, share: number): Document {
  const part = document.parts[partIndex(document, id)];
  if (!part) return document;
  const next = pushOutline(document, id, nearestPlace(part.outline, spot), 20 + 80 * share, [60 * share - 30, 20 * share]);
  return 'document' in next ? next.document : document;
}

/** Returns a random edit. */
function anyEdit(document: Document, random: () => number): Document {
  const pick = (): string => document.parts[Math.floor(random() * document.parts.length)]?.id ?? '';
  const spot = (): Point => [1000 * random(), 800 * random()];
  const edits = [
    () => addPart(document, 'part', box(...spot(), 50 + 200 * random(), 50 + 200 * random())),
    () => removePart(document, pick()),
    () => movePart(document, pick(), Math.floor(6 * random())),
    () => changePart(document, pick(), { c: 1 + random() }),
    () => changePart(document, pick(), { flat: random() }),
    () => changePart(document, pick(), { lean: [random(), -random()] }),
    () => joinParts(document, pick(), pick()),
    () => relate(document, pick(), pick(), 'equal'),
    () => addRange(document, pick(), spot(), spot()),
    () => renamePart(document, pick(), `name ${Math.floor(9 * random())}`),
    () => changeSettings(document, { rho: random() }),
    () => pushedAnywhere(document, pick(), spot(), random()),
  ];
  return edits[Math.floor(random() * edits.length)]!();
}

describe('history', () => {
  it('undoes to the first bytes and redoes to the last after random edits', () => {
    for (let seed = 1; seed <= 200; seed++) {
      const random = randomNumbers(seed);
      let history = startHistory(figure());
      const first = sceneText(history.document);
      for (let i = 0; i < 60; i++) {
        const chance = random();
        if (chance < 0.15) history = undo(history);
        else if (chance < 0.25) history = redo(history);
        else {
          const next = anyEdit(history.document, random);
          history = record(history, 'edit', next, chance < 0.5 ? 'slider' : null);
        }
        expectSound(history.document);
      }
      while (history.undone.length > 0) history = redo(history);
      const last = sceneText(history.document);
      while (history.done.length > 0) history = undo(history);
      expect(sceneText(history.document)).toBe(first);
      while (history.undone.length > 0) history = redo(history);
      expect(sceneText(history.document)).toBe(last);
    }
  });

  it('merges a gesture into one change and starts another for the next', () => {
    let history = startHistory(figure());
    for (const c of [1, 2, 3]) history = record(history, 'c', changePart(history.document, 'arm', { c }), 'c arm');
    history = record(history, 'c', changePart(history.document, 'head', { c: 1 }), 'c head');
    expect(history.done.length).toBe(2);
    expect(undo(undo(history)).document).toEqual(figure());
  });
});

describe('cues', () => {
  const ridge = { part: 'head', kind: 'crease' as const, line: [[160, 150], [260, 150]] as Point[], value: 40 };
  const hump = { part: 'body', kind: 'bulge' as const, line: [[250, 300], [400, 300]] as Point[], value: 1.5 };
  const cued = (): Document => ({ ...figure(), cues: [ridge, hump] });

  it('are stored in scene files', () => {
    expect(sceneContent(sceneText(cued())).cues).toEqual([ridge, hump]);
    expect(sceneText(figure())).not.toContain('cues');
  });

  it('are removed and renamed with their part', () => {
    expect(removePart(cued(), 'head').cues).toEqual([hump]);
    expect(renamePart(cued(), 'head', 'skull').cues[0]).toEqual({ ...ridge, part: 'skull' });
    expect(shiftPart(cued(), 'head', [5, -3]).cues).toEqual([{ ...ridge, line: [[165, 147], [265, 147]] }, hump]);
    expect(movePart(cued(), 'head', 2).cues).toEqual([ridge, hump]);
  });
});

describe('moving parts', () => {
  it('takes along everything on the outline, and can be reversed', () => {
    let document = joinParts(figure(), 'head', 'body');
    document = addRange(document, 'head', [270, 250], [200, 250]);
    document = { ...document, relations: [{ upper: 'head', lower: 'body', relation: 'equal', range: [[200, 250], [270, 240]] }] };
    const moved = shiftPart(document, 'head', [7, 20]);
    const { outline } = moved.parts[partIndex(moved, 'head')]!;
    const range = moved.robin[0]!;
    for (const point of [...moved.joins[0]!.line, range.from, range.to, ...moved.relations[0]!.range!])
      expect(nearestPlace(outline, point).distance).toBeLessThan(1e-9);
    expectSound(moved);
    expect(shiftPart(moved, 'head', [-7, -20])).toEqual(document);
  });

  it('removes joins whose roots no longer lie in a part', () => {
    const document = joinParts(figure(), 'head', 'body');
    expect(shiftPart(document, 'head', [-150, -110]).joins).toEqual([]);
    expect(shiftPart(document, 'body', [300, 300]).joins).toEqual([]);
  });

  it('is for parts that were drawn by hand', () => {
    const drawing = { name: 'a.svg', kind: 'svg' as const, mime: 'image/svg+xml', bytes: new Uint8Array() };
    const [body, head] = figure().parts;
    const { color: _color, ...found } = body!;
    const document = { ...figure(), drawing, parts: [found, head!] };
    expect([isMovable(document, 'body'), isMovable(document, 'head'), isMovable(document, 'tail')]).toEqual([false, true, false]);
    expect(isMovable({ ...document, drawing: null }, 'body')).toBe(true);
  });
});

it('colours joined parts alike, and no others', () => {
  const body = addPart(emptyDocument(), 'body', [[0, 0], [400, 0], [400, 300], [0, 300]]);
  const leg = addOpenPart(body, 'leg', [[100, 280], [90, 500], [160, 500], [150, 280]]);
  const foot = addOpenPart(leg, 'foot', [[100, 480], [60, 560], [200, 560], [150, 480]]);
  const hat = addPart(foot, 'hat', [[300, -50], [350, -50], [350, 40], [300, 40]]);
  const painted = colorPart(hat, 'leg', '#123456');
  expect(painted.parts.map(({ id, color }) => [id, color === '#123456'])).toEqual([['body', true], ['leg', true], ['foot', true], ['hat', false]]);
  // A limb with its own colour keeps it.
  const own = { ...painted, parts: painted.parts.map((part) => (part.id === 'foot' ? { ...part, color: '#ffffff' } : part)) };
  expect(colorPart(own, 'body', '#654321').parts.map(({ color }) => color)).toEqual(['#654321', '#654321', '#ffffff', hat.parts[3]?.color]);
});
