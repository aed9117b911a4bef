import type { Document, Ring } from '../document/document';
import { area, boxOf, perimeter } from '../document/outline';
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

/** How wide parts are in the middle if the longest side of all of them is `size` long, thinnest first. */
export function widths({ parts }: Document, size: number): { id: string; width: number }[] {
  const { min, max } = boxOf(parts.map(({ outline }) => Object.values(boxOf(outline))));
  const scale = size / Math.max(max[0] - min[0], max[1] - min[1]);
  const sum = (outline: readonly Ring[], of: (ring: Ring) => number): number => outline.reduce((total, ring) => total + of(ring), 0);
  return parts
    .map(({ id, outline }) => ({ id, width: (2 * scale * Math.abs(sum(outline, area))) / sum(outline, perimeter) }))
    .sort((a, b) => a.width - b.width);
}
