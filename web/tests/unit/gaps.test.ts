import { describe, expect, it } from 'vitest';
import { addPart } from '../../document/editing';
import { type Document, emptyDocument, type Point } from '../../document/document';
import { type Gap, gapAt, keepGap, openGap, openQuestions, sameGap } from '../../document/gaps';
import { clearStroke, moveStroke, scribblesOf, strokesNear } from '../../document/scribbling';
import { emptySegmentation, type Stroke } from '../../document/segmentation';
import { box } from './shapes';

/** Two parts side by side, label 1 to the left and 2 to the right of x = 200, the second larger. */
function flat(): Document {
  let document = addPart(emptyDocument(), 'small', box(100, 100, 100, 100));
  document = addPart(document, 'large', box(200, 100, 200, 100));
  const parts = ['small', 'large'].map((id, i) => ({ label: i + 1, id, completion: 'whole' }));
  return { ...document, segmentation: { ...emptySegmentation(), parts } };
}

/** A gap upwards along x = 200; the small part lies to its left. */
const between: Gap = { points: [[200, 160], [200, 140]], left: 1, right: 2 };
/** A gap along the top of the large part, with the background above. */
const above: Gap = { points: [[300, 100], [340, 100]], left: 0, right: 2 };

function strokesOf(document: Document): readonly Stroke[] {
  return scribblesOf(document).strokes;
}

const left = ({ points }: Stroke): boolean => points.every(([x]) => x < 200);

describe('a closed gap', () => {
  it('that is kept has strokes of both parts beside it, and is no longer asked about', () => {
    const kept = keepGap(flat(), between);
    expect(strokesOf(kept).map((stroke) => [stroke.kind, stroke.part, left(stroke)])).toEqual([
      ['hard', 'small', true], ['hard', 'large', false],
    ]);
    expect(openQuestions(flat(), [between, above])).toEqual([between, above]);
    expect(openQuestions(kept, [between, above])).toEqual([above]);
    expect(openQuestions(kept, [{ points: [[201, 158], [200, 141]], left: 1, right: 2 }])).toEqual([]);
  });

  it('towards the background is kept by a stroke for the outside', () => {
    const kept = keepGap(flat(), above);
    const lines = strokesOf(kept).map(({ kind, part, points }) => [kind, part, points.every(([, y]) => y < 100)]);
    expect(lines).toEqual([['outside', undefined, true], ['hard', 'large', false]]);
    expect(openQuestions(kept, [above])).toEqual([]);
  });

  it('that is opened has one stroke across, for the larger part or the one with strokes', () => {
    const opened = openGap(flat(), between);
    const [across] = strokesOf(opened);
    expect([across!.part, across!.points.map(([x]) => Math.sign(x - 200))]).toEqual(['large', [-1, 1]]);
    const said: Stroke = { kind: 'hard', part: 'small', width: 5, points: [[150, 150]] };
    const scribbled = { ...flat(), segmentation: { ...flat().segmentation!, scribbles: { parts: ['small'], strokes: [said] } } };
    expect(strokesOf(openGap(scribbled, between)).map(({ part }) => part)).toEqual(['small', 'small']);
  });

  it('between two scribbled parts gives the strokes of one to the other', () => {
    const kept = keepGap(flat(), between);
    const opened = openGap(kept, between);
    expect(new Set(strokesOf(opened).map(({ part }) => part))).toEqual(new Set(['large']));
    expect(opened.segmentation!.scribbles.parts).toEqual(['large']);
  });

  it('to the background opens by a stroke for the outside; with unknown sides it stays as it is', () => {
    expect(strokesOf(openGap(flat(), above)).map(({ kind }) => kind)).toEqual(['outside']);
    const unknown = { ...between, right: 9 };
    expect(openQuestions(flat(), [unknown])).toEqual([]);
    expect(openGap(flat(), unknown)).toEqual(flat());
  });

  it('is found by a point near it, and found again after it moved a little', () => {
    const near: Point = [206, 150];
    expect(gapAt([above, between], near, 8)).toBe(between);
    expect(gapAt([above, between], near, 4)).toBeUndefined();
    const again: Gap = { ...between, points: [[201, 160], [201, 142]] };
    expect(sameGap([above, again], between)).toBe(again);
    expect(sameGap([above, again], null)).toBeUndefined();
  });
});

describe('a stroke', () => {
  const kept = keepGap(flat(), between);

  it('moves as a whole, and back', () => {
    const [first] = strokesOf(kept);
    const moved = moveStroke(kept, first!, [12, -5]);
    expect(strokesOf(moved)[0]!.points[0]).toEqual([first!.points[0]![0] + 12, first!.points[0]![1] - 5]);
    expect(strokesOf(moved)[1]).toBe(strokesOf(kept)[1]);
    expect(moveStroke(moved, strokesOf(moved)[0]!, [-12, 5])).toEqual(kept);
    expect(moveStroke(moved, first!, [1, 0])).toBe(moved);
  });

  it('is found among those near a point and removed alone', () => {
    const [first, second] = strokesOf(kept);
    expect(strokesNear(scribblesOf(kept), [200, 150], 8)).toEqual([second, first]);
    expect(strokesOf(clearStroke(kept, first!))).toEqual([second]);
  });
});
