import { type Document, partIndex, type Point } from '../document/document';
import { arcBetween, distance, nearestPlace } from '../document/outline';

/** An end of a join or range, which can be slid along its outline. */
export interface Handle {
  readonly kind: 'join' | 'robin';
  readonly index: number;
  readonly end: 'first' | 'last';
  readonly point: Point;
}

/** Returns the handles of all joins and ranges of a part. */
export function handlesOf(document: Document, id: string | null): Handle[] {
  const handles: Handle[] = [];
  document.joins.forEach((join, index) => {
    if (join.upper !== id && join.lower !== id) return;
    handles.push({ kind: 'join', index, end: 'first', point: join.line[0] as Point });
    handles.push({ kind: 'join', index, end: 'last', point: join.line[join.line.length - 1] as Point });
  });
  document.robin.forEach((range, index) => {
    if (range.upper !== id && range.lower !== id) return;
    handles.push({ kind: 'robin', index, end: 'first', point: range.from });
    handles.push({ kind: 'robin', index, end: 'last', point: range.to });
  });
  return handles;
}

/** Returns the nearest handle within `reach` of a point, or null. */
export function handleAt(handles: readonly Handle[], point: Point, reach: number): Handle | null {
  const near = handles.filter((handle) => distance(handle.point, point) < reach);
  return near.sort((a, b) => distance(a.point, point) - distance(b.point, point))[0] ?? null;
}

function slideJoin(document: Document, handle: Handle, to: Point): Document {
  const join = document.joins[handle.index];
  const upper = join && document.parts[partIndex(document, join.upper)];
  if (!upper) return document;
  const still = handle.end === 'first' ? join.line[join.line.length - 1] : join.line[0];
  const moving = nearestPlace(upper.outline, to);
  const fixed = nearestPlace(upper.outline, still as Point);
  const line = handle.end === 'first' ? arcBetween(upper.outline, moving, fixed) : arcBetween(upper.outline, fixed, moving);
  if (distance(moving.point, fixed.point) < 2) return document;
  return { ...document, joins: document.joins.map((old) => (old === join ? { ...old, line } : old)) };
}

function slideRange(document: Document, handle: Handle, to: Point): Document {
  const range = document.robin[handle.index];
  const upper = range && document.parts[partIndex(document, range.upper)];
  if (!upper) return document;
  const point = nearestPlace(upper.outline, to).point;
  const next = handle.end === 'first' ? { ...range, from: point } : { ...range, to: point };
  if (distance(next.from, next.to) < 2) return document;
  return { ...document, robin: document.robin.map((old) => (old === range ? next : old)) };
}

/** Slides a handle to the point of its outline nearest to `to`. */
export function slide(document: Document, handle: Handle, to: Point): Document {
  return handle.kind === 'join' ? slideJoin(document, handle, to) : slideRange(document, handle, to);
}
