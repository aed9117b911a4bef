import type { Document } from './document';

/** A reversible change: the fields that differ, before and after. Values that stay equal are shared. */
export interface Change {
  readonly label: string;
  readonly before: Partial<Document>;
  readonly after: Partial<Document>;
}

function fieldsOf(document: Document): (keyof Document)[] {
  return Object.keys(document) as (keyof Document)[];
}

/** Returns the change from one document to another, or null if they are equal. */
export function difference(label: string, from: Document, to: Document): Change | null {
  const changed = fieldsOf(to).filter((key) => from[key] !== to[key]);
  if (changed.length === 0) return null;
  const pick = (document: Document): Partial<Document> =>
    Object.fromEntries(changed.map((key) => [key, document[key]]));
  return { label, before: pick(from), after: pick(to) };
}

export function apply(document: Document, change: Change): Document {
  return { ...document, ...change.after };
}

export function reverse(change: Change): Change {
  return { label: change.label, before: change.after, after: change.before };
}

/** Returns one change that has the effect of `first` followed by `second`. */
export function squash(first: Change, second: Change): Change {
  return {
    label: second.label,
    before: { ...second.before, ...first.before },
    after: { ...first.after, ...second.after },
  };
}
