import type { Document, Part, Point } from './document';
import { contains } from './outline';

/** Returns the foremost part at a point among those behind index `before`. */
export function partUnder(document: Document, point: Point, before: number): Part | undefined {
  return document.parts
    .slice(0, before)
    .reverse()
    .find((part) => contains(part.outline, point));
}

/** Returns the foremost part at a point. */
export function partAt(document: Document, point: Point): Part | undefined {
  return partUnder(document, point, document.parts.length);
}

/**
 * Returns the foremost part at a point or, if `deeper`, the next one below the selected part. Below
 * the last part it starts again at the front.
 */
export function partBelow(document: Document, point: Point, selected: string | null, deeper: boolean): Part | undefined {
  const stack = document.parts.filter((part) => contains(part.outline, point)).reverse();
  const at = stack.findIndex((part) => part.id === selected);
  return deeper && at >= 0 ? stack[(at + 1) % stack.length] : stack[0];
}
