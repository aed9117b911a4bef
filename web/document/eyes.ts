import type { Document, Point } from './document';
import { areaOf, distance, oval } from './outline';
import { partAt } from './picking';
import { addDetail, detailInk, type Drawn } from './strokes';

/** Radius of an eye, as a share of the square root of its part's area. */
const radiusShare = 0.1;
/** Height of an eye, radius of its pupil, and how far the pupil looks down, in radii of the eye. */
const height = 1.2;
const pupilShare = 0.58;
const lookDown = 0.18;
const white = '#fffdf8';

const corners = 28;

/** Adds an eye: its white and its pupil. `aside` is its gaze from left, -1, to right, 1. */
function addEye(document: Document, [x, y]: Point, radius: number, aside: number): Document {
  const ball = addDetail(document, 'eye', oval([x, y], [radius, height * radius], corners), white);
  const pupil = pupilShare * radius;
  const room = radius - pupil;
  return addDetail(ball, 'pupil', oval([x + 0.5 * aside * room, y + lookDown * radius], [pupil, height * pupil], corners), detailInk);
}

/**
 * Adds an eye for a tap, or a pair for a stroke, one eye at each end. The eyes of a pair look slightly at each
 * other.
 */
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
