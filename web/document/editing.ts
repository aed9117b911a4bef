import {
  type Document,
  freshId,
  type Join,
  type Pair,
  type Part,
  partIndex,
  type Point,
  type RelationKind,
  type Ring,
  type Settings,
} from './document';
import { arcBetween, contains, longestRunInside, mix, nearestPlace, overlap } from './outline';
import { partUnder } from './picking';
import { clearStrokes } from './scribbling';
import { renameLabelled } from './segmentation';

/** The edits of a document. Each takes a document and returns a new one, or the same one if nothing changes. */

/** Matching colours for parts that no drawing shows. */
export const inks = ['#e8a87c', '#85b79d', '#8fb8de', '#e27d8a', '#c3a6d8', '#e3c567', '#7fb7be', '#d9a5b3'];

function freshInk(document: Document): string {
  return inks[document.parts.length % inks.length] as string;
}

function newPart(document: Document, name: string, ring: Ring, color = freshInk(document)): Part {
  return { id: freshId(document, name), outline: [ring], c: 4, d: 1, color };
}

export function addPart(document: Document, name: string, ring: Ring): Document {
  return { ...document, parts: [...document.parts, newPart(document, name, ring)] };
}

/** Adds an open stroke as a part whose open side is joined to the part below, as in Monster Mash. */
export function addOpenPart(document: Document, name: string, stroke: Ring): Document {
  const first = stroke[0] as Point;
  const last = stroke[stroke.length - 1] as Point;
  const lower = partUnder(document, mix(first, last, 0.5), document.parts.length);
  const part = newPart(document, name, stroke, lower?.color);
  const added = { ...document, parts: [...document.parts, part] };
  if (!lower) return added;
  const line = [last, mix(last, first, 0.5), first];
  return { ...added, joins: [...added.joins, { upper: part.id, lower: lower.id, line }] };
}

export function removePart(document: Document, id: string): Document {
  const other = (pair: Pair): boolean => pair.upper !== id && pair.lower !== id;
  const unmarked = document.segmentation ? clearStrokes(document, { part: id }) : document;
  return {
    ...unmarked,
    parts: document.parts.filter((part) => part.id !== id),
    joins: document.joins.filter(other),
    relations: document.relations.filter(other),
    robin: document.robin.filter(other),
    cues: document.cues.filter((cue) => cue.part !== id),
  };
}

/** The values of a part that can be changed. */
export type PartValues = Partial<Pick<Part, 'c' | 'd' | 'flat' | 'lean' | 'outline'>>;

export function changePart(document: Document, id: string, values: PartValues): Document {
  return {
    ...document,
    parts: document.parts.map((part) => (part.id === id ? { ...part, ...values } : part)),
  };
}

/** Colours a part and all parts joined to it that have the same colour as it had. */
export function colorPart(document: Document, id: string, color: string): Document {
  const before = document.parts[partIndex(document, id)]?.color;
  const alike = new Set([id]);
  for (let grown = 0; grown !== alike.size; ) {
    grown = alike.size;
    for (const { upper, lower } of document.joins)
      for (const [from, to] of [[upper, lower], [lower, upper]] as const)
        if (alike.has(from) && document.parts[partIndex(document, to)]?.color === before) alike.add(to);
  }
  return { ...document, parts: document.parts.map((part) => (alike.has(part.id) ? { ...part, color } : part)) };
}

/** Returns whether a part can be moved: only those drawn by hand can, since no drawing shows them. */
export function isMovable(document: Document, id: string): boolean {
  const part = document.parts[partIndex(document, id)];
  return part !== undefined && (part.color !== undefined || document.drawing === null);
}

/** Returns a join for the part behind in which its middle lies now, or nothing if there is none. */
function rejoined(document: Document, join: Join): Join[] {
  const middle = join.line[Math.floor(join.line.length / 2)] as Point;
  const old = document.parts[partIndex(document, join.lower)] as Part;
  const lower = contains(old.outline, middle) ? old : partUnder(document, middle, partIndex(document, join.upper));
  return lower ? [{ ...join, lower: lower.id }] : [];
}

function onePerPair(joins: readonly Join[]): Join[] {
  return joins.filter((join, i) => joins.findIndex(({ upper, lower }) => upper === join.upper && lower === join.lower) === i);
}

/** Moves a part with everything on its outline. Removes joins whose root no longer lies in another part. */
export function shiftPart(document: Document, id: string, [dx, dy]: Point): Document {
  const part = document.parts[partIndex(document, id)];
  if (!part || (dx === 0 && dy === 0)) return document;
  const moved = ([x, y]: Point): Point => [x + dx, y + dy];
  const placed = changePart(document, id, { outline: part.outline.map((ring) => ring.map(moved)) });
  const joins = placed.joins.map((join) => (join.upper === id ? { ...join, line: join.line.map(moved) } : join));
  return {
    ...placed,
    joins: onePerPair(joins.flatMap((join) => (join.upper === id || join.lower === id ? rejoined(placed, join) : [join]))),
    relations: placed.relations.map((relation) =>
      relation.upper === id && relation.range ? { ...relation, range: [moved(relation.range[0]), moved(relation.range[1])] as const } : relation,
    ),
    robin: placed.robin.map((range) => (range.upper === id ? { ...range, from: moved(range.from), to: moved(range.to) } : range)),
    cues: placed.cues.map((cue) => (cue.part === id ? { ...cue, line: cue.line.map(moved) } : cue)),
  };
}

/** Renames a part everywhere. Does nothing if the name is empty or taken. */
export function renamePart(document: Document, id: string, name: string): Document {
  const wanted = name.trim();
  const isTaken = partIndex(document, wanted) >= 0 || document.segmentation?.parts.some((part) => part.id === wanted);
  if (wanted === '' || wanted === id || isTaken) return document;
  const rename = <T extends Pair>(pair: T): T => ({
    ...pair,
    upper: pair.upper === id ? wanted : pair.upper,
    lower: pair.lower === id ? wanted : pair.lower,
  });
  return {
    ...document,
    parts: document.parts.map((part) => (part.id === id ? { ...part, id: wanted } : part)),
    joins: document.joins.map(rename),
    relations: document.relations.map(rename),
    robin: document.robin.map(rename),
    cues: document.cues.map((cue) => (cue.part === id ? { ...cue, part: wanted } : cue)),
    segmentation: document.segmentation && renameLabelled(document.segmentation, id, wanted),
  };
}

/** Turns a join whose parts changed their order, so that it lies on the outline of the new upper part. */
function turnedJoin(document: Document, join: Join): Join | null {
  const upper = document.parts[partIndex(document, join.lower)] as Part;
  const lower = document.parts[partIndex(document, join.upper)] as Part;
  const line = longestRunInside(upper, lower);
  return line && { upper: upper.id, lower: lower.id, line };
}

/**
 * Moves a part to another place in the order, 0 at the back. Joins and relations are turned to match; ranges
 * that no longer fit are removed.
 */
export function movePart(document: Document, id: string, to: number): Document {
  const from = partIndex(document, id);
  const target = Math.max(0, Math.min(document.parts.length - 1, to));
  if (from < 0 || from === target) return document;
  const parts = [...document.parts];
  const [part] = parts.splice(from, 1);
  parts.splice(target, 0, part as Part);
  const moved = { ...document, parts };
  const upright = (pair: Pair): boolean => partIndex(moved, pair.upper) > partIndex(moved, pair.lower);
  return {
    ...moved,
    joins: moved.joins
      .map((join) => (upright(join) ? join : turnedJoin(moved, join)))
      .filter((join) => join !== null),
    relations: moved.relations.map((relation) =>
      upright(relation)
        ? relation
        : { upper: relation.lower, lower: relation.upper, relation: relation.relation },
    ),
    robin: moved.robin.filter(upright),
  };
}

/** Moves `front` just in front of `back`, unless it is in front already. */
export function bringBefore(document: Document, front: string, back: string): Document {
  const from = partIndex(document, front);
  const to = partIndex(document, back);
  return from < 0 || to < 0 || from > to ? document : movePart(document, front, to);
}

/** Returns the nearest overlapping part in front of a part. */
export function nextInFront(document: Document, id: string): Part | undefined {
  const at = partIndex(document, id);
  return neighbours(document, id).reverse().find((other) => partIndex(document, other.id) > at);
}

/** Returns two parts as a pair in the order of the document. */
export function ordered(document: Document, a: string, b: string): Pair {
  return partIndex(document, a) > partIndex(document, b) ? { upper: a, lower: b } : { upper: b, lower: a };
}

/** Returns the join meant by a line across the root of a part, or null. `reach` is how far its ends may miss, px. */
export function joinOfLine(document: Document, line: Ring, reach: number): Join | null {
  const first = line[0] as Point;
  const last = line[line.length - 1] as Point;
  let best: Join | null = null;
  let least = 2 * reach;
  document.parts.forEach((upper, index) => {
    const ends = [nearestPlace(upper.outline, first), nearestPlace(upper.outline, last)] as const;
    const cost = ends[0].distance + ends[1].distance;
    if (cost >= least) return;
    const arc = arcBetween(upper.outline, ends[0], ends[1]);
    const middle = arc[Math.floor(arc.length / 2)] as Point;
    const lower = partUnder(document, middle, index);
    if (!lower) return;
    least = cost;
    best = { upper: upper.id, lower: lower.id, line: arc };
  });
  return best;
}

export function addJoin(document: Document, join: Join): Document {
  const others = document.joins.filter((old) => old.upper !== join.upper || old.lower !== join.lower);
  return { ...document, joins: [...others, join] };
}

/** Joins two overlapping parts along the longest stretch of the upper outline inside the lower part. */
export function joinParts(document: Document, a: string, b: string): Document {
  if (a === b) return document;
  const pair = ordered(document, a, b);
  const upper = document.parts[partIndex(document, pair.upper)];
  const lower = document.parts[partIndex(document, pair.lower)];
  const line = upper && lower && longestRunInside(upper, lower);
  return line ? addJoin(document, { ...pair, line }) : document;
}

export function removeJoin(document: Document, upper: string, lower: string): Document {
  return {
    ...document,
    joins: document.joins.filter((join) => join.upper !== upper || join.lower !== lower),
  };
}

/** Joins two parts, or separates them if they are joined. */
export function toggleJoin(document: Document, a: string, b: string): Document {
  const { upper, lower } = ordered(document, a, b);
  const joined = document.joins.some((join) => join.upper === upper && join.lower === lower);
  return joined ? removeJoin(document, upper, lower) : joinParts(document, a, b);
}

/** Sets the relation of two parts along their whole contact; null is the default. */
export function relate(document: Document, a: string, b: string, kind: RelationKind | null): Document {
  if (a === b) return document;
  const pair = ordered(document, a, b);
  const others = document.relations.filter(
    (old) => old.upper !== pair.upper || old.lower !== pair.lower || old.range !== undefined,
  );
  return { ...document, relations: kind ? [...others, { ...pair, relation: kind }] : others };
}

/** Adds a soft range: the upper outline is soft at `from` and firm at `to`. */
export function addRange(document: Document, upperId: string, from: Point, to: Point): Document {
  const index = partIndex(document, upperId);
  const upper = document.parts[index];
  if (!upper) return document;
  const ends = [nearestPlace(upper.outline, from), nearestPlace(upper.outline, to)] as const;
  const arc = arcBetween(upper.outline, ends[0], ends[1]);
  const lower =
    partUnder(document, arc[Math.floor(arc.length / 2)] as Point, index) ??
    partUnder(document, ends[0].point, index);
  if (!lower) return document;
  const range = { upper: upperId, lower: lower.id, from: ends[0].point, to: ends[1].point };
  return { ...document, robin: [...document.robin, range] };
}

export function removeRanges(document: Document, upper: string, lower: string): Document {
  return {
    ...document,
    robin: document.robin.filter((range) => range.upper !== upper || range.lower !== lower),
  };
}

export function changeSettings(document: Document, values: Partial<Settings>): Document {
  return { ...document, settings: { ...document.settings, ...values } };
}

/** Returns the parts that overlap a part, foremost first. */
export function neighbours(document: Document, id: string): Part[] {
  const part = document.parts[partIndex(document, id)];
  if (!part) return [];
  return document.parts.filter((other) => other.id !== id && overlap(part, other)).reverse();
}
