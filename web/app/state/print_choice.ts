import type { SolidOptions } from '../../engine/messages';

export type PrintKind = 'plaque' | 'cutout' | 'medal' | 'figure';

/** The object to print; lengths in mm. */
export interface PrintChoice {
  readonly kind: PrintKind;
  /** Largest depth of the whole; 0: as deep as the relief is. */
  readonly height: number;
  readonly detail: boolean;
  readonly thickness: number;
  readonly hang: 'none' | 'hole' | 'ring';
}

export const usualPrint: PrintChoice = { kind: 'plaque', height: 0, detail: false, thickness: 2, hang: 'none' };

/** Diameter of the hole that the object hangs by, mm. */
const hole = 4;

const bases = { plaque: 'plate', cutout: 'outline', medal: 'round', figure: 'none' } as const;

/** Returns the engine's options for a choice. `size` is the longest side, mm. */
export function solidOptions({ kind, height, detail, thickness, hang }: PrintChoice, size: number): SolidOptions {
  const plate = kind !== 'figure';
  return {
    size, height, detail, thickness,
    back: plate ? 'flat' : 'plain',
    base: bases[kind],
    hole: plate && hang === 'hole' ? hole : 0,
    ring: plate && hang === 'ring' ? hole : 0,
  };
}
