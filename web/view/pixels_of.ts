/** The canvas as pixels on a ground of one colour, its longest side `side` px at most. */
export function pixelsOf(canvas: OffscreenCanvas, side: number, ground: string): ImageData {
  const scale = Math.min(1, side / Math.max(canvas.width, canvas.height));
  const [width, height] = [Math.round(scale * canvas.width), Math.round(scale * canvas.height)];
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  context.drawImage(canvas, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}
