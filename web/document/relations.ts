import type { Document, Pair, Point, RelationKind } from './document';
import { relate } from './editing';
import { contains, nearestPlace } from './outline';

/** What can be said of a pair, one after the other; null is the usual. */
const kinds: readonly (RelationKind | null)[] = [null, 'free', 'equal', 'joined', 'above'];

/** The pair whose upper outline passes a point within `reach` px, inside the lower part; none that is joined. */
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

/** What is said of a pair everywhere; null: the usual. */
export function relationOf({ relations }: Document, { upper, lower }: Pair): RelationKind | null {
  return relations.find((entry) => entry.upper === upper && entry.lower === lower && !entry.range)?.relation ?? null;
}

/** Says the next of what can be said of a pair. */
export function turnRelation(document: Document, pair: Pair): Document {
  const next = kinds[(kinds.indexOf(relationOf(document, pair)) + 1) % kinds.length] ?? null;
  return relate(document, pair.upper, pair.lower, next);
}
