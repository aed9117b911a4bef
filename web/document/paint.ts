import type { Document, PaintStroke, Point } from './document';

/** Widths of the paint brush, px of the page. */
export const paintWidths = { least: 2, most: 120 } as const;

/** Most strokes that are read from a file. */
const mostStrokes = 100_000;

export function addPaint(document: Document, stroke: PaintStroke): Document {
  return { ...document, paint: [...document.paint, stroke] };
}

function isPoint(value: unknown): value is Point {
  return Array.isArray(value) && value.length === 2 && value.every((x) => typeof x === 'number' && Math.abs(x) < 1e6);
}

/** Returns the valid strokes of a file and drops the others. */
export function soundPaint(value: unknown): PaintStroke[] {
  if (!Array.isArray(value)) return [];
  return value.slice(0, mostStrokes).flatMap((item): PaintStroke[] => {
    const { color, width, points } = (item ?? {}) as { [key in keyof PaintStroke]?: unknown };
    const isColor = color === null || (typeof color === 'string' && /^#[0-9a-f]{6}$/i.test(color));
    const isLine = Array.isArray(points) && points.length > 0 && points.every(isPoint);
    return isColor && isLine && typeof width === 'number' && width > 0 && width < 1e4 ? [{ color, width, points }] : [];
  });
}
