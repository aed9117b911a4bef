import { describe, expect, it } from 'vitest';
import { type Document, emptyDocument } from '../../document/document';
import { addJoin, addPart, relate } from '../../document/editing';
import { contains } from '../../document/outline';
import { joinAt, suggestedJoins } from '../../document/suggestions';
import { box } from './shapes';

/** A body with an arm that reaches into it, an eye inside of it, a strap across it and a cloud beside it. */
function figure(): Document {
  let document = addPart(emptyDocument(), 'body', box(200, 200, 300, 200));
  document = addPart(document, 'arm', box(460, 280, 200, 60));
  document = addPart(document, 'eye', box(250, 250, 20, 20));
  document = addPart(document, 'strap', box(300, 150, 20, 300));
  return addPart(document, 'cloud', box(700, 20, 80, 50));
}

describe('suggested joins', () => {
  it('are those of parts whose outline dips into another once', () => {
    const joins = suggestedJoins(figure());
    expect(joins.map(({ upper, lower }) => [upper, lower])).toEqual([['arm', 'body']]);
    for (const point of joins[0]!.line) expect(contains(figure().parts[0]!.outline, point)).toBe(true);
  });

  it('go when they are taken, or when the person has said what holds', () => {
    const [join] = suggestedJoins(figure());
    expect(suggestedJoins(addJoin(figure(), join!))).toEqual([]);
    expect(suggestedJoins(relate(figure(), 'arm', 'body', 'free'))).toEqual([]);
  });

  it('are found by a point near their line', () => {
    expect(joinAt(suggestedJoins(figure()), [461, 310], 8)?.upper).toBe('arm');
    expect(joinAt(suggestedJoins(figure()), [620, 310], 8)).toBe(null);
  });
});
