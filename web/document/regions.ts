// Imports single files, since the index of the package would add triangulation and more.
import { ClipType, FillRule } from 'clipper2-ts/dist/Core.js';
import { Clipper64 } from 'clipper2-ts/dist/Engine.js';
import { ClipperOffset, EndType, JoinType } from 'clipper2-ts/dist/Offset.js';
import type { Point, Ring } from './document';
import { area } from './outline';

/** Units of Clipper's integer coordinates per px. */
const units = 100;

type Path = { x: number; y: number }[];

function pathOf(line: Ring): Path {
  return line.map(([x, y]) => ({ x: Math.round(units * x), y: Math.round(units * y) }));
}

function ringsOf(paths: readonly Path[]): Point[][] {
  return paths.map((path) => path.map(({ x, y }): Point => [x / units, y / units]));
}

/** Returns the union of the areas that rings enclose, whichever way they run. Holes of the result run the other way. */
export function unionOf(rings: readonly Ring[]): Point[][] {
  const clipper = new Clipper64();
  clipper.addSubject(rings.map(pathOf));
  const solution: Path[] = [];
  clipper.execute(ClipType.Union, FillRule.NonZero, solution);
  return ringsOf(solution);
}

/** Returns the area within `radius` px of an open line. */
export function around(line: Ring, radius: number): Point[][] {
  const offset = new ClipperOffset(2, units * 0.05);
  offset.addPaths([pathOf(line)], JoinType.Round, EndType.Round);
  const solution: Path[] = [];
  offset.execute(units * radius, solution);
  return ringsOf(solution);
}

/** Returns the largest of some rings, or an empty ring if there are none. */
export function largest(rings: readonly Ring[]): Point[] {
  return [...([...rings].sort((a, b) => Math.abs(area(b)) - Math.abs(area(a)))[0] ?? [])];
}
