import type { Document, Point } from './document';
import { areaOf, distance, oval } from './outline';
import { partAt } from './picking';
import { addDetail, detailInk, type Drawn } from './strokes';

/** Radius of an eye, of the side of a square as large as its part. */
const radiusShare = 0.1;
/** Of the eye: its height, the pupil's radius, and how far that looks down. */
const height = 1.2;
const pupilShare = 0.58;
const lookDown = 0.18;
const white = '#fffdf8';

const corners = 28;

/** An eye around a point: its white and its pupil, glued to the part below. `aside`: where it looks, in [-1, 1]. */
function addEye(document: Document, [x, y]: Point, radius: number, aside: number): Document {
  const ball = addDetail(document, 'eye', oval([x, y], [radius, height * radius], corners), white);
  const pupil = pupilShare * radius;
  const room = radius - pupil;
  return addDetail(ball, 'pupil', oval([x + 0.5 * aside * room, y + lookDown * radius], [pupil, height * pupil], corners), detailInk);
}

/** A tap puts an eye on the part below, a stroke a pair of them at its ends; they look at each other a little. */
export function stampEyes(document: Document, reach: number, points: readonly Point[]): Drawn {
  const [first, last] = [points[0] as Point, points.at(-1) as Point];
  const ground = partAt(document, first) ?? partAt(document, last);
  if (!ground) return { refused: 'dotOnPaper' };
  const span = distance(first, last);
  const radius = Math.max(0.6 * reach, radiusShare * Math.sqrt(Math.abs(areaOf(ground.outline))));
  const isPair = span > reach / 2;
  const fitting = isPair ? Math.min(radius, 0.45 * span) : radius;
  const way = Math.sign(last[0] - first[0]);
  const one = addEye(document, first, fitting, isPair ? way : 0);
  const next = isPair ? addEye(one, last, fitting, -way) : one;
  return { document: next, id: next.parts[document.parts.length]?.id ?? '' };
}
