import type { Document, Pair, Point, RelationKind } from './document';
import { relate } from './editing';
import { contains, nearestPlace } from './outline';

/** The relations in the order in which taps cycle through them; null is the default. */
const kinds: readonly (RelationKind | null)[] = [null, 'free', 'equal', 'joined', 'above'];

/**
 * Returns the pair whose upper outline passes within `reach` px of a point inside the lower part, or null.
 * Skips joined pairs.
 */
export function pairAt({ parts, joins }: Document, point: Point, reach: number): Pair | null {
  const pairs = parts.flatMap((upper, index) => {
    const place = nearestPlace(upper.outline, point);
    const lower = parts.slice(0, index).reverse().find((part) => contains(part.outline, place.point));
    const joined = joins.some((join) => join.upper === upper.id && join.lower === lower?.id);
    return lower && !joined && place.distance < reach ? [{ upper: upper.id, lower: lower.id, distance: place.distance }] : [];
  });
  const [nearest] = pairs.sort((a, b) => a.distance - b.distance);
  return nearest ? { upper: nearest.upper, lower: nearest.lower } : null;
}

/** Returns the relation of a pair along its whole contact; null is the default. */
export function relationOf({ relations }: Document, { upper, lower }: Pair): RelationKind | null {
  return relations.find((entry) => entry.upper === upper && entry.lower === lower && !entry.range)?.relation ?? null;
}

/** Switches a pair to its next relation. */
export function turnRelation(document: Document, pair: Pair): Document {
  const next = kinds[(kinds.indexOf(relationOf(document, pair)) + 1) % kinds.length] ?? null;
  return relate(document, pair.upper, pair.lower, next);
}
