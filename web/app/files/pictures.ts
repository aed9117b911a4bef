import type { Document, DrawingSource } from '../../document/document';
import { baseName } from '../../document/file_kind';
import type { Texture } from '../../engine/messages';
import { pngFile } from './archives';
import { canvasOf, isOverpainted, painted, vectorSide } from '../../view/painted_drawing';

/** Most pixels of any other picture, which bounds the memory of the page. */
const maxPixels = 4096 * 4096;
/** Most pixels of a flat drawing, so that its labels keep up with the pen. */
const flatPixels = 2048 * 2048;
/** Longest side of the picture made of a vector drawing of lines, px; the command line uses the same. */
const flatSide = 1600;
/** Longer side below which each pixel of a flat drawing becomes a square, px; the command line uses the same. */
const smallSide = 300;
/** Longest side of a painting that is compared with what was read, px; the command line uses the same. */
const comparedSide = 400;
/** px */
const stripHeight = 256;

/** Paints a whole canvas strip by strip, so that the page stays responsive. */
async function paintInStrips(context: OffscreenCanvasRenderingContext2D, image: HTMLImageElement): Promise<void> {
  const { width, height } = context.canvas;
  for (let y = 0; y < height; y += stripHeight) {
    context.save();
    context.beginPath();
    context.rect(0, y, width, stripHeight);
    context.clip();
    context.drawImage(image, 0, 0, width, height);
    context.restore();
    // Reading a pixel makes the canvas paint now.
    context.getImageData(0, y, 1, 1);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Lets the browser paint an SVG as a picture. None of its scripts run and nothing is fetched. */
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

/** Turns a vector drawing into a flat one on white paper, as a PNG file. */
export async function flatOfSvg(paintable: string, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
  const picture = await rasterizeSvg(paintable, width, height, flatSide);
  const [canvas, context] = canvasOf(picture.width, picture.height);
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(picture, 0, 0);
  picture.close();
  return pngFile(canvas.transferToImageBitmap());
}

/** Paints an SVG small, to be compared with what was read of it. */
export async function paintingOfSvg(paintable: string, width: number, height: number): Promise<Texture> {
  const picture = await rasterizeSvg(paintable, width, height, comparedSide);
  const painting = pixelsOf(picture, picture.width, picture.height);
  picture.close();
  return painting;
}

/** Decodes a picture file and scales it down if it has more than `maxPixels` pixels. */
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
 * Returns a flat drawing in the form in which it is segmented and kept: the original file, or a PNG
 * file of its picture if the command line could not read the original, or it is too large to scribble on or small.
 */
export async function flatDrawing(source: DrawingSource): Promise<{ drawing: DrawingSource; picture: ImageBitmap }> {
  const whole = await createImageBitmap(new Blob([source.bytes as Uint8Array<ArrayBuffer>], { type: source.mime }));
  const times = Math.ceil(smallSide / Math.max(whole.width, whole.height));
  const scale = times > 1 ? times : Math.min(1, Math.sqrt(flatPixels / (whole.width * whole.height)));
  if (scale === 1 && ['image/png', 'image/jpeg'].includes(source.mime)) return { drawing: source, picture: whole };
  const [canvas, context] = canvasOf(scale * whole.width, scale * whole.height);
  context.imageSmoothingEnabled = scale < 1;
  context.drawImage(whole, 0, 0, canvas.width, canvas.height);
  whole.close();
  const picture = canvas.transferToImageBitmap();
  const name = `${baseName(source.name)}.png`;
  return { drawing: { name, kind: 'image', mime: 'image/png', bytes: await pngFile(picture) }, picture };
}

/**
 * Makes a picture transparent where a mask of the same size is dark or, if the mask has transparent
 * pixels at all, where it is transparent. Returns a PNG file.
 */
export async function cutOut(picture: ImageBitmap, mask: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
  const { width, height } = picture;
  const kept = pixelsOf(mask, width, height).rgba;
  const byAlpha = kept.some((value, i) => i % 4 === 3 && value < 128);
  const [canvas, context] = canvasOf(width, height);
  context.drawImage(picture, 0, 0);
  const cut = context.getImageData(0, 0, width, height);
  for (let i = 0; i < kept.length; i += 4) {
    const [r = 0, g = 0, b = 0, alpha = 0] = kept.subarray(i, i + 4);
    if ((byAlpha ? alpha : Math.max(r, g, b)) < 128) cut.data[i + 3] = 0;
  }
  context.putImageData(cut, 0, 0);
  return pngFile(canvas.transferToImageBitmap());
}

/** Returns a picture scaled to another size. */
export function imageDataOf(picture: ImageBitmap, { width, height }: { width: number; height: number }): ImageData {
  const [canvas, context] = canvasOf(width, height);
  context.drawImage(picture, 0, 0, canvas.width, canvas.height);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

export function pixelsOf(picture: ImageBitmap, width: number, height: number): Texture {
  const pixels = imageDataOf(picture, { width, height });
  return { rgba: new Uint8Array(pixels.data.buffer as ArrayBuffer), width: pixels.width, height: pixels.height };
}

/**
 * Returns the drawing scaled down to at most `side` px on its longest side. The browser scales
 * pictures off the page's own thread.
 */
export async function smallPicture(document: Document, picture: ImageBitmap | null, side: number): Promise<ImageBitmap> {
  if (!picture) return painted(document, null, side).canvas.transferToImageBitmap();
  const whole = isOverpainted(document) ? painted(document, picture).canvas.transferToImageBitmap() : picture;
  const scale = Math.min(1, side / Math.max(picture.width, picture.height));
  const [resizeWidth, resizeHeight] = [picture.width, picture.height].map((length) => Math.max(1, Math.round(scale * length))) as [number, number];
  return createImageBitmap(whole, { resizeWidth, resizeHeight, resizeQuality: 'medium' });
}

/** Returns the texture that exported files embed. */
export function textureOf(document: Document, picture: ImageBitmap | null): Texture {
  const context = painted(document, picture);
  const { width, height } = context.canvas;
  const { data } = context.getImageData(0, 0, width, height);
  return { rgba: new Uint8Array(data.buffer as ArrayBuffer), width, height };
}

export function pngOf(document: Document, picture: ImageBitmap | null): Promise<Uint8Array> {
  return pngFile(painted(document, picture).canvas.transferToImageBitmap());
}
