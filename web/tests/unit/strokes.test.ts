import { describe, expect, it } from 'vitest';
import { emptyDocument, type Document, type Point, type Ring } from '../../document/document';
import { addPart } from '../../document/editing';
import { area, contains } from '../../document/outline';
import { crossings } from '../../document/reshape';
import { drawStroke, type Hand } from '../../document/strokes';
import { randomNumbers } from './random';

const hand: Hand = { reach: 20, name: 'part', behind: false };

function oval(x: number, y: number, rx: number, ry = rx): Point[] {
  return Array.from({ length: 41 }, (_, i): Point => [x + rx * Math.cos((i * Math.PI) / 20), y + ry * Math.sin((i * Math.PI) / 20)]);
}

function line(from: Point, to: Point): Point[] {
  return Array.from({ length: 30 }, (_, i): Point => [from[0] + ((to[0] - from[0]) * i) / 29, from[1] + ((to[1] - from[1]) * i) / 29]);
}

const page = addPart(emptyDocument(), 'body', oval(500, 400, 200, 150).slice(0, -1));

function drawn(stroke: Ring, on: Document = page, how: Partial<Hand> = {}) {
  const result = drawStroke(on, { ...hand, ...how }, stroke);
  if ('refused' in result) throw new Error(result.refused);
  const part = result.document.parts.find(({ id }) => id === result.id);
  if (!part) throw new Error('no part');
  return { ...result, part, joins: result.document.joins.filter((join) => join.upper === result.id) };
}

describe('a stroke', () => {
  it('that is closed and small is a detail of the part below, as a tap is', () => {
    const eye = drawn(oval(450, 350, 6));
    expect(eye.part.color).not.toBe(drawn(oval(450, 350, 90)).part.color);
    expect(Math.abs(area(eye.part.outline[0] as Ring))).toBeGreaterThan(0.6 * Math.PI * 36);
    const dot = drawn([[450, 350]]);
    expect(contains(dot.part.outline, [450, 350])).toBe(true);
    expect(drawStroke(page, hand, [[20, 20]])).toEqual({ refused: 'dotOnPaper' });
  });

  it('that crosses itself becomes everything that it encloses', () => {
    const eight = Array.from({ length: 80 }, (_, i): Point => [500 + 90 * Math.sin((i * Math.PI) / 40), 90 + 60 * Math.sin((i * Math.PI) / 20)]);
    const { part } = drawn([...eight, eight[0] as Point], emptyDocument());
    expect(part.outline.length).toBe(1);
    for (const x of [440, 560]) expect(contains(part.outline, [x, 90])).toBe(true);
    const twice = [...oval(300, 300, 80), ...oval(340, 300, 80)];
    const both = drawn(twice, emptyDocument()).part.outline;
    for (const x of [230, 320, 400]) expect(contains(both, [x, 300])).toBe(true);
  });

  it('that encloses nothing is a tube, joined to the part that it grows out of', () => {
    const tail = drawn(line([650, 400], [850, 330]));
    expect(tail.joins.map(({ lower }) => lower)).toEqual(['body']);
    expect(contains(tail.part.outline, [750, 365])).toBe(true);
    expect(drawn(line([50, 60], [300, 60])).joins).toEqual([]);
    const zigzag = Array.from({ length: 9 }, (_, i): Point => [60 + 40 * i, i % 2 ? 60 : 140]);
    expect(contains(drawn(zigzag).part.outline, [80, 100])).toBe(true);
    const mouth = drawn(line([450, 430], [530, 435]));
    expect(mouth.joins).toEqual([]);
    expect(Math.abs(area(mouth.part.outline[0] as Ring))).toBeLessThan(80 * 20);
  });

  it('that ends just before a part is extended into it and joined', () => {
    const leg: Point[] = [[450, 555], [445, 620], [440, 690], [470, 710], [500, 690], [505, 620], [510, 560]];
    const below: Point[] = leg.map(([x, y]) => [x, y + 12]);
    expect(drawn(leg).joins.map(({ lower }) => lower)).toEqual(['body']);
    expect(drawn(below).joins.map(({ lower }) => lower)).toEqual(['body']);
  });

  it('lies behind all others if asked', () => {
    const { document, id } = drawn(oval(700, 400, 90), page, { behind: true });
    expect(document.parts[0]?.id).toBe(id);
  });
});

it('becomes a part whose outline does not cross itself, for random strokes', () => {
  const random = randomNumbers(11);
  const between = (least: number, most: number): number => least + (most - least) * random();
  const shapes: (() => Point[])[] = [
    () => oval(between(0, 1000), between(0, 800), between(1, 200), between(1, 200)),
    () => line([between(0, 1000), between(0, 800)], [between(0, 1000), between(0, 800)]),
    () => Array.from({ length: Math.ceil(between(2, 30)) }, (): Point => [between(100, 900), between(100, 700)]),
    () => Array.from({ length: 60 }, (_, i): Point => [500 + 3 * i * Math.cos(i / 5), 400 + 3 * i * Math.sin(i / 5)]),
    () => Array.from({ length: 12 }, (_, i): Point => [300 + i * between(5, 30), i % 2 ? 300 : between(300, 360)]),
    () => [[between(0, 1000), between(0, 800)]],
    () => {
      let at: Point = [between(200, 800), between(200, 600)];
      return Array.from({ length: 50 }, () => (at = [at[0] + between(-25, 25), at[1] + between(-25, 25)]));
    },
  ];
  for (let i = 0; i < 300; i++) {
    const stroke = (shapes[i % shapes.length] as () => Point[])();
    const result = drawStroke(page, { ...hand, reach: between(4, 40) }, stroke);
    if ('refused' in result) {
      expect(stroke.length).toBe(1);
      continue;
    }
    const part = result.document.parts.find(({ id }) => id === result.id);
    const ring = part?.outline[0] as Ring;
    expect(part?.outline.length).toBe(1);
    expect(Math.abs(area(ring)), String(i)).toBeGreaterThan(1);
    expect(crossings([ring], 0, ring.length), String(i)).toBe(0);
  }
});
