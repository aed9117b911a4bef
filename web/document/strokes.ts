import { type Document, type Part, type Point, type Ring } from './document';
import { addOpenPart, addPart, changePart, joinParts, movePart } from './editing';
import { area, areaOf, contains, distance, lengthOf, mix, nearestPlace, oval, perimeter, simplify, smooth } from './outline';
import { partAt } from './picking';
import { around, largest, unionOf } from './regions';

/** Why a stroke became nothing. */
export type StrokeRefusal = 'dotOnPaper';

/** How a stroke is meant. */
export interface Hand {
  /** How far a hand may miss, px. */
  readonly reach: number;
  /** Of the part that it makes. */
  readonly name: string;
  /** Whether that lies behind all others. */
  readonly behind: boolean;
}

export type Drawn = { readonly document: Document; readonly id: string } | { readonly refused: StrokeRefusal };

/** Ends so near to each other, as a share of the stroke's length, are one. */
const closing = 0.05;
/** Thinner than so many reaches on average, a stroke encloses nothing: it is a line. */
const leastThickness = 0.5;
/** Limbs may be as thin as this, and their ends as near to each other, in reaches. */
const limbThickness = 0.2;
const limbGap = 0.35;
/** Half the width of lines, in reaches: as parts, on a part. */
const tubeRadius = 0.8;
const lineRadius = 0.3;
/** Half the width of a dot, in reaches. */
const dotRadius = 0.55;
/** A shape on one part that takes less than this of it is a detail, as eyes are. */
const detailShare = 0.06;
/** Ends so many reaches from an outline reach into it. */
const snapping = 1.5;
export const detailInk = '#37322c';

/** Whether a stroke goes out from a part and comes back to it. */
function isLimb({ parts }: Document, stroke: Ring): boolean {
  const [first, last] = [stroke[0] as Point, stroke.at(-1) as Point];
  const root = [...parts].reverse().find(({ outline }) => contains(outline, first) && contains(outline, last));
  return root !== undefined && stroke.filter((p) => !contains(root.outline, p)).length > stroke.length / 2;
}

/** Whether the ends of a stroke meet: those of a limb must touch. */
export function isClosed(document: Document, stroke: Ring, reach: number): boolean {
  const length = lengthOf(stroke);
  const gap = distance(stroke[0] as Point, stroke.at(-1) as Point);
  if (isLimb(document, stroke)) return gap < limbGap * reach;
  return gap < Math.max(Math.min(1.5 * reach, 0.3 * length), closing * length);
}

/** All that a closed line goes around, whether or not it crosses itself. */
function outerUnion(ring: Ring, reach: number): Point[] {
  const pieces = unionOf([ring]);
  if (pieces.length <= 1) return largest(pieces);
  // The line itself holds together what it touches in a point only.
  const line = around([...ring, ring[0] as Point], reach / 6);
  const upright = (piece: Ring): Ring => (area(piece) < 0 ? [...piece].reverse() : piece);
  return largest(unionOf([...pieces, ...line].map(upright)));
}

/** The part in which all of a ring lies, if it is seen there. */
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

/** What a stroke that is still being drawn would make if the pen came back now; null while that is nothing to see. */
export function previewStroke(document: Document, hand: Hand, points: Ring): Document | null {
  const { reach } = hand;
  const [first] = points as [Point, ...Point[]];
  if (points.length < 4 || Math.abs(area(points)) < leastThickness * reach * lengthOf(points)) return null;
  const drawn = drawStroke(document, hand, partAt(document, first) ? points : [...points, first]);
  return 'refused' in drawn ? null : drawn.document;
}

/** A closed shape: a part, or a detail of the part on which it lies. */
function addShape(document: Document, name: string, ring: Ring): Document {
  const ground = groundOf(document, ring);
  const isDetail = ground && Math.abs(area(ring)) <= detailShare * Math.abs(areaOf(ground.outline));
  return isDetail ? addDetail(document, name, ring, detailInk) : addPart(document, name, ring);
}

/** A line with a width: a detail where it lies on one part, else a tube, joined to the part that it begins or ends on. */
function addTube(document: Document, { name, reach }: Hand, line: Ring): Document {
  if (groundOf(document, line)) return addDetail(document, name, largest(around(line, lineRadius * reach)), detailInk);
  const root = partAt(document, line[0] as Point) ?? partAt(document, line.at(-1) as Point);
  const added = addPart(document, name, largest(around(line, tubeRadius * reach)));
  const id = newest(added);
  return root ? joinParts(colored(added, id, root.color ?? '#d9d4c7'), id, root.id) : added;
}

/** An end that stops just before a part goes on into it. */
function snapped(document: Document, end: Point, reach: number): Point[] {
  if (partAt(document, end)) return [];
  const places = document.parts.map((part) => nearestPlace(part.outline, end));
  const [place] = places.sort((a, b) => a.distance - b.distance);
  if (!place || place.distance === 0 || place.distance > snapping * reach) return [];
  return [mix(end, place.point, 1 + (0.7 * reach) / place.distance)];
}

/** Whether what a ring goes around is another area than its own, in which loops count by their turns. */
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

/** A tap: a small round detail of the part below. */
function addDot(document: Document, { name, reach }: Hand, [x, y]: Point): Drawn {
  if (!partAt(document, [x, y])) return { refused: 'dotOnPaper' };
  const added = addShape(document, name, oval([x, y], [dotRadius * reach, dotRadius * reach], 24));
  return { document: added, id: newest(added) };
}

/**
 * What a stroke makes: a part of a closed one, also where it crosses itself; a limb of an open one
 * that goes out from a part and comes back; a tube of a line; a detail of what is small and lies on
 * a part. Nothing only of a tap beside all parts.
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
