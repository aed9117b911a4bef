import { type Document, emptyDocument, type Point } from './document';
import { joinParts } from './editing';
import { oval } from './outline';
import { drawStroke } from './strokes';

/** Reach of the hand for its strokes, px; see Hand. */
const reach = 12;

/** Returns a stroke around an ellipse, which ends where it begins. */
function loop(centre: Point, radii: Point): Point[] {
  const ring = oval(centre, radii, 40);
  return [...ring, ring[0] as Point];
}

/** Returns the stroke of a leg that hangs from the body between `left` and `right` down to `foot`. */
function leg(left: number, right: number, foot: number): Point[] {
  const middle = (left + right) / 2;
  return [[left, 500], [left - 4, foot - 30], [middle, foot], [right + 4, foot - 30], [right, 500]];
}

/** The strokes in the order of drawing. Later ones lie in front unless they are drawn behind. */
const strokes: readonly { name: string; behind: boolean; points: readonly Point[] }[] = [
  { name: 'body', behind: false, points: loop([470, 440], [215, 130]) },
  { name: 'leg', behind: true, points: leg(395, 455, 660) },
  { name: 'leg', behind: true, points: leg(575, 635, 660) },
  { name: 'leg', behind: false, points: leg(315, 380, 690) },
  { name: 'leg', behind: false, points: leg(500, 565, 690) },
  { name: 'head', behind: false, points: loop([690, 290], [130, 112]) },
  { name: 'ear', behind: false, points: [[600, 225], [590, 105], [675, 190]] },
  { name: 'ear', behind: false, points: [[715, 190], [800, 110], [785, 230]] },
  { name: 'eye', behind: false, points: loop([680, 285], [13, 17]) },
  { name: 'eye', behind: false, points: loop([755, 285], [13, 17]) },
  { name: 'nose', behind: false, points: loop([722, 330], [16, 11]) },
];

/** Returns an animal that lacks nothing but a tail. */
export function tourAnimal(name: string): Document {
  const drawn = strokes.reduce<Document>((document, { points, ...hand }) => {
    const next = drawStroke(document, { ...hand, reach }, points);
    return 'refused' in next ? document : next.document;
  }, { ...emptyDocument(), name });
  const joined = joinParts(drawn, 'head', 'body');
  const color = joined.parts.find(({ id }) => id === 'body')?.color as string;
  const alike = (id: string): boolean => /^(head|leg|ear)/.test(id);
  return { ...joined, parts: joined.parts.map((part) => (alike(part.id) ? { ...part, color } : part)) };
}
