import type { Document, Point, Ring } from './document';
import { area, distance, distanceTo, lengthOf, mix, rounded } from './outline';
import { addStroke, scribblesOf, segmentationOf, strokesNear, withScribbles } from './scribbling';
import type { Stroke } from './segmentation';

/**
 * A closed gap in the lines of a flat drawing. `left` and `right` are the labels on its sides as seen along
 * it; 0 is background.
 */
export interface Gap {
  readonly points: Ring;
  readonly left: number;
  readonly right: number;
}

/** One side of a gap: a part by its id, the background, or unknown. */
type Side = { part: string } | 'background' | 'unknown';

function sideOf(document: Document, label: number): Side {
  if (label === 0) return 'background';
  const found = segmentationOf(document).parts.find((part) => part.label === label);
  return found ? { part: found.id } : 'unknown';
}

/** A coordinate system at the middle of a gap: `at` takes px along the gap and px to its right. */
interface Crossing {
  readonly length: number;
  readonly along: Point;
  at(along: number, right: number): Point;
}

function crossingOf({ points }: Gap): Crossing {
  const [first, last] = [points[0] as Point, points[points.length - 1] as Point];
  const half = lengthOf(points) / 2;
  let middle = mix(first, last, 0.5);
  let walked = 0;
  points.forEach((point, i) => {
    const before = points[i - 1];
    if (!before) return;
    const step = distance(before, point);
    if (walked <= half && half <= walked + step && step > 0) middle = mix(before, point, (half - walked) / step);
    walked += step;
  });
  const chord = Math.max(1e-6, distance(first, last));
  const along: Point = [(last[0] - first[0]) / chord, (last[1] - first[1]) / chord];
  return {
    length: 2 * half,
    along,
    at: (s, right) => [middle[0] + s * along[0] - right * along[1], middle[1] + s * along[1] + right * along[0]],
  };
}

/** Returns the distance from a gap at which its strokes are placed, px. */
function beside({ length }: Crossing): number {
  return Math.min(12, Math.max(3, 0.35 * length));
}

function strokeFor(side: Side, width: number, points: readonly Point[]): Stroke | null {
  if (side === 'unknown') return null;
  const line = points.map((p) => rounded(p, 10));
  return side === 'background' ? { kind: 'outside', width, points: line } : { kind: 'hard', part: side.part, width, points: line };
}

/** Returns whether strokes on both sides already keep a gap closed. */
function isKept(document: Document, gap: Gap): boolean {
  const crossing = crossingOf(gap);
  const reach = 0.6 * beside(crossing);
  return ([[gap.left, -1], [gap.right, 1]] as const).every(([label, way]) => {
    const side = sideOf(document, label);
    return strokesNear(scribblesOf(document), crossing.at(0, way * beside(crossing)), reach).some((stroke) =>
      typeof side === 'object' ? stroke.part === side.part : stroke.kind === 'outside' || stroke.kind === 'hole',
    );
  });
}

/** Returns the gaps that the user has not decided. */
export function openQuestions(document: Document, gaps: readonly Gap[]): readonly Gap[] {
  return gaps.filter((gap) => [gap.left, gap.right].every((label) => sideOf(document, label) !== 'unknown') && !isKept(document, gap));
}

/** Keeps a gap closed by adding a stroke on each of its sides. */
export function keepGap(document: Document, gap: Gap): Document {
  const crossing = crossingOf(gap);
  const [off, half] = [beside(crossing), crossing.length / 4];
  const strokes = ([[gap.left, -1], [gap.right, 1]] as const).map(([label, way]) =>
    strokeFor(sideOf(document, label), Math.min(3, off), [crossing.at(-half, way * off), crossing.at(half, way * off)]),
  );
  return strokes.reduce((next, stroke) => (stroke ? addStroke(next, stroke) : next), document);
}

function sizeOf(document: Document, id: string): number {
  const [ring] = document.parts.find((part) => part.id === id)?.outline ?? [];
  return ring ? Math.abs(area(ring)) : 0;
}

/** Gives the strokes of one part to another. */
function handOver(document: Document, from: string, to: string): Document {
  const { strokes } = scribblesOf(document);
  return withScribbles(document, strokes.map((stroke) => (stroke.part === from ? { ...stroke, part: to } : stroke)));
}

/**
 * Opens a gap by a stroke across it, which unites its two sides. If one side is background, so is the
 * other. Of two parts the one with strokes remains, or else the larger one.
 */
export function openGap(document: Document, gap: Gap): Document {
  const sides = [sideOf(document, gap.left), sideOf(document, gap.right)];
  const crossing = crossingOf(gap);
  const half = Math.min(20, Math.max(5, 0.6 * crossing.length));
  const across = [crossing.at(0, -half), crossing.at(0, half)];
  const width = Math.min(6, Math.max(2, crossing.length / 3));
  const parts = sides.flatMap((side) => (typeof side === 'object' ? [side.part] : []));
  const [a, b] = parts;
  if (sides.includes('unknown') || a === undefined) return document;
  if (b === undefined) return addStroke(document, strokeFor('background', width, across) as Stroke);
  const { strokes } = scribblesOf(document);
  const weight = (id: string): number => (strokes.some((stroke) => stroke.part === id) ? 1e12 : 0) + sizeOf(document, id);
  const [stays, goes] = weight(a) >= weight(b) ? [a, b] : [b, a];
  return addStroke(handOver(document, goes, stays), strokeFor({ part: stays }, width, across) as Stroke);
}

/** Returns the nearest gap within `reach` px of a point. */
export function gapAt(gaps: readonly Gap[], point: Point, reach: number): Gap | undefined {
  const off = ({ points }: Gap): number => distanceTo(points, point);
  return gaps.filter((gap) => off(gap) < reach).sort((p, q) => off(p) - off(q))[0];
}

/** Finds a gap again in a new list by its middle, or returns undefined. */
export function sameGap(gaps: readonly Gap[], gap: Gap | null): Gap | undefined {
  const middle = gap && crossingOf(gap).at(0, 0);
  return middle ? gaps.find((other) => distance(crossingOf(other).at(0, 0), middle) < 4) : undefined;
}
