import type { Document, PaintStroke } from '../document/document';
import { type Context, traceLine, tracePart } from './trace';

/** Draws on a separate canvas first, so that rubbing out there does not affect what lies below. */
function onLayer(context: Context, draw: (layer: OffscreenCanvasRenderingContext2D) => void): void {
  const layer = new OffscreenCanvas(context.canvas.width, context.canvas.height).getContext('2d');
  if (!layer) return;
  layer.setTransform(context.getTransform());
  draw(layer);
  context.save();
  context.resetTransform();
  context.drawImage(layer.canvas, 0, 0);
  context.restore();
}

function drawStrokes(context: Context, strokes: readonly PaintStroke[]): void {
  context.lineCap = context.lineJoin = 'round';
  for (const { color, width, points } of strokes) {
    context.globalCompositeOperation = color === null ? 'destination-out' : 'source-over';
    context.strokeStyle = color ?? '#000';
    context.lineWidth = width;
    traceLine(context, points);
    context.stroke();
  }
  context.globalCompositeOperation = 'source-over';
}

/** Draws the paint of the user over everything. */
export function drawPaint(context: Context, strokes: readonly PaintStroke[]): void {
  if (strokes.some(({ color }) => color === null)) onLayer(context, (layer) => drawStrokes(layer, strokes));
  else drawStrokes(context, strokes);
}

/**
 * Draws parts that were drawn by hand over the drawing, which does not show them. Parts of the drawing in
 * front cover them.
 */
export function drawAdded(context: Context, { parts, settings }: Pick<Document, 'parts' | 'settings'>, pen: number): void {
  if (!parts.some(({ color }) => color)) return;
  onLayer(context, (layer) => {
    layer.lineJoin = 'round';
    for (const { color, outline } of parts) {
      tracePart(layer, outline);
      layer.globalCompositeOperation = color ? 'source-over' : 'destination-out';
      layer.fillStyle = color ?? '#000';
      layer.fill('nonzero');
      if (!color || settings.inkWidth === 0) continue;
      layer.strokeStyle = settings.inkColor;
      layer.lineWidth = pen * settings.inkWidth;
      layer.stroke();
    }
  });
}
