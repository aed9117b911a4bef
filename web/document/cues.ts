import type { Cue, Document, Point, Ring } from './document';
import { contains, distance, rounded, simplify } from './outline';
import { partAt } from './picking';

/** Range, step and default of the values of each kind. */
export const cueRanges: Readonly<Record<Cue['kind'], { least: number; most: number; step: number; usual: number }>> = {
  bulge: { least: 0.2, most: 4, step: 0.05, usual: 1.6 },
  slope: { least: -60, most: 60, step: 1, usual: 25 },
  crease: { least: -60, most: 60, step: 1, usual: 25 },
};

const mostCues = 256;

/**
 * Makes a cue along a stroke, on the foremost part at its middle or else at its beginning. Returns
 * null if there is no part or the stroke is too short. `reach` is how far a hand may miss, px.
 */
export function cueOfStroke(document: Document, { kind, value }: Pick<Cue, 'kind' | 'value'>, stroke: Ring, reach: number): Cue | null {
  const line = simplify(stroke, reach / 8).map((p) => rounded(p, 100));
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || line.length < 2 || (line.length === 2 && distance(first, last) < reach / 2)) return null;
  const part = partAt(document, stroke[Math.floor(stroke.length / 2)] as Point) ?? partAt(document, first);
  return part && line.some((p) => contains(part.outline, p)) ? { part: part.id, kind, line, value } : null;
}

/** Adds a cue. The oldest cues are dropped beyond `mostCues`. */
export function addCue(document: Document, cue: Cue): Document {
  return { ...document, cues: [...document.cues, cue].slice(-mostCues) };
}

/** Removes the cues of a part. */
export function clearCues(document: Document, part: string): Document {
  return { ...document, cues: document.cues.filter((cue) => cue.part !== part) };
}
