import type { Point, Ring } from '../document/document';

/** The context of either kind of canvas. */
export type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export function tracePart(context: Context, outline: readonly Ring[]): void {
  context.beginPath();
  for (const ring of outline) {
    ring.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.closePath();
  }
}

/** Traces an open line. A single point becomes a line of no length, which a round pen draws as a dot. */
export function traceLine(context: Context, line: Ring): void {
  context.beginPath();
  line.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  if (line.length === 1) context.lineTo(...(line[0] as Point as [number, number]));
}
