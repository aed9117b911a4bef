import type { Point } from '../../document/document';
import { canvasOf } from '../../view/painted_drawing';

/** Longest side of the copy that is read, px. */
const longest = 700;
/** Points this near to the edge of the page count as paper, as a share of the page. */
const edge = 0.004;
/** Pixels with less alpha than this, of 255, are transparent. */
const transparent = 16;

interface Alpha {
  readonly of: ImageBitmap;
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

/** Finds where a flat picture is empty: where it is transparent, and at its very edge. */
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
