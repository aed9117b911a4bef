import type { Document } from '../document/document';
import { paintParts } from './paper_view';

/** What of a document is painted where there is no picture of it. */
export type Painted = Pick<Document, 'width' | 'height' | 'parts' | 'joins'>;

/** Longest side of the texture made of a vector drawing or of parts: the command line's. */
export const vectorSide = 2048;

export function canvasOf(width: number, height: number): [OffscreenCanvas, OffscreenCanvasRenderingContext2D] {
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  return [canvas, context];
}

/** The drawing, or the parts painted flat where there is none, `side` px long, as pixels. */
export function painted(document: Painted, picture: ImageBitmap | null, side = vectorSide): OffscreenCanvasRenderingContext2D {
  const scale = side / Math.max(document.width, document.height);
  const [canvas, context] = picture
    ? canvasOf(picture.width, picture.height)
    : canvasOf(scale * document.width, scale * document.height);
  if (picture) context.drawImage(picture, 0, 0);
  else {
    context.scale(canvas.width / document.width, canvas.height / document.height);
    paintParts(context, document, document.width / 350);
    context.resetTransform();
  }
  return context;
}

/** The same for the view: what is transparent takes the colour beside it, so that rims show none of it. */
export function bledTexture(document: Painted, picture: ImageBitmap | null, side = vectorSide): OffscreenCanvas {
  const sharp = painted(document, picture, side).canvas;
  const scale = Math.min(1, vectorSide / Math.max(sharp.width, sharp.height));
  const [canvas, context] = canvasOf(scale * sharp.width, scale * sharp.height);
  context.fillStyle = '#efe9dd';
  context.fillRect(0, 0, canvas.width, canvas.height);
  for (const radius of [3, 1.5])
    for (let turn = 0; turn < 8; turn++) {
      const angle = (turn * Math.PI) / 4;
      context.drawImage(
        sharp, radius * Math.cos(angle), radius * Math.sin(angle), canvas.width, canvas.height,
      );
    }
  context.drawImage(sharp, 0, 0, canvas.width, canvas.height);
  return canvas;
}
