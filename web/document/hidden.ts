import type { Part, Point, Ring } from './document';
import { boxOf, contains, mix, perimeter, resample } from './outline';

/** Hidden outlines found so far, by list of parts; lists of parts never change. */
const found = new WeakMap<readonly Part[], Map<string, readonly Ring[]>>();

/** Returns a function that tests whether any of some parts contains a point. */
function coverOf(parts: readonly Part[]): (point: Point) => boolean {
  const boxes = parts.map((part) => boxOf(part.outline));
  return ([x, y]) =>
    parts.some((part, i) => {
      const { min, max } = boxes[i] as { min: Point; max: Point };
      return x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1] && contains(part.outline, [x, y]);
    });
}

function findHidden(part: Part, before: readonly Part[]): Ring[] {
  const covered = coverOf(before);
  const lines: Point[][] = [];
  for (const ring of part.outline) {
    const points = resample([...ring, ring[0] as Point], Math.max(2, perimeter(ring) / 400)).slice(0, -1);
    const next = (i: number): Point => points[(i + 1) % points.length] as Point;
    const hidden = points.map((p, i) => covered(mix(p, next(i), 0.5)));
    // Starts after a visible side, so that no hidden line is cut in two.
    const start = hidden.indexOf(false) + 1;
    let line: Point[] | null = null;
    for (let k = start; k < start + points.length; k++) {
      const i = k % points.length;
      if (!hidden[i]) line = null;
      else if (line) line.push(next(i));
      else lines.push((line = [points[i] as Point, next(i)]));
    }
  }
  return lines;
}

/** Returns the stretches of a part's outline that lie behind other parts, as open lines. `parts` are back to front. */
export function hiddenOutline(parts: readonly Part[], id: string): readonly Ring[] {
  const known = found.get(parts) ?? new Map<string, readonly Ring[]>();
  found.set(parts, known);
  const index = parts.findIndex((part) => part.id === id);
  const lines = known.get(id) ?? (index < 0 ? [] : findHidden(parts[index] as Part, parts.slice(index + 1)));
  known.set(id, lines);
  return lines;
}
