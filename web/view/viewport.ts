import type { Point } from '../document/document';

/** Maps the canvas to the screen: screen = scale · canvas + (x, y), CSS px. */
export interface Viewport {
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

const minScale = 0.05;
const maxScale = 40;

export function toCanvas(view: Viewport, [x, y]: Point): Point {
  return [(x - view.x) / view.scale, (y - view.y) / view.scale];
}

export function panned(view: Viewport, dx: number, dy: number): Viewport {
  return { scale: view.scale, x: view.x + dx, y: view.y + dy };
}

/** Zooms about a point of the screen, which stays fixed. */
export function zoomed(view: Viewport, factor: number, [x, y]: Point): Viewport {
  const scale = Math.min(maxScale, Math.max(minScale, view.scale * factor));
  const ratio = scale / view.scale;
  return { scale, x: x - ratio * (x - view.x), y: y - ratio * (y - view.y) };
}

/** Fits the whole canvas into a pane, beside what covers `left` and `bottom` of its edges, CSS px. */
export function fitted(canvas: Point, pane: Point, [left, bottom]: Point, margin = 24): Viewport {
  const room = pane[0] - left - margin;
  const height = pane[1] - bottom - margin;
  const scale = Math.max(minScale, Math.min(room / canvas[0], height / canvas[1]));
  return {
    scale,
    x: left + (room - scale * canvas[0]) / 2,
    y: margin + (height - scale * canvas[1]) / 2,
  };
}
