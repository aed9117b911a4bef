import type { Document, Part, Point, Ring } from './document';
import { areaOf, boxOf } from './outline';

/** Largest gap between each side of the page and a part that is the page itself, as a share of that side. */
const rim = 0.01;
/** Smallest share of the page that such a part covers. */
const mostOfPage = 0.5;

function isPage({ width, height }: Document, { outline }: Part): boolean {
  const { min, max } = boxOf(outline);
  const [x, y] = [rim * width, rim * height];
  const reaches = min[0] < x && min[1] < y && max[0] > width - x && max[1] > height - y;
  return reaches && Math.abs(areaOf(outline)) > mostOfPage * width * height;
}

/** Returns whether a step turns the paper around the figure into a part. */
export function inflatesPaper(before: Document, after: Document): boolean {
  return after.parts.some((part) => isPage(after, part)) && !before.parts.some((part) => isPage(before, part));
}

/** Returns the longest stretch of a stroke that is not on paper; empty if all of it is. */
export function offPaper(stroke: Ring, isPaper: (point: Point) => boolean): Point[] {
  let best: Point[] = [];
  let run: Point[] = [];
  for (const point of stroke) {
    run = isPaper(point) ? [] : [...run, point];
    if (run.length > best.length) best = run;
  }
  return best;
}
