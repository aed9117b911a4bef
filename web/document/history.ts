import { apply, type Change, difference, reverse, squash } from './change';
import type { Document } from './document';

/** A document and the way to it. A value: every step makes a new one. */
export interface History {
  readonly document: Document;
  readonly done: readonly Change[];
  readonly undone: readonly Change[];
  /** Steps of one gesture or of one slider merge into one change while this stays the same. */
  readonly gesture: string | null;
}

const maxChanges = 500;

export function startHistory(document: Document): History {
  return { document, done: [], undone: [], gesture: null };
}

/** Goes on to `next`. What had been undone is forgotten. */
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

/** Goes on to `next` as a part of the last change. */
export function amend(history: History, next: Document): History {
  const last = history.done.at(-1);
  const change = last && difference(last.label, history.document, next);
  if (!last || !change) return history;
  return { ...history, document: next, done: [...history.done.slice(0, -1), squash(last, change)] };
}
