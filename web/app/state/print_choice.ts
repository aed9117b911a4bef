import type { SolidOptions } from '../../engine/messages';

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
