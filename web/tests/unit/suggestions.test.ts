import { describe, expect, it } from 'vitest';
import { type Document, emptyDocument } from '../../document/document';
import { addJoin, addPart, relate } from '../../document/editing';
import { contains } from '../../document/outline';
import { pairAt, relationOf, turnRelation } from '../../document/relations';
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

describe('the relation at an outline', () => {
  it('is found by a point near it, for pairs that are not joined', () => {
    expect(pairAt(figure(), [252, 261], 8)).toEqual({ upper: 'eye', lower: 'body' });
    expect(pairAt(figure(), [260, 260], 4)).toBe(null);
    expect(pairAt(figure(), [201, 300], 8)).toBe(null);
    const [join] = suggestedJoins(figure());
    expect(pairAt(figure(), [461, 310], 8)).toEqual({ upper: 'arm', lower: 'body' });
    expect(pairAt(addJoin(figure(), join!), [461, 310], 8)).toBe(null);
  });

  it('cycles through all relations and back to the default', () => {
    const pair = { upper: 'eye', lower: 'body' };
    const said = [0, 1, 2, 3, 4].map((turns) => Array.from({ length: turns }).reduce<Document>((document) => turnRelation(document, pair), figure()));
    expect(said.map((document) => relationOf(document, pair))).toEqual([null, 'free', 'equal', 'joined', 'above']);
    expect(turnRelation(said[4]!, pair).relations).toEqual([]);
  });
});

describe('suggested joins', () => {
  it('are those of parts whose outline dips into another once', () => {
    const joins = suggestedJoins(figure());
    expect(joins.map(({ upper, lower }) => [upper, lower])).toEqual([['arm', 'body']]);
    for (const point of joins[0]!.line) expect(contains(figure().parts[0]!.outline, point)).toBe(true);
  });

  it('disappear when they are accepted, or when the user has set a relation', () => {
    const [join] = suggestedJoins(figure());
    expect(suggestedJoins(addJoin(figure(), join!))).toEqual([]);
    expect(suggestedJoins(relate(figure(), 'arm', 'body', 'free'))).toEqual([]);
  });

  it('are found by a point near their line', () => {
    expect(joinAt(suggestedJoins(figure()), [461, 310], 8)?.upper).toBe('arm');
    expect(joinAt(suggestedJoins(figure()), [620, 310], 8)).toBe(null);
  });
});
