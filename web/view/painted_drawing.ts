import { type Document, emptyDocument } from '../document/document';
import type { Dressed } from '../engine/messages';
import { drawContent } from './paper_view';

/** The fields of a document that determine how it looks, apart from its picture. */
export type Painted = Pick<Document, 'width' | 'height' | 'parts' | 'joins' | 'paint' | 'settings'>;

/** An empty page of the size of a dressed surface's picture, for the picture to fill. */
export function sheetOf({ picture }: Dressed): Painted {
  return { ...emptyDocument(), width: picture.width, height: picture.height };
}

/** Returns whether a document shows more than its picture. */
export function isOverpainted({ parts, paint }: Pick<Painted, 'parts' | 'paint'>): boolean {
  return paint.length > 0 || parts.some(({ color }) => color);
}

/** Returns the values that determine how a document looks; see isSameLook. */
export function lookOf({ parts, joins, paint, settings }: Painted, picture: ImageBitmap | null): readonly unknown[] {
  const shown = picture && !parts.some(({ color }) => color) ? [] : [parts, joins, settings.inkColor, settings.inkWidth];
  return [picture, paint, ...shown];
}

export function isSameLook(a: readonly unknown[], b: readonly unknown[]): boolean {
  return a.length === b.length && a.every((value, i) => value === b[i]);
}

/** Longest side of the texture made of a vector drawing or of parts, px; the command line uses the same. */
export const vectorSide = 2048;

/** Longest side of the texture of a dressed surface, px: its picture has contours and hidden paint below the drawing. */
export const dressedSide = 2 * vectorSide;

export function canvasOf(width: number, height: number): [OffscreenCanvas, OffscreenCanvasRenderingContext2D] {
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  return [canvas, context];
}

/** Paints the drawing at its own size, or the parts in flat colours if there is none, at most `side` px long. */
export function painted(document: Painted, picture: ImageBitmap | null, side = Infinity): OffscreenCanvasRenderingContext2D {
  const { width, height } = picture ?? document;
  const longest = Math.min(side, picture ? Math.max(width, height) : vectorSide);
  const scale = longest / Math.max(width, height);
  const [canvas, context] = canvasOf(scale * width, scale * height);
  context.scale(canvas.width / document.width, canvas.height / document.height);
  drawContent(context, document, picture, document.width / 350);
  context.resetTransform();
  return context;
}

/**
 * Paints the drawing as a texture for the view. Transparent pixels take the colour beside them, so that no rim
 * shows the background.
 */
export function bledTexture(document: Painted, picture: ImageBitmap | null, side = vectorSide): OffscreenCanvas {
  const sharp = painted(document, picture, side).canvas;
  const scale = Math.min(1, side / Math.max(sharp.width, sharp.height));
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
