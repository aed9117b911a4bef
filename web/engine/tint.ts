import { labelColor } from './label_colors';

/** Opacity of areas, and of the borders between them, of 255. */
const area = 140;
const border = 235;

/**
 * Paints labels as a picture to lay over the drawing: each in its colour with a stronger border, background
 * transparent.
 */
export function tintOf(labels: Uint16Array, width: number, height: number): ImageData {
  const pixels = new Uint32Array(width * height);
  const colors = new Map<number, number>();
  const colorOf = (label: number): number => {
    const found = colors.get(label);
    if (found !== undefined) return found;
    const [red, green, blue] = labelColor(label);
    const color = (blue << 16) | (green << 8) | red;
    colors.set(label, color);
    return color;
  };
  let last = 0;
  let color = 0;
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++, i++) {
      const label = labels[i] as number;
      if (label === 0) continue;
      if (label !== last) {
        last = label;
        color = colorOf(label);
      }
      const edge =
        (x > 0 && labels[i - 1] !== label) || (x + 1 < width && labels[i + 1] !== label) ||
        (y > 0 && labels[i - width] !== label) || (y + 1 < height && labels[i + width] !== label);
      pixels[i] = ((edge ? border : area) << 24) | color;
    }
  return new ImageData(new Uint8ClampedArray(pixels.buffer), width, height);
}
