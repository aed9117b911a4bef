import type { Part, Point, Ring } from './document';

/** A place on an outline. */
export interface OutlinePlace {
  readonly ring: number;
  /** Arc length from the ring's first point, px. */
  readonly at: number;
  readonly point: Point;
  readonly distance: number;
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

export function mix(a: Point, b: Point, t: number): Point {
  return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
}

/** Returns the signed area of a ring, positive if it runs clockwise on the screen. */
export function area(ring: Ring): number {
  let sum = 0;
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length] as Point;
    sum += p[0] * q[1] - q[0] * p[1];
  });
  return sum / 2;
}

/** Returns the signed area of an outline. Holes run the other way, so they count negative. */
export function areaOf(outline: readonly Ring[]): number {
  return outline.reduce((sum, ring) => sum + area(ring), 0);
}

export function boxOf(outline: readonly Ring[]): { min: Point; max: Point } {
  const points = outline.flat();
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  return {
    min: [Math.min(...xs), Math.min(...ys)],
    max: [Math.max(...xs), Math.max(...ys)],
  };
}

/** Returns whether a point is inside an outline by the non-zero rule. */
export function contains(outline: readonly Ring[], [x, y]: Point): boolean {
  let winding = 0;
  for (const ring of outline) {
    let a = ring[ring.length - 1] as Point;
    for (const b of ring) {
      if (a[1] <= y !== b[1] <= y) {
        const side = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]);
        if (b[1] > a[1] ? side > 0 : side < 0) winding += b[1] > a[1] ? 1 : -1;
      }
      a = b;
    }
  }
  return winding !== 0;
}

function nearestOnSegment(p: Point, a: Point, b: Point): number {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const length2 = dx * dx + dy * dy;
  if (length2 === 0) return 0;
  return Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2));
}

/** Returns the distance of a point from an open line. */
export function distanceTo(line: Ring, p: Point): number {
  const gaps = line.map((a, i) => {
    const b = line[i + 1] ?? a;
    return distance(p, mix(a, b, nearestOnSegment(p, a, b)));
  });
  return Math.min(...gaps);
}

/** Returns the place on an outline nearest to `p`, in time linear in its points. */
export function nearestPlace(outline: readonly Ring[], p: Point): OutlinePlace {
  let best: OutlinePlace = { ring: 0, at: 0, point: outline[0]?.[0] ?? p, distance: Infinity };
  outline.forEach((ring, index) => {
    let at = 0;
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] as Point;
      const t = nearestOnSegment(p, a, b);
      const point = mix(a, b, t);
      const length = distance(a, b);
      const d = distance(p, point);
      if (d < best.distance) best = { ring: index, at: at + t * length, point, distance: d };
      at += length;
    });
  });
  return best;
}

export function perimeter(ring: Ring): number {
  return ring.reduce((sum, p, i) => sum + distance(p, ring[(i + 1) % ring.length] as Point), 0);
}

/** Returns the length of an open line. */
export function lengthOf(line: Ring): number {
  return line.reduce((sum, p, i) => (i === 0 ? 0 : sum + distance(line[i - 1] as Point, p)), 0);
}

/** Returns the point of a ring at arc length `at`, px, from its first point, in time linear in its points. */
export function pointAt(ring: Ring, at: number): Point {
  const length = perimeter(ring);
  let left = ((at % length) + length) % length;
  for (let i = 0; i < ring.length; i++) {
    const a = ring[i] as Point;
    const b = ring[(i + 1) % ring.length] as Point;
    const side = distance(a, b);
    if (left <= side) return side === 0 ? a : mix(a, b, left / side);
    left -= side;
  }
  return ring[0] as Point;
}

/** Returns the corners of a ring between two arc lengths, forwards. */
export function walk(ring: Ring, from: number, to: number): Point[] {
  const length = perimeter(ring);
  const span = (((to - from) % length) + length) % length;
  const path: Point[] = [];
  let at = 0;
  const after: { at: number; point: Point }[] = [];
  ring.forEach((p, i) => {
    after.push({ at: (((at - from) % length) + length) % length, point: p });
    at += distance(p, ring[(i + 1) % ring.length] as Point);
  });
  after.sort((x, y) => x.at - y.at);
  for (const corner of after) if (corner.at > 1e-9 && corner.at < span - 1e-9) path.push(corner.point);
  return path;
}

/** Returns both ways along a ring between two of its places, the shorter one first. */
export function arcsBetween(outline: readonly Ring[], from: OutlinePlace, to: OutlinePlace): [Point[], Point[]] {
  const ring = outline[from.ring];
  if (!ring || from.ring !== to.ring) return [[from.point, to.point], [from.point, to.point]];
  const length = perimeter(ring);
  const forwards = (((to.at - from.at) % length) + length) % length;
  const ahead = [from.point, ...walk(ring, from.at, to.at), to.point];
  const back = [from.point, ...walk(ring, to.at, from.at).reverse(), to.point];
  return forwards <= length / 2 ? [ahead, back] : [back, ahead];
}

/** Returns the shorter way along a ring between two of its places. */
export function arcBetween(outline: readonly Ring[], from: OutlinePlace, to: OutlinePlace): Point[] {
  return arcsBetween(outline, from, to)[0];
}

/** Returns an ellipse with `corners` corners, clockwise on the screen from its rightmost point. */
export function oval([x, y]: Point, [across, up]: Point, corners: number): Point[] {
  return Array.from({ length: corners }, (_, i): Point => {
    const angle = (2 * Math.PI * i) / corners;
    return [x + across * Math.cos(angle), y + up * Math.sin(angle)];
  });
}

/** Rounds the coordinates of a point to multiples of 1 / `steps` px, which keeps files short. */
export function rounded([x, y]: Point, steps: number): Point {
  return [Math.round(steps * x) / steps, Math.round(steps * y) / steps];
}

/** Subdivides a polyline so that its points are at most `step` apart. */
export function resample(line: Ring, step: number): Point[] {
  const out: Point[] = [];
  line.forEach((a, i) => {
    out.push(a);
    const b = line[i + 1];
    if (!b) return;
    const pieces = Math.ceil(distance(a, b) / step);
    for (let k = 1; k < pieces; k++) out.push(mix(a, b, k / pieces));
  });
  return out;
}

/** Returns the longest stretch of the upper outline inside the lower part, or null if there is none. */
export function longestRunInside(upper: Part, lower: Part): Point[] | null {
  let best: Point[] = [];
  for (const ring of upper.outline) {
    const points = resample([...ring, ring[0] as Point], Math.max(1, perimeter(ring) / 400)).slice(0, -1);
    const inside = points.map((p) => contains(lower.outline, p));
    const start = inside.indexOf(false);
    if (start < 0) continue;
    let run: Point[] = [];
    for (let k = 0; k <= points.length; k++) {
      const i = (start + k) % points.length;
      if (inside[i] && k < points.length) run.push(points[i] as Point);
      else {
        if (run.length > best.length) best = run;
        run = [];
      }
    }
  }
  return best.length < 2 ? null : best;
}

/** Returns whether two parts overlap, judged by the points of their outlines. */
export function overlap(a: Part, b: Part): boolean {
  const boxA = boxOf(a.outline);
  const boxB = boxOf(b.outline);
  for (const k of [0, 1] as const)
    if (boxA.max[k] < boxB.min[k] || boxB.max[k] < boxA.min[k]) return false;
  const reaches = (from: Part, into: Part): boolean =>
    from.outline.some((ring) => ring.some((p) => contains(into.outline, p)));
  return reaches(a, b) || reaches(b, a) || longestRunInside(a, b) !== null;
}

/**
 * Simplifies a polyline by Douglas and Peucker's method: no dropped point is farther than `tolerance` from the
 * result.
 */
export function simplify(line: Ring, tolerance: number): Point[] {
  if (line.length < 3) return [...line];
  const keep = new Set([0, line.length - 1]);
  const todo: [number, number][] = [[0, line.length - 1]];
  for (let range = todo.pop(); range; range = todo.pop()) {
    const [first, last] = range;
    const a = line[first] as Point;
    const b = line[last] as Point;
    let worst = tolerance;
    let at = -1;
    for (let i = first + 1; i < last; i++) {
      const p = line[i] as Point;
      const d = distance(p, mix(a, b, nearestOnSegment(p, a, b)));
      if (d > worst) [worst, at] = [d, i];
    }
    if (at < 0) continue;
    keep.add(at);
    todo.push([first, at], [at, last]);
  }
  return line.filter((_, i) => keep.has(i));
}

/** Smooths a hand-drawn line by cutting its corners twice. The ends of an open line stay. */
export function smooth(line: Ring, closed: boolean): Point[] {
  let current: Ring = line;
  for (let round = 0; round < 2; round++) {
    const out: Point[] = [];
    const count = closed ? current.length : current.length - 1;
    if (!closed) out.push(current[0] as Point);
    for (let i = 0; i < count; i++) {
      const a = current[i] as Point;
      const b = current[(i + 1) % current.length] as Point;
      out.push(mix(a, b, 0.25), mix(a, b, 0.75));
    }
    if (!closed) out.push(current[current.length - 1] as Point);
    current = out;
  }
  return current.map((p) => rounded(p, 100));
}
