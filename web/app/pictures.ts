import type { Document, DrawingSource } from '../document/document';
import type { Texture } from '../engine/messages';
import { paintParts } from '../view/paper_view';

/** Longest side of the texture made of a vector drawing or of parts: the command line's. */
const vectorSide = 2048;
const maxPixels = 4096 * 4096;

function canvasOf(width: number, height: number): [OffscreenCanvas, OffscreenCanvasRenderingContext2D] {
  const canvas = new OffscreenCanvas(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  return [canvas, context];
}

/** Lets the browser paint an SVG as a picture: no script of it runs, nothing of it is fetched. */
async function rasterizeSvg(paintable: string, width: number, height: number): Promise<ImageBitmap> {
  const url = URL.createObjectURL(new Blob([paintable], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const scale = vectorSide / Math.max(width, height);
    const [canvas, context] = canvasOf(scale * width, scale * height);
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.transferToImageBitmap();
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** A picture file, made smaller where it has more pixels than a page can bear. */
export async function decodePicture(bytes: Uint8Array, mime: string): Promise<ImageBitmap> {
  const bitmap = await createImageBitmap(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: mime }));
  const pixels = bitmap.width * bitmap.height;
  if (pixels <= maxPixels) return bitmap;
  const scale = Math.sqrt(maxPixels / pixels);
  const [canvas, context] = canvasOf(scale * bitmap.width, scale * bitmap.height);
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  bitmap.close();
  return canvas.transferToImageBitmap();
}

export async function pictureOf(drawing: DrawingSource, width: number, height: number): Promise<ImageBitmap> {
  return drawing.kind === 'svg'
    ? rasterizeSvg(drawing.paintable ?? '', width, height)
    : decodePicture(drawing.bytes, drawing.mime);
}

/** The drawing, or the parts painted flat where there is none, as pixels. */
function painted(document: Document, picture: ImageBitmap | null): OffscreenCanvasRenderingContext2D {
  const scale = vectorSide / Math.max(document.width, document.height);
  const [canvas, context] = picture
    ? canvasOf(picture.width, picture.height)
    : canvasOf(scale * document.width, scale * document.height);
  if (picture) context.drawImage(picture, 0, 0);
  else {
    context.scale(canvas.width / document.width, canvas.height / document.height);
    paintParts(context as unknown as CanvasRenderingContext2D, document, document.width / 350);
    context.resetTransform();
  }
  return context;
}

/**
 * A flat drawing as it is segmented and kept: the file as it came, or its picture as a PNG file
 * where the command line could not read that, or where it was made smaller.
 */
export async function flatDrawing(drawing: DrawingSource, picture: ImageBitmap): Promise<DrawingSource> {
  const size = await createImageBitmap(new Blob([drawing.bytes as Uint8Array<ArrayBuffer>], { type: drawing.mime }));
  const whole = size.width === picture.width && size.height === picture.height;
  size.close();
  if (whole && (drawing.mime === 'image/png' || drawing.mime === 'image/jpeg')) return drawing;
  const [canvas, context] = canvasOf(picture.width, picture.height);
  context.drawImage(picture, 0, 0);
  const blob = await canvas.convertToBlob({ type: 'image/png' });
  const bytes = new Uint8Array(await blob.arrayBuffer());
  return { name: drawing.name.replace(/\.[^.]*$/, '') + '.png', kind: 'image', mime: 'image/png', bytes };
}

/** A picture at another size. */
export function pixelsOf(picture: ImageBitmap, width: number, height: number): Texture {
  const [canvas, context] = canvasOf(width, height);
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  return { rgba: new Uint8Array(data.buffer as ArrayBuffer), width: canvas.width, height: canvas.height };
}

/** What exported files embed. */
export function textureOf(document: Document, picture: ImageBitmap | null): Texture {
  const context = painted(document, picture);
  const { width, height } = context.canvas;
  const { data } = context.getImageData(0, 0, width, height);
  return { rgba: new Uint8Array(data.buffer as ArrayBuffer), width, height };
}

export async function pngOf(document: Document, picture: ImageBitmap | null): Promise<Uint8Array> {
  const blob = await painted(document, picture).canvas.convertToBlob({ type: 'image/png' });
  return new Uint8Array(await blob.arrayBuffer());
}

/** The same for the view: what is transparent takes the colour beside it, so that rims show none of it. */
export function bledTexture(document: Document, picture: ImageBitmap | null): OffscreenCanvas {
  const sharp = painted(document, picture).canvas;
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
