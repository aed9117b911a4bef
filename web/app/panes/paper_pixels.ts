import type { Point } from '../../document/document';
import { canvasOf } from '../../view/painted_drawing';

const longest = 700;
/** Pixels so near to the edge of the page, of 1, are paper. */
const edge = 0.004;
const transparent = 16;

interface Alpha {
  readonly of: ImageBitmap;
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

/** Tells where a flat picture shows nothing: where it is transparent, and at its very edge. */
export class PaperPixels {
  private alpha: Alpha | null = null;

  isPaper(picture: ImageBitmap | null, [width, height]: Point, [x, y]: Point): boolean {
    const [u, v] = [x / width, y / height];
    if (u < edge || v < edge || u > 1 - edge || v > 1 - edge) return true;
    if (!picture) return false;
    const alpha = this.alphaOf(picture);
    const at = Math.floor(v * alpha.height) * alpha.width + Math.floor(u * alpha.width);
    return (alpha.data[4 * at + 3] ?? 255) < transparent;
  }

  private alphaOf(picture: ImageBitmap): Alpha {
    if (this.alpha?.of === picture) return this.alpha;
    const scale = Math.min(1, longest / Math.max(picture.width, picture.height));
    const [canvas, context] = canvasOf(scale * picture.width, scale * picture.height);
    const { width, height } = canvas;
    context.drawImage(picture, 0, 0, width, height);
    this.alpha = { of: picture, width, height, data: context.getImageData(0, 0, width, height).data };
    return this.alpha;
  }
}
