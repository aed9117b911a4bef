import type { Document, Join, Part, Point, Ring } from './document';
import { boxOf, contains, distanceTo, longestRunInside, perimeter, pointAt } from './outline';

/** Number of sampled points of an outline. */
const samples = 96;
/** Smallest and largest share of an outline that is a root. Less is a touch, more is an eye or a spot. */
const leastRoot = 0.08;
const mostRoot = 0.6;

/** Suggestions found so far; documents never change. */
const found = new WeakMap<Document, readonly Join[]>();

function boxesMeet(a: Part, b: Part): boolean {
  const [p, q] = [boxOf(a.outline), boxOf(b.outline)];
  return ([0, 1] as const).every((k) => p.max[k] >= q.min[k] && q.max[k] >= p.min[k]);
}

/** Returns the share of a ring inside a part if it is one stretch, else 0. */
function rootShare(ring: Ring, lower: Part): number {
  const length = perimeter(ring);
  const inside = Array.from({ length: samples }, (_, i) => contains(lower.outline, pointAt(ring, (i * length) / samples)));
  const starts = inside.filter((now, i) => now && !inside.at(i - 1)).length;
  return starts === 1 ? inside.filter(Boolean).length / samples : 0;
}

/** Returns the part behind that contains most of a root, or null. */
function lowerOf(upper: Part, behind: readonly Part[]): Part | null {
  const [outer] = upper.outline;
  if (!outer || upper.outline.length > 1) return null;
  const shares = behind.map((lower) => (boxesMeet(upper, lower) ? rootShare(outer, lower) : 0));
  const best = Math.max(0, ...shares);
  return best >= leastRoot && best <= mostRoot ? (behind[shares.lastIndexOf(best)] as Part) : null;
}

function findJoins({ parts, joins, relations }: Document): Join[] {
  return parts.flatMap((upper, index) => {
    if (joins.some((join) => join.upper === upper.id)) return [];
    const lower = lowerOf(upper, parts.slice(0, index));
    const settled = relations.some((relation) => relation.upper === upper.id && relation.lower === lower?.id);
    const line = lower && !settled ? longestRunInside(upper, lower) : null;
    return lower && line ? [{ upper: upper.id, lower: lower.id, line }] : [];
  });
}

/**
 * Suggests joins: for parts without a join or relation whose outline dips into another part exactly
 * once, as the root of a limb does.
 */
export function suggestedJoins(document: Document): readonly Join[] {
  const joins = found.get(document) ?? findJoins(document);
  found.set(document, joins);
  return joins;
}

/** Returns the nearest join whose line passes within `reach` px of a point, or null. */
export function joinAt(joins: readonly Join[], point: Point, reach: number): Join | null {
  const gap = (join: Join): number => distanceTo(join.line, point);
  const near = joins.filter((join) => gap(join) < reach);
  return near.sort((a, b) => gap(a) - gap(b))[0] ?? null;
}
