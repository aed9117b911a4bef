import { expect, it } from 'vitest';
import { emptyDocument, type Part } from '../../document/document';
import { addPart } from '../../document/editing';
import { stampEyes } from '../../document/eyes';
import { boxOf, contains } from '../../document/outline';
import { box } from './shapes';

const face = addPart(emptyDocument(), 'face', box(200, 200, 400, 300));

function eyesOf(points: readonly (readonly [number, number])[]): Part[] {
  const drawn = stampEyes(face, 12, points);
  if ('refused' in drawn) throw new Error(drawn.refused);
  expect(drawn.id).toBe('eye');
  return drawn.document.parts.slice(1);
}

it('a tap adds one eye, all of it on the part below and the pupil inside the white', () => {
  const [white, pupil, ...others] = eyesOf([[400, 350]]) as [Part, Part];
  expect(others).toEqual([]);
  expect(white.outline[0]!.every((p) => contains(face.parts[0]!.outline, p))).toBe(true);
  expect(pupil.outline[0]!.every((p) => contains(white.outline, p))).toBe(true);
  expect(white.color).not.toBe(pupil.color);
});

it('a stroke adds a pair of equal eyes at its ends, which look at each other', () => {
  const [left, leftPupil, right, rightPupil] = eyesOf([[350, 350], [380, 352], [450, 350]]) as [Part, Part, Part, Part];
  const middle = ({ outline }: Part): number => (boxOf(outline).min[0] + boxOf(outline).max[0]) / 2;
  const width = ({ outline }: Part): number => boxOf(outline).max[0] - boxOf(outline).min[0];
  expect([middle(left), middle(right)].map(Math.round)).toEqual([350, 450]);
  expect(width(left)).toBeCloseTo(width(right));
  expect(boxOf(left.outline).max[0]).toBeLessThan(boxOf(right.outline).min[0]);
  expect(middle(leftPupil)).toBeGreaterThan(middle(left));
  expect(middle(rightPupil)).toBeLessThan(middle(right));
});

it('eyes outside all parts are refused', () => {
  expect(stampEyes(face, 12, [[50, 50]])).toEqual({ refused: 'dotOnPaper' });
});
