import { describe, expect, it } from 'vitest';
import { type Document, emptyDocument, type Point } from '../../document/document';
import { addJoin, addPart, addRange, joinParts } from '../../document/editing';
import { hiddenOutline } from '../../document/hidden';
import { area, contains, distance, nearestPlace } from '../../document/outline';
import { grips, pushOutline, redrawOutline, type Reshaped } from '../../document/reshape';
import { randomNumbers } from './random';
import { box } from './shapes';

function circle(x: number, y: number, radius: number): Point[] {
  return Array.from({ length: 96 }, (_, i): Point => {
    const angle = (2 * Math.PI * i) / 96;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** A body and an arm that grows out of it. */
function figure(): Document {
  const body = addPart(emptyDocument(), 'body', circle(400, 400, 150));
  return joinParts(addPart(body, 'arm', box(500, 370, 200, 60)), 'arm', 'body');
}

function must(reshaped: Reshaped): Document {
  if ('refused' in reshaped) throw new Error(reshaped.refused);
  return reshaped.document;
}

function ringOf(document: Document, part: number): readonly Point[] {
  return document.parts[part]?.outline[0] ?? [];
}

describe('pushing an outline', () => {
  const place = nearestPlace([circle(400, 400, 150)], [250, 400]);

  it('moves the place itself all the way, and nothing beyond the radius', () => {
    const pushed = ringOf(must(pushOutline(figure(), 'body', place, 100, [-30, 0])), 0);
    expect(Math.min(...pushed.map((p) => distance(p, [220, 400])))).toBeLessThan(0.1);
    for (const p of circle(400, 400, 150))
      if (150 * Math.acos((400 - p[0]) / 150) > 101) expect(nearestPlace([pushed], p).distance).toBeLessThan(1e-9);
  });

  it('makes no corners: neighbouring sides differ little in direction', () => {
    const ring = ringOf(must(pushOutline(figure(), 'body', place, 100, [-30, 0])), 0);
    ring.forEach((b, i) => {
      const a = ring.at(i - 1) as Point;
      const c = ring[(i + 1) % ring.length] as Point;
      const turn = Math.atan2(c[1] - b[1], c[0] - b[0]) - Math.atan2(b[1] - a[1], b[0] - a[0]);
      expect(Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn)))).toBeLessThan(0.5);
    });
  });

  it('adds points only as far as the shape needs them, however often it is done', () => {
    let document = figure();
    const before = ringOf(document, 0).length;
    for (let i = 0; i < 50; i++) {
      const at = nearestPlace(document.parts[0]!.outline, [250, 400]);
      document = must(pushOutline(document, 'body', at, 100, [i % 2 ? 5 : -5, 0]));
    }
    expect(ringOf(document, 0).length).toBeLessThan(2 * before);
  });

  it('takes joins and ranges along, so that their ends stay on the outline', () => {
    const ranged = addRange(figure(), 'arm', [530, 370], [600, 370]);
    const corner = nearestPlace(ranged.parts[1]!.outline, [500, 400]);
    const { parts, joins, robin } = must(pushOutline(ranged, 'arm', corner, 60, [-40, 0]));
    const outline = parts[1]!.outline;
    for (const p of [...joins[0]!.line, robin[0]!.from, robin[0]!.to])
      expect(nearestPlace(outline, p).distance).toBeLessThan(1e-6);
    const reach = Math.min(...joins[0]!.line.map((p) => p[0]));
    expect(reach).toBeLessThan(462);
    for (const p of joins[0]!.line) expect(contains(parts[0]!.outline, p)).toBe(true);
  });

  it('is refused if the outline would cross itself or vanish', () => {
    const arm = nearestPlace(figure().parts[1]!.outline, [600, 370]);
    expect(pushOutline(figure(), 'arm', arm, 60, [0, 80])).toEqual({ refused: 'crossesItself' });
    const dot = addPart(emptyDocument(), 'dot', box(10, 10, 5, 5));
    const side = nearestPlace(dot.parts[0]!.outline, [10, 12]);
    expect('refused' in pushOutline(dot, 'dot', side, 100, [6, 0])).toBe(true);
  });

  it('keeps every outline valid after random pushes', () => {
    const random = randomNumbers(5);
    let document = figure();
    for (let i = 0; i < 120; i++) {
      const index = random() < 0.5 ? 0 : 1;
      const part = document.parts[index]!;
      const all = grips(part.outline, 40);
      const grip = all[Math.floor(random() * all.length)]!;
      const next = pushOutline(document, part.id, grip, 20 + 100 * random(), [120 * random() - 60, 120 * random() - 60]);
      if ('refused' in next) continue;
      document = next.document;
      expect(area(ringOf(document, index))).toBeGreaterThan(0);
      const { line } = document.joins[0]!;
      for (const p of [line[0]!, line.at(-1)!]) expect(nearestPlace(document.parts[1]!.outline, p).distance).toBeLessThan(0.01);
    }
  });
});

describe('redrawing an outline', () => {
  it('replaces the stretch nearest to the stroke, in either direction', () => {
    const stroke: Point[] = [[600, 370], [640, 300], [680, 370]];
    for (const line of [stroke, [...stroke].reverse()]) {
      const arm = ringOf(must(redrawOutline(figure(), 'arm', line)), 1);
      expect(area(arm)).toBeCloseTo(200 * 60 + (80 * 70) / 2, 6);
      expect(arm).toContainEqual([640, 300]);
    }
  });

  it('cuts a part along a stroke through it, and keeps the larger side', () => {
    const arm = ringOf(must(redrawOutline(figure(), 'arm', [[650, 370], [655, 400], [650, 430]])), 1);
    expect(area(arm)).toBeCloseTo(150 * 60 + 5 * 30, 6);
  });

  it('is refused if the stroke crosses the rest of the outline', () => {
    const stroke: Point[] = [[600, 370], [600, 450], [620, 450], [620, 370]];
    expect(redrawOutline(figure(), 'arm', stroke)).toEqual({ refused: 'crossesItself' });
  });
});

describe('grips', () => {
  it('lie evenly on the outline, at least three on each ring that is long enough', () => {
    const ring = circle(0, 0, 100);
    const all = grips([ring, circle(0, 0, 1)], 50);
    expect(all.length).toBe(13);
    for (const grip of all) expect(nearestPlace([ring], grip.point).distance).toBeLessThan(1e-9);
  });
});

describe('hidden outlines', () => {
  it('are those behind other parts, and none of the foremost part', () => {
    const { parts } = addJoin(figure(), figure().joins[0]!);
    expect(hiddenOutline(parts, 'arm')).toEqual([]);
    const lines = hiddenOutline(parts, 'body');
    expect(lines.length).toBe(1);
    for (const [x, y] of lines[0]!) {
      expect(x).toBeGreaterThan(499);
      expect(Math.abs(y - 400)).toBeLessThan(33);
    }
  });
});
