import { apply, type Change, difference, reverse, squash } from './change';
import type { Document } from './document';

/** A document with its changes. A history is a value: every step makes a new one. */
export interface History {
  readonly document: Document;
  readonly done: readonly Change[];
  readonly undone: readonly Change[];
  /** Identifies the gesture of the last step. Further steps of the same gesture merge into one change. */
  readonly gesture: string | null;
}

/** Most changes that can be undone. */
const maxChanges = 500;

export function startHistory(document: Document): History {
  return { document, done: [], undone: [], gesture: null };
}

/** Makes a step to `next`. Undone changes are forgotten. */
export function record(history: History, label: string, next: Document, gesture: string | null = null): History {
  const change = difference(label, history.document, next);
  if (!change) return history;
  const last = history.done.at(-1);
  const merges = gesture !== null && gesture === history.gesture && last !== undefined;
  const done = merges ? [...history.done.slice(0, -1), squash(last, change)] : [...history.done, change];
  return { document: next, done: done.slice(-maxChanges), undone: [], gesture };
}

export function undo(history: History): History {
  const change = history.done.at(-1);
  if (!change) return history;
  return {
    document: apply(history.document, reverse(change)),
    done: history.done.slice(0, -1),
    undone: [...history.undone, change],
    gesture: null,
  };
}

export function redo(history: History): History {
  const change = history.undone.at(-1);
  if (!change) return history;
  return {
    document: apply(history.document, change),
    done: [...history.done, change],
    undone: history.undone.slice(0, -1),
    gesture: null,
  };
}

/** Extends the last change to `next`. */
export function amend(history: History, next: Document): History {
  const last = history.done.at(-1);
  const change = last && difference(last.label, history.document, next);
  if (!last || !change) return history;
  return { ...history, document: next, done: [...history.done.slice(0, -1), squash(last, change)] };
}

/** A state of the history, with the change that led to it, or null for the oldest state. */
export interface Position {
  readonly document: Document;
  readonly change: Change | null;
}

/**
 * Returns up to `most` states before the current one, the current one at index `at`, and up to `most` undone
 * states.
 */
export function positionsOf(history: History, most: number): { positions: Position[]; at: number } {
  const { done, undone, document } = history;
  const first = Math.max(0, done.length - most);
  const positions: Position[] = [{ document, change: done.at(-1) ?? null }];
  for (let i = done.length - 1; i >= first; i--) {
    const [after] = positions as [Position, ...Position[]];
    positions.unshift({ document: apply(after.document, reverse(done[i] as Change)), change: done[i - 1] ?? null });
  }
  const at = positions.length - 1;
  for (const change of [...undone].reverse().slice(0, most))
    positions.push({ document: apply((positions.at(-1) as Position).document, change), change });
  return { positions, at };
}

/**
 * Returns the history that leads through some states, with that at index `at` as the current one. `labels[i]`
 * names the step to state i.
 */
export function historyThrough(states: readonly Document[], labels: readonly string[], at: number): History {
  const step = (to: number): Change | null =>
    difference(labels[to] ?? '', states[to - 1] as Document, states[to] as Document);
  const steps = (from: number, to: number): Change[] =>
    Array.from({ length: Math.max(0, to - from) }, (_, i) => step(from + i + 1)).filter((change) => change !== null);
  return {
    document: states[at] as Document,
    done: steps(0, at),
    undone: steps(at, states.length - 1).reverse(),
    gesture: null,
  };
}
