import { type Document, type Part, type Point, type Ring } from './document';
import { addOpenPart, addPart, changePart, joinParts, movePart } from './editing';
import { area, areaOf, contains, distance, lengthOf, mix, nearestPlace, oval, perimeter, simplify, smooth } from './outline';
import { partAt } from './picking';
import { around, largest, unionOf } from './regions';

/** The reasons why a stroke makes nothing. */
export type StrokeRefusal = 'dotOnPaper';

/** How a stroke is to be read. */
export interface Hand {
  /** How far a hand may miss, px. */
  readonly reach: number;
  /** Name of the part that the stroke makes. */
  readonly name: string;
  /** Whether that part lies behind all others. */
  readonly behind: boolean;
}

export type Drawn = { readonly document: Document; readonly id: string } | { readonly refused: StrokeRefusal };

/** A stroke is closed if its ends are nearer than this share of its length. */
const closing = 0.05;
/** A stroke with a smaller average thickness, in reaches, encloses nothing and is a line. */
const leastThickness = 0.5;
/** Smallest thickness of a limb, and largest distance of its ends when it is closed, in reaches. */
const limbThickness = 0.2;
const limbGap = 0.35;
/** Half the width of lines, in reaches: of a tube, and of a line on a part. */
const tubeRadius = 0.8;
const lineRadius = 0.3;
/** Half the width of a dot, in reaches. */
const dotRadius = 0.55;
/** A shape within one part is a detail, such as an eye, if it covers at most this share of it. */
const detailShare = 0.06;
/** Ends of strokes this near to an outline, in reaches, are extended into the part. */
const snapping = 1.5;
export const detailInk = '#37322c';

/** Returns whether a stroke leaves a part and comes back to it. */
function isLimb({ parts }: Document, stroke: Ring): boolean {
  const [first, last] = [stroke[0] as Point, stroke.at(-1) as Point];
  const root = [...parts].reverse().find(({ outline }) => contains(outline, first) && contains(outline, last));
  return root !== undefined && stroke.filter((p) => !contains(root.outline, p)).length > stroke.length / 2;
}

/** Returns whether the ends of a stroke meet. Those of a limb must nearly touch. */
export function isClosed(document: Document, stroke: Ring, reach: number): boolean {
  const length = lengthOf(stroke);
  const gap = distance(stroke[0] as Point, stroke.at(-1) as Point);
  if (isLimb(document, stroke)) return gap < limbGap * reach;
  return gap < Math.max(Math.min(1.5 * reach, 0.3 * length), closing * length);
}

/** Returns the outer ring around everything that a closed line encloses, even if it crosses itself. */
function outerUnion(ring: Ring, reach: number): Point[] {
  const pieces = unionOf([ring]);
  if (pieces.length <= 1) return largest(pieces);
  // Adds the line itself, which connects pieces that touch in a point only.
  const line = around([...ring, ring[0] as Point], reach / 6);
  const upright = (piece: Ring): Ring => (area(piece) < 0 ? [...piece].reverse() : piece);
  return largest(unionOf([...pieces, ...line].map(upright)));
}

/** Returns the part that contains all of a ring, if that part is visible at its first point. */
function groundOf(document: Document, ring: Ring): Part | undefined {
  const [first] = ring;
  const part = first && partAt(document, first);
  return part && ring.every((p) => contains(part.outline, p)) ? part : undefined;
}

function newest(document: Document): string {
  return document.parts.at(-1)?.id ?? '';
}

/** Adds a small mark such as an eye: a flatter part of its own colour. */
export function addDetail(document: Document, name: string, ring: Ring, color: string): Document {
  const added = addPart(document, name, ring);
  const id = newest(added);
  return changePart(colored(added, id, color), id, { c: 2 });
}

function colored(document: Document, id: string, color: string): Document {
  return { ...document, parts: document.parts.map((part) => (part.id === id ? { ...part, color } : part)) };
}

/** Returns what a stroke in progress would make if the pen came back now, or null if that would be too thin to see. */
export function previewStroke(document: Document, hand: Hand, points: Ring): Document | null {
  const { reach } = hand;
  const [first] = points as [Point, ...Point[]];
  if (points.length < 4 || Math.abs(area(points)) < leastThickness * reach * lengthOf(points)) return null;
  const drawn = drawStroke(document, hand, partAt(document, first) ? points : [...points, first]);
  return 'refused' in drawn ? null : drawn.document;
}

/** Adds a closed shape as a part, or as a detail of the part on which it lies. */
function addShape(document: Document, name: string, ring: Ring): Document {
  const ground = groundOf(document, ring);
  const isDetail = ground && Math.abs(area(ring)) <= detailShare * Math.abs(areaOf(ground.outline));
  return isDetail ? addDetail(document, name, ring, detailInk) : addPart(document, name, ring);
}

/** Adds a line: a detail if it lies on one part, else a tube that is joined to the part where it begins or ends. */
function addTube(document: Document, { name, reach }: Hand, line: Ring): Document {
  if (groundOf(document, line)) return addDetail(document, name, largest(around(line, lineRadius * reach)), detailInk);
  const root = partAt(document, line[0] as Point) ?? partAt(document, line.at(-1) as Point);
  const added = addPart(document, name, largest(around(line, tubeRadius * reach)));
  const id = newest(added);
  return root ? joinParts(colored(added, id, root.color ?? '#d9d4c7'), id, root.id) : added;
}

/** Returns the extension of an end that stops just before a part. */
function snapped(document: Document, end: Point, reach: number): Point[] {
  if (partAt(document, end)) return [];
  const places = document.parts.map((part) => nearestPlace(part.outline, end));
  const [place] = places.sort((a, b) => a.distance - b.distance);
  if (!place || place.distance === 0 || place.distance > snapping * reach) return [];
  return [mix(end, place.point, 1 + (0.7 * reach) / place.distance)];
}

/**
 * Returns whether a ring crosses itself: then the area that it encloses differs from its signed area, in which
 * loops count by their turns.
 */
function crossesItself(ring: Ring): boolean {
  const pieces = unionOf([ring]);
  const own = Math.abs(area(ring));
  return pieces.length !== 1 || Math.abs(Math.abs(area(largest(pieces))) - own) > 0.002 * own;
}

function addOpen(document: Document, hand: Hand, stroke: Ring): Document {
  const { reach, name } = hand;
  const [first, last] = [stroke[0] as Point, stroke.at(-1) as Point];
  const line = [...snapped(document, first, reach), ...stroke, ...snapped(document, last, reach)];
  const thickness = Math.abs(area(line)) / lengthOf(line);
  if (thickness < (isLimb(document, line) ? limbThickness : leastThickness) * reach) return addTube(document, hand, line);
  const rounded = smooth(line, false);
  return crossesItself(rounded) ? addShape(document, name, outerUnion(rounded, reach)) : addOpenPart(document, name, rounded);
}

function addClosed(document: Document, hand: Hand, stroke: Ring): Document {
  const { reach, name } = hand;
  const drawn = smooth(stroke, true);
  const ring = crossesItself(drawn) ? simplify(outerUnion(drawn, reach), 0.05 * reach) : drawn;
  const small = reach * leastThickness * 0.3;
  const thickness = ring.length > 2 ? Math.abs(area(ring)) / perimeter(ring) : 0;
  return thickness < small ? addTube(document, hand, stroke) : addShape(document, name, ring);
}

/** Adds a small round detail to the part below a tap. */
function addDot(document: Document, { name, reach }: Hand, [x, y]: Point): Drawn {
  if (!partAt(document, [x, y])) return { refused: 'dotOnPaper' };
  const added = addShape(document, name, oval([x, y], [dotRadius * reach, dotRadius * reach], 24));
  return { document: added, id: newest(added) };
}

/**
 * Makes a part of a stroke. A closed stroke, even one that crosses itself, becomes a part; an open one
 * that leaves a part and comes back becomes a limb; a line becomes a tube; a small shape on a part
 * becomes a detail. Only a tap outside all parts is refused.
 */
export function drawStroke(document: Document, hand: Hand, points: Ring): Drawn {
  const { reach } = hand;
  const [first] = points as [Point, ...Point[]];
  if (points.every((p) => distance(p, first) < reach / 3)) return addDot(document, hand, first);
  const closed = isClosed(document, points, reach);
  const stroke = simplify(closed ? points.slice(0, -1) : points, reach / 10);
  const added = closed ? addClosed(document, hand, stroke) : addOpen(document, hand, stroke);
  const id = newest(added);
  return { document: hand.behind ? movePart(added, id, 0) : added, id };
}
