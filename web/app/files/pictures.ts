import type { Document, DrawingSource } from '../../document/document';
import { baseName } from '../../document/file_kind';
import type { Texture } from '../../engine/messages';
import { pngFile } from './archives';
import { canvasOf, isOverpainted, painted, vectorSide } from '../../view/painted_drawing';

const maxPixels = 4096 * 4096;
/** Of a flat drawing, so that labels follow the pen. */
const flatPixels = 2048 * 2048;
/** Longest side of the picture that is made of a vector drawing of lines: the command line's. */
const flatSide = 1600;
const stripHeight = 256;

/** Paints all of a canvas, a strip at a time, so that the page stays free for the hand. */
async function paintInStrips(context: OffscreenCanvasRenderingContext2D, image: HTMLImageElement): Promise<void> {
  const { width, height } = context.canvas;
  for (let y = 0; y < height; y += stripHeight) {
    context.save();
    context.beginPath();
    context.rect(0, y, width, stripHeight);
    context.clip();
    context.drawImage(image, 0, 0, width, height);
    context.restore();
    // A canvas paints when it is looked at.
    context.getImageData(0, y, 1, 1);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Lets the browser paint an SVG as a picture: no script of it runs, nothing of it is fetched. */
async function rasterizeSvg(paintable: string, width: number, height: number, side = vectorSide): Promise<ImageBitmap> {
  const url = URL.createObjectURL(new Blob([paintable], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const scale = side / Math.max(width, height);
    const [canvas, context] = canvasOf(scale * width, scale * height);
    await paintInStrips(context, image);
    return canvas.transferToImageBitmap();
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** A vector drawing as a flat one, on white paper where it has none: a PNG file. */
export async function flatOfSvg(paintable: string, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
  const picture = await rasterizeSvg(paintable, width, height, flatSide);
  const [canvas, context] = canvasOf(picture.width, picture.height);
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(picture, 0, 0);
  picture.close();
  return pngFile(canvas.transferToImageBitmap());
}

/** A picture file, made smaller where it has more pixels than a page can bear. */
async function decodePicture(bytes: Uint8Array, mime: string): Promise<ImageBitmap> {
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

/**
 * A flat drawing as it is segmented and kept: the file as it came, or its picture as a PNG file
 * where the command line could not read that, or where it is too large to scribble on.
 */
export async function flatDrawing(source: DrawingSource): Promise<{ drawing: DrawingSource; picture: ImageBitmap }> {
  const whole = await createImageBitmap(new Blob([source.bytes as Uint8Array<ArrayBuffer>], { type: source.mime }));
  const scale = Math.min(1, Math.sqrt(flatPixels / (whole.width * whole.height)));
  if (scale === 1 && ['image/png', 'image/jpeg'].includes(source.mime)) return { drawing: source, picture: whole };
  const [canvas, context] = canvasOf(scale * whole.width, scale * whole.height);
  context.drawImage(whole, 0, 0, canvas.width, canvas.height);
  whole.close();
  const picture = canvas.transferToImageBitmap();
  const name = `${baseName(source.name)}.png`;
  return { drawing: { name, kind: 'image', mime: 'image/png', bytes: await pngFile(picture) }, picture };
}

/** A picture without what a mask of the same size leaves out: where that is dark, or transparent if it is so anywhere. A PNG file. */
export async function cutOut(picture: ImageBitmap, mask: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
  const { width, height } = picture;
  const said = pixelsOf(mask, width, height).rgba;
  const byAlpha = said.some((value, i) => i % 4 === 3 && value < 128);
  const [canvas, context] = canvasOf(width, height);
  context.drawImage(picture, 0, 0);
  const cut = context.getImageData(0, 0, width, height);
  for (let i = 0; i < said.length; i += 4) {
    const [r = 0, g = 0, b = 0, alpha = 0] = said.subarray(i, i + 4);
    if ((byAlpha ? alpha : Math.max(r, g, b)) < 128) cut.data[i + 3] = 0;
  }
  context.putImageData(cut, 0, 0);
  return pngFile(canvas.transferToImageBitmap());
}

/** A picture at another size. */
export function imageDataOf(picture: ImageBitmap, { width, height }: { width: number; height: number }): ImageData {
  const [canvas, context] = canvasOf(width, height);
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

export function pixelsOf(picture: ImageBitmap, width: number, height: number): Texture {
  const pixels = imageDataOf(picture, { width, height });
  return { rgba: new Uint8Array(pixels.data.buffer as ArrayBuffer), width: pixels.width, height: pixels.height };
}

/** The drawing at a smaller size, `side` px at most. The browser scales pictures beside the page's own thread. */
export async function smallPicture(document: Document, picture: ImageBitmap | null, side: number): Promise<ImageBitmap> {
  if (!picture) return painted(document, null, side).canvas.transferToImageBitmap();
  const whole = isOverpainted(document) ? painted(document, picture).canvas.transferToImageBitmap() : picture;
  const scale = Math.min(1, side / Math.max(picture.width, picture.height));
  const [resizeWidth, resizeHeight] = [picture.width, picture.height].map((length) => Math.max(1, Math.round(scale * length))) as [number, number];
  return createImageBitmap(whole, { resizeWidth, resizeHeight, resizeQuality: 'medium' });
}

/** What exported files embed. */
export function textureOf(document: Document, picture: ImageBitmap | null): Texture {
  const context = painted(document, picture);
  const { width, height } = context.canvas;
  const { data } = context.getImageData(0, 0, width, height);
  return { rgba: new Uint8Array(data.buffer as ArrayBuffer), width, height };
}

export function pngOf(document: Document, picture: ImageBitmap | null): Promise<Uint8Array> {
  return pngFile(painted(document, picture).canvas.transferToImageBitmap());
}
