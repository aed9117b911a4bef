import { labelColor } from '../engine/label_colors';

/** Colours of annotations, those of the paper where it has them. */
export const marks = {
  join: '#2f6fed',
  equal: '#13b5c4',
  above: '#d4459e',
  below: '#7a1f6a',
  gap: '#e5119b',
  culprit: '#e0392b',
  select: '#f28c28',
  ink: '#2b2d33',
} as const;

/** Returns green where a range is soft (alpha 0) to red where it is firm (1), as in the paper's figure 5. */
export function rampColor(alpha: number): string {
  const t = Math.min(1, Math.max(0, alpha));
  return `hsl(${Math.round(130 * (1 - t))} 75% 42%)`;
}

/** Returns the colour of a label, as in the tint. */
export function inkOf(label: number): string {
  return `rgb(${labelColor(label).join(' ')})`;
}
