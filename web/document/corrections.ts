import type { Document, Pair, Part } from './document';
import { type Corrections, type LabelPair, labelOf, type PartCorrection, samePair, type Segmentation } from './segmentation';

function turn<T extends LabelPair>(pair: T): T {
  return { ...pair, upper: pair.lower, lower: pair.upper };
}

function without<T extends LabelPair>(list: readonly T[], pair: LabelPair): readonly T[] {
  return list.some((item) => samePair(item, pair)) ? list.filter((item) => !samePair(item, pair)) : list;
}

function corrected(list: readonly PartCorrection[], change: PartCorrection): readonly PartCorrection[] {
  const before = list.find((item) => item.label === change.label);
  const others = list.filter((item) => item.label !== change.label);
  return [...others, { ...before, ...change }].sort((a, b) => a.label - b.label);
}

/** Compares two documents of the same segmentation and records what the user changed as corrections. */
class Notes {
  private corrections: Corrections;

  constructor(
    private readonly before: Document,
    private readonly after: Document,
    private readonly segmentation: Segmentation,
  ) {
    this.corrections = segmentation.corrections;
  }

  take(): Corrections {
    if (this.before.parts !== this.after.parts) {
      for (const part of this.after.parts) this.notePart(part);
      this.noteOrder();
    }
    if (this.before.joins !== this.after.joins) this.noteJoins();
    if (this.before.relations !== this.after.relations) this.noteRelations();
    if (this.before.robin !== this.after.robin) this.noteRanges();
    return this.corrections;
  }

  private set(values: Partial<Corrections>): void {
    this.corrections = { ...this.corrections, ...values };
  }

  /** Returns the labels of a pair, or undefined if one of its parts was drawn by hand or removed. */
  private labels(pair: Pair): LabelPair | undefined {
    const alive = (id: string): boolean => this.after.parts.some((part) => part.id === id);
    const upper = labelOf(this.segmentation, pair.upper);
    const lower = labelOf(this.segmentation, pair.lower);
    if (upper === undefined || lower === undefined || !alive(pair.upper) || !alive(pair.lower)) return undefined;
    return { upper, lower };
  }

  private notePart(part: Part): void {
    const before = this.before.parts.find((other) => other.id === part.id);
    const label = labelOf(this.segmentation, part.id);
    if (!before || label === undefined || before === part) return;
    const { c, d, flat = 0, lean, outline } = part;
    const change = {
      ...(before.c === c ? {} : { c }),
      ...(before.d === d ? {} : { d }),
      ...((before.flat ?? 0) === flat ? {} : { flat }),
      ...(before.lean === lean || !lean ? {} : { lean }),
      ...(before.outline === outline ? {} : { outline }),
    };
    if (Object.keys(change).length > 0) this.set({ parts: corrected(this.corrections.parts, { label, ...change }) });
  }

  /** Records every pair that changed its order, and removes or turns corrections that no longer hold. */
  private noteOrder(): void {
    const place = (document: Document): Map<number, number> =>
      new Map(document.parts.flatMap(({ id }, i) => {
        const label = labelOf(this.segmentation, id);
        return label === undefined ? [] : [[label, i] as const];
      }));
    const old = place(this.before);
    const now = place(this.after);
    const isTrue = ({ upper, lower }: LabelPair): boolean => (now.get(upper) ?? -1) > (now.get(lower) ?? Infinity);
    const flipped: LabelPair[] = [];
    for (const [upper, at] of now)
      for (const [lower, below] of now)
        if (at > below && (old.get(upper) ?? 0) < (old.get(lower) ?? 0)) flipped.push({ upper, lower });
    if (flipped.length === 0) return;
    const { order, no_joins, relations, robin, joins } = this.corrections;
    this.set({
      order: [...order.filter(isTrue), ...flipped],
      no_joins: no_joins.map((pair) => (isTrue(pair) ? pair : turn(pair))),
      relations: relations.map((item) => (isTrue(item) ? item : turn(item))),
      robin: robin.filter(isTrue),
      joins: joins.filter(isTrue),
    });
  }

  private noteJoins(): void {
    for (const join of this.after.joins) {
      const pair = this.labels(join);
      const before = this.before.joins.find((other) => other.upper === join.upper && other.lower === join.lower);
      if (!pair || before?.line === join.line) continue;
      const turned = this.before.joins.some((other) => other.upper === join.lower && other.lower === join.upper);
      // A guessed join that was only turned with the order of its parts is still a guess.
      if (turned && !this.segmentation.corrections.joins.some((own) => samePair(own, pair))) continue;
      const { joins, no_joins } = this.corrections;
      this.set({ joins: [...without(joins, pair), { ...pair, line: join.line }], no_joins: without(no_joins, pair) });
    }
    for (const join of this.before.joins) {
      const pair = this.labels(join);
      const stays = this.after.joins.some((other) => samePair(other, join));
      if (!pair || stays || !this.isUpright(join)) continue;
      const { joins, no_joins } = this.corrections;
      this.set({ joins: without(joins, pair), no_joins: [...without(no_joins, pair), pair] });
    }
  }

  private isUpright({ upper, lower }: Pair): boolean {
    const at = (id: string): number => this.after.parts.findIndex((part) => part.id === id);
    return at(upper) > at(lower);
  }

  private noteRelations(): void {
    const same = (a: Pair & { range?: unknown }, b: Pair & { range?: unknown }): boolean =>
      a.upper === b.upper && a.lower === b.lower && a.range === b.range;
    for (const item of this.after.relations) {
      const pair = this.labels(item);
      const before = this.before.relations.find((other) => same(other, item));
      const turned = this.before.relations.some((other) => other.upper === item.lower && other.lower === item.upper);
      if (!pair || before?.relation === item.relation || turned) continue;
      const { relation, range } = item;
      this.set({ relations: [...without(this.corrections.relations, pair), { ...pair, relation, ...(range ? { range } : {}) }] });
    }
    for (const item of this.before.relations) {
      const pair = this.labels(item);
      if (pair && this.isUpright(item) && !this.after.relations.some((other) => same(other, item)))
        this.set({ relations: without(this.corrections.relations, pair) });
    }
  }

  /** Records all ranges of a pair as soon as the user changed one of them. */
  private noteRanges(): void {
    const touched = [...this.after.robin, ...this.before.robin].filter(
      (range) => this.before.robin.includes(range) !== this.after.robin.includes(range),
    );
    for (const range of touched) {
      const pair = this.labels(range);
      if (!pair || !this.isUpright(range)) continue;
      const all = this.after.robin.filter(({ upper, lower }) => upper === range.upper && lower === range.lower);
      const own = all.map(({ upper: _upper, lower: _lower, ...values }) => ({ ...pair, ...values }));
      this.set({ robin: [...without(this.corrections.robin, pair), ...own] });
      if (own.length === 0) this.keepJoin(range, pair);
    }
  }

  /** Records the join of a pair whose last range was removed, since a guessed join would bring its ranges back. */
  private keepJoin({ upper, lower }: Pair, pair: LabelPair): void {
    const join = this.after.joins.find((other) => other.upper === upper && other.lower === lower);
    if (join) this.set({ joins: [...without(this.corrections.joins, pair), { ...pair, line: join.line }] });
  }
}

/** Returns `after` with what the user changed since `before` recorded as corrections. */
export function noteCorrections(before: Document, after: Document): Document {
  const { segmentation } = after;
  if (!segmentation || segmentation !== before.segmentation) return after;
  const corrections = new Notes(before, after, segmentation).take();
  return corrections === segmentation.corrections ? after : { ...after, segmentation: { ...segmentation, corrections } };
}
