import type { Document, Part, Point, Ring } from './document';
import { areaOf, boxOf } from './outline';

/** A part that comes so near to all sides of the page, as a share of it, is the page itself. */
const rim = 0.01;
const mostOfPage = 0.5;

function isPage({ width, height }: Document, { outline }: Part): boolean {
  const { min, max } = boxOf(outline);
  const [x, y] = [rim * width, rim * height];
  const reaches = min[0] < x && min[1] < y && max[0] > width - x && max[1] > height - y;
  return reaches && Math.abs(areaOf(outline)) > mostOfPage * width * height;
}

/** Whether a step makes a part of the paper around a figure. */
export function inflatesPaper(before: Document, after: Document): boolean {
  return after.parts.some((part) => isPage(after, part)) && !before.parts.some((part) => isPage(before, part));
}

/** The longest stretch of a stroke that is not on paper; empty where all of it is. */
export function offPaper(stroke: Ring, isPaper: (point: Point) => boolean): Point[] {
  let best: Point[] = [];
  let run: Point[] = [];
  for (const point of stroke) {
    run = isPaper(point) ? [] : [...run, point];
    if (run.length > best.length) best = run;
  }
  return best;
}
