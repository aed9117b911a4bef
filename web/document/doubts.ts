import { type Document, type Pair, partIndex } from './document';
import { bringBefore, removeJoin } from './editing';
import { type Gap, openQuestions, sameGap } from './gaps';
import { type Corrections, type LabelPair, labelOf, samePair, type Segmentation } from './segmentation';

/** An uncertain guess about a flat drawing; `upper` lies in front. */
export type Doubt =
  | (Pair & { readonly kind: 'order' | 'join'; readonly confidence: number })
  | { readonly kind: 'gap'; readonly gap: Gap };

/** Guesses with less confidence than this are doubts. */
const sure = { order: 0.7, join: 0.8 } as const;

/** Returns the ids of a pair of labels, the nearer part as `upper`, or undefined if one part is gone. */
function named({ parts }: Document, segmentation: Segmentation, pair: LabelPair): Pair | undefined {
  const at = (label: number): number => parts.findIndex(({ id }) => labelOf(segmentation, id) === label);
  const [front, back] = [at(pair.upper), at(pair.lower)].sort((a, b) => b - a) as [number, number];
  return back < 0 ? undefined : { upper: parts[front]?.id as string, lower: parts[back]?.id as string };
}

/** Returns all uncertain guesses that the user has not decided, the least certain first, gaps in lines last. */
export function doubtsOf(document: Document, gaps: readonly Gap[]): readonly Doubt[] {
  const { segmentation } = document;
  if (!segmentation) return [];
  const { corrections, order, joins } = segmentation;
  const pairs = (kind: 'order' | 'join', guesses: readonly (LabelPair & { confidence: number })[], decided: readonly LabelPair[]): Doubt[] =>
    guesses.flatMap((guess) => {
      const names = named(document, segmentation, guess);
      const open = names && guess.confidence < sure[kind] && !decided.some((pair) => samePair(pair, guess));
      return open ? [{ kind, ...names, confidence: guess.confidence }] : [];
    });
  const isJoined = ({ upper, lower }: Doubt & { kind: 'order' | 'join' }): boolean =>
    document.joins.some((join) => join.upper === upper && join.lower === lower);
  const guessed = [
    ...pairs('order', order.filter(({ user }) => !user), corrections.order),
    ...pairs('join', joins, [...corrections.joins, ...corrections.no_joins]).filter((doubt) => doubt.kind === 'join' && isJoined(doubt)),
  ] as (Doubt & { kind: 'order' | 'join' })[];
  guessed.sort((a, b) => a.confidence - b.confidence);
  return [...guessed, ...openQuestions(document, gaps).map((gap): Doubt => ({ kind: 'gap', gap }))];
}

/** Finds a doubt again in a new list, or returns undefined. */
export function sameDoubt(doubts: readonly Doubt[], doubt: Doubt | null): Doubt | undefined {
  if (doubt?.kind !== 'gap') return doubts.find((other) => other.kind !== 'gap' && other.kind === doubt?.kind && other.upper === doubt.upper && other.lower === doubt.lower);
  const gap = sameGap(doubts.flatMap((other) => (other.kind === 'gap' ? [other.gap] : [])), doubt.gap);
  return doubts.find((other) => other.kind === 'gap' && other.gap === gap);
}

function withCorrections(document: Document, values: Partial<Corrections>): Document {
  const { segmentation } = document;
  return segmentation ? { ...document, segmentation: { ...segmentation, corrections: { ...segmentation.corrections, ...values } } } : document;
}

/** Confirms a guess about a pair as a correction, so that it stays whatever else changes. */
export function takeGuess(document: Document, { kind, ...pair }: Doubt & { kind: 'order' | 'join' }): Document {
  const { segmentation } = document;
  const upper = segmentation ? labelOf(segmentation, pair.upper) : undefined;
  const lower = segmentation ? labelOf(segmentation, pair.lower) : undefined;
  if (!segmentation || upper === undefined || lower === undefined) return document;
  const { order, joins } = segmentation.corrections;
  if (kind === 'order') return withCorrections(document, { order: [...order.filter((other) => !samePair(other, { upper, lower })), { upper, lower }] });
  const join = document.joins.find((other) => other.upper === pair.upper && other.lower === pair.lower);
  return join ? withCorrections(document, { joins: [...joins, { upper, lower, line: join.line }] }) : document;
}

/** Rejects a guess about a pair: swaps their order, or removes their join. */
export function refuseGuess(document: Document, { kind, upper, lower }: Doubt & { kind: 'order' | 'join' }): Document {
  if (partIndex(document, upper) < 0 || partIndex(document, lower) < 0) return document;
  return kind === 'order' ? bringBefore(document, lower, upper) : removeJoin(document, upper, lower);
}
