import { describe, expect, it } from 'vitest';
import { noteCorrections } from '../../document/corrections';
import { type Document, emptyDocument, type Ring } from '../../document/document';
import { type Doubt, doubtsOf, refuseGuess, sameDoubt, takeGuess } from '../../document/doubts';
import { emptySegmentation } from '../../document/segmentation';

const box = (left: number, right: number): Ring => [[left, 100], [right, 100], [right, 300], [left, 300]];

/** Three parts in a row that overlap; the first two are joined. */
function guessed(): Document {
  const part = (id: string, left: number) => ({ id, outline: [box(left, left + 200)], c: 4, d: 1 });
  return {
    ...emptyDocument(),
    parts: [part('body', 0), part('arm', 150), part('hand', 300)],
    joins: [{ upper: 'arm', lower: 'body', line: [[150, 100], [150, 300]] }],
    segmentation: {
      ...emptySegmentation(),
      parts: ['body', 'arm', 'hand'].map((id, i) => ({ label: i + 1, id, completion: 'whole' })),
      order: [
        { upper: 2, lower: 1, confidence: 0.6, user: false, kept: true },
        { upper: 3, lower: 2, confidence: 0.2, user: false, kept: true },
        { upper: 3, lower: 1, confidence: 0.95, user: false, kept: true },
      ],
      joins: [{ upper: 2, lower: 1, confidence: 0.5 }],
    },
  };
}

const told = (document: Document): string[] =>
  doubtsOf(document, []).map((doubt) => (doubt.kind === 'gap' ? 'gap' : `${doubt.kind} ${doubt.upper} ${doubt.lower}`));

type Guess = Doubt & { kind: 'order' | 'join' };

describe('doubts', () => {
  it('are the uncertain guesses, the least certain first', () => {
    expect(told(guessed())).toEqual(['order hand arm', 'join arm body', 'order arm body']);
    expect(doubtsOf(emptyDocument(), [])).toEqual([]);
  });

  it('that are confirmed stay as they are and are no longer asked about', () => {
    for (const doubt of doubtsOf(guessed(), []) as Guess[]) {
      const taken = takeGuess(guessed(), doubt);
      expect([taken.parts, taken.joins]).toEqual([guessed().parts, guessed().joins]);
      expect(told(taken)).toEqual(told(guessed()).filter((text) => text !== `${doubt.kind} ${doubt.upper} ${doubt.lower}`));
      expect(sameDoubt(doubtsOf(taken, []), doubt)).toBe(undefined);
    }
  });

  it('that are rejected swap the order or remove the join, and are no longer asked about', () => {
    const before = guessed();
    for (const doubt of doubtsOf(before, []) as Guess[]) {
      const refused = noteCorrections(before, refuseGuess(before, doubt));
      const ids = refused.parts.map(({ id }) => id);
      if (doubt.kind === 'order') expect(ids.indexOf(doubt.lower)).toBeGreaterThan(ids.indexOf(doubt.upper));
      else expect(refused.joins).toEqual([]);
      expect(told(refused)).not.toContain(`${doubt.kind} ${doubt.upper} ${doubt.lower}`);
      expect(told(refused)).not.toContain(`${doubt.kind} ${doubt.lower} ${doubt.upper}`);
    }
  });
});
