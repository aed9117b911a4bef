import { canvasOf } from './painted_drawing';

/** Returns the pixels of a canvas on a background of one colour, scaled down to `side` px on its longest side. */
export function snapshotOf(canvas: OffscreenCanvas, side: number, ground: string): ImageData {
  const scale = Math.min(1, side / Math.max(canvas.width, canvas.height));
  const [small, context] = canvasOf(scale * canvas.width, scale * canvas.height);
  context.fillStyle = ground;
  context.fillRect(0, 0, small.width, small.height);
  context.drawImage(canvas, 0, 0, small.width, small.height);
  return context.getImageData(0, 0, small.width, small.height);
}
