import type { Document, Ring } from '../document/document';
import type { SolidOptions } from '../engine/messages';

export type PrintKind = 'plaque' | 'cutout' | 'medal' | 'figure';

/** What is to be made of the relief to hold it; lengths in mm. */
export interface PrintChoice {
  readonly kind: PrintKind;
  /** Of the whole at most; 0: as deep as it is. */
  readonly height: number;
  readonly detail: boolean;
  readonly thickness: number;
  readonly hang: 'none' | 'hole' | 'ring';
}

export const usualPrint: PrintChoice = { kind: 'plaque', height: 0, detail: false, thickness: 2, hang: 'none' };

/** Of what something hangs by. */
const hole = 4;
/** What is thinner breaks, or does not come out of a printer at all. */
export const leastWidth = 1.2;

const bases = { plaque: 'plate', cutout: 'outline', medal: 'round', figure: 'none' } as const;

export function solidOptions({ kind, height, detail, thickness, hang }: PrintChoice, size: number): SolidOptions {
  const plate = kind !== 'figure';
  return {
    size, height, detail, thickness,
    back: plate ? 'flat' : 'parts',
    base: bases[kind],
    hole: plate && hang === 'hole' ? hole : 0,
    ring: plate && hang === 'ring' ? hole : 0,
  };
}

/** Twice the area and the length of a closed line. */
function measure(ring: Ring): [number, number] {
  let area = 0;
  let length = 0;
  ring.forEach(([x, y], i) => {
    const [u, v] = ring[(i + 1) % ring.length] as Ring[number];
    area += x * v - u * y;
    length += Math.hypot(u - x, v - y);
  });
  return [area, length];
}

/** How wide parts are in the middle if the longest side of all of them is `size` long, thinnest first. */
export function widths(document: Document, size: number): { id: string; width: number }[] {
  const points = document.parts.flatMap((part) => part.outline.flat());
  const sides = ([0, 1] as const).map((k) => {
    const along = points.map((point) => point[k]);
    return along.reduce((most, x) => Math.max(most, x), -Infinity) - along.reduce((least, x) => Math.min(least, x), Infinity);
  });
  const scale = size / Math.max(...sides);
  return document.parts
    .map(({ id, outline }) => {
      const rings = outline.map(measure);
      const area = Math.abs(rings.reduce((sum, [twice]) => sum + twice, 0));
      return { id, width: (scale * area) / rings.reduce((sum, [, length]) => sum + length, 0) };
    })
    .sort((a, b) => a.width - b.width);
}
