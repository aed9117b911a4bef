import { type Document, type Join, partIndex, type Point, type Ring } from './document';
import { changePart } from './editing';
import {
  arcsBetween, area, areaOf, distance, distanceTo, mix, nearestPlace, type OutlinePlace, perimeter, pointAt, resample, rounded, simplify, walk,
} from './outline';

/** The reasons why an outline is left unchanged. */
export type Refusal = 'crossesItself' | 'tooSmall' | 'endsOffOutline';

export type Reshaped = { readonly document: Document } | { readonly refused: Refusal };

/** Tolerance of the simplification after a push, px. */
const tolerance = 0.05;
/** Smallest area of a part, px²; less could hardly be seen. */
const leastArea = 16;

/**
 * Returns the weight of a push at an arc length from the hand: cos²(π offset / (2 radius)), from 1 at the hand
 * to 0 at `radius`.
 */
function share(offset: number, radius: number): number {
  return Math.abs(offset) >= radius ? 0 : Math.cos((Math.PI * offset) / (2 * radius)) ** 2;
}

function radiusOn(ring: Ring, radius: number): number {
  return Math.min(radius, 0.4 * perimeter(ring));
}

/**
 * Moves the stretch around arc length `at` by `by`. The first `stretch` points of the result are those of the
 * stretch.
 */
function pushedRing(ring: Ring, at: number, radius: number, by: Point): { ring: Point[]; stretch: number } {
  const from = at - radius;
  const to = at + radius;
  const line = resample([pointAt(ring, from), ...walk(ring, from, to), pointAt(ring, to)], radius / 12);
  let offset = -radius;
  const moved = line.map((p, i): Point => {
    if (i > 0) offset += distance(line[i - 1] as Point, p);
    const t = share(offset, radius);
    return t === 0 ? p : rounded([p[0] + t * by[0], p[1] + t * by[1]], 100);
  });
  const stretch = simplify(moved, tolerance);
  return { ring: [...stretch, ...walk(ring, to, from)], stretch: stretch.length };
}

function cross(a: Point, b: Point, c: Point): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/**
 * Returns whether two segments cross. A point on a line counts as right of it, so a line through a corner
 * crosses only once.
 */
function segmentsCross(a: Point, b: Point, c: Point, d: Point): boolean {
  return cross(a, b, c) > 0 !== cross(a, b, d) > 0 && cross(c, d, a) > 0 !== cross(c, d, b) > 0;
}

/** Counts the crossings of the first `count` sides of a ring with its own sides and those of other rings. */
export function crossings(outline: readonly Ring[], index: number, count: number): number {
  const own = outline[index] as Ring;
  let found = 0;
  for (let i = 0; i < count; i++) {
    const a = own[i] as Point;
    const b = own[(i + 1) % own.length] as Point;
    outline.forEach((ring, k) =>
      ring.forEach((c, j) => {
        const beside = k === index && (j === (i + 1) % own.length || i === (j + 1) % own.length);
        const again = k === index && j < count && j <= i;
        if (!beside && !again && segmentsCross(a, b, c, ring[(j + 1) % ring.length] as Point)) found++;
      }),
    );
  }
  return found;
}

/** Moves a join to a changed outline. Its ends and its middle stay as near as possible to where they were. */
function reseated(join: Join, outline: readonly Ring[], moved: (p: Point) => Point): Join {
  const end = (p: Point | undefined): OutlinePlace => nearestPlace(outline, moved(p as Point));
  const middle = moved(join.line[Math.floor(join.line.length / 2)] as Point);
  const arcs = arcsBetween(outline, end(join.line[0]), end(join.line.at(-1)));
  const gaps = arcs.map((arc) => distanceTo(arc, middle)) as [number, number];
  return { ...join, line: gaps[0] <= gaps[1] ? arcs[0] : arcs[1] };
}

/** Rotates rings to start near their former first points, so that arc lengths along them keep their meaning. */
function withFormerStarts(before: readonly Ring[], outline: readonly Ring[], moved: (p: Point) => Point): Ring[] {
  return outline.map((ring, i) => {
    const old = before[i]?.[0];
    if (!old || ring === before[i]) return ring;
    const gaps = ring.map((p) => distance(p, moved(old)));
    const start = gaps.indexOf(Math.min(...gaps));
    return [...ring.slice(start), ...ring.slice(0, start)];
  });
}

/** Gives a part a new outline and moves everything on it along. `moved` maps old points to new ones. */
function withOutline(document: Document, id: string, outline: readonly Ring[], moved: (p: Point) => Point): Document {
  const former = document.parts[partIndex(document, id)]?.outline ?? [];
  const seat = (p: Point): Point => nearestPlace(outline, moved(p)).point;
  return {
    ...changePart(document, id, { outline: withFormerStarts(former, outline, moved) }),
    joins: document.joins.map((join) => (join.upper === id ? reseated(join, outline, moved) : join)),
    robin: document.robin.map((range) =>
      range.upper === id ? { ...range, from: seat(range.from), to: seat(range.to) } : range,
    ),
    relations: document.relations.map((relation) =>
      relation.upper === id && relation.range
        ? { ...relation, range: [seat(relation.range[0]), seat(relation.range[1])] as const }
        : relation,
    ),
    cues: document.cues.map((cue) => (cue.part === id ? { ...cue, line: cue.line.map(moved) } : cue)),
  };
}

interface NewRing {
  readonly index: number;
  readonly ring: Ring;
  /** Number of new sides at its beginning. */
  readonly changed: number;
}

/** Replaces a ring, unless the outline would cross itself more than before or vanish. */
function replaced(before: readonly Ring[], { index, ring, changed }: NewRing): Ring[] | Refusal {
  const outline = before.map((old, i) => (i === index ? ring : old));
  const old = before[index] as Ring;
  const crosses = crossings(outline, index, changed);
  if (crosses > 0 && crosses > crossings(before, index, old.length)) return 'crossesItself';
  const areas = [areaOf(before), areaOf(outline)] as const;
  if (Math.abs(areas[1]) < leastArea || areas[0] * areas[1] < 0) return 'tooSmall';
  return outline;
}

/** Pushes the outline of a part at one place. The outline follows smoothly within `radius` px along it. */
export function pushOutline(document: Document, id: string, place: OutlinePlace, radius: number, by: Point): Reshaped {
  const part = document.parts[partIndex(document, id)];
  const old = part?.outline[place.ring];
  if (!part || !old || old.length < 3) return { document };
  const reach = radiusOn(old, radius);
  const { ring, stretch } = pushedRing(old, place.at, reach, by);
  const outline = replaced(part.outline, { index: place.ring, ring, changed: stretch });
  if (typeof outline === 'string') return { refused: outline };
  const length = perimeter(old);
  const moved = (p: Point): Point => {
    const near = nearestPlace(part.outline, p);
    const ahead = (((near.at - place.at) % length) + length) % length;
    const t = near.ring === place.ring ? share(Math.min(ahead, length - ahead), reach) : 0;
    return [p[0] + t * by[0], p[1] + t * by[1]];
  };
  return { document: withOutline(document, id, outline, moved) };
}

/** Returns the area between two lines with common ends. */
function areaBetween(line: Ring, other: Ring): number {
  return Math.abs(area([...line, ...[...other].reverse()]));
}

/**
 * Replaces a stretch of an outline by a stroke: of the two stretches between its ends the one that
 * encloses less area with it. The ends of the stroke snap to the outline.
 */
export function redrawOutline(document: Document, id: string, stroke: Ring): Reshaped {
  const part = document.parts[partIndex(document, id)];
  const ends = part && ([nearestPlace(part.outline, stroke[0] as Point), nearestPlace(part.outline, stroke.at(-1) as Point)] as const);
  if (!part || !ends || ends[0].ring !== ends[1].ring) return { document };
  const [from, to] = ends;
  const old = part.outline[from.ring] as Ring;
  const drawn = [from.point, ...stroke.slice(1, -1), to.point];
  const ahead = [from.point, ...walk(old, from.at, to.at), to.point];
  const back = [from.point, ...walk(old, to.at, from.at).reverse(), to.point];
  const replacesAhead = areaBetween(drawn, ahead) <= areaBetween(drawn, back);
  const line = (replacesAhead ? drawn : [...drawn].reverse()).map((p) => rounded(p, 100));
  const rest = replacesAhead ? walk(old, to.at, from.at) : walk(old, from.at, to.at);
  const ring = { index: from.ring, ring: [...line, ...rest], changed: line.length };
  const outline = replaced(part.outline, ring);
  if (typeof outline === 'string') return { refused: outline };
  return { document: withOutline(document, id, outline, (p) => p) };
}

/** Returns places to grip an outline, evenly spaced along each ring. */
export function grips(outline: readonly Ring[], spacing: number): OutlinePlace[] {
  return outline.flatMap((ring, index) => {
    const length = perimeter(ring);
    if (length < 2 * spacing) return [];
    const step = length / Math.max(3, Math.round(length / spacing));
    const places: OutlinePlace[] = [];
    let at = 0;
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] as Point;
      const side = distance(a, b);
      for (let next = places.length * step; next < Math.min(at + side, length - step / 2); next = places.length * step)
        places.push({ ring: index, at: next, point: mix(a, b, (next - at) / side), distance: 0 });
      at += side;
    });
    return places;
  });
}
