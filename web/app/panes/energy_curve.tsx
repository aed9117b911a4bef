import { t } from '../../words/catalogue';

/** Width and height of the plot, CSS px. */
const size = [120, 30] as const;

/**
 * Returns the points of a curve through the energies of all steps. Its scale is logarithmic and starts at the
 * lowest energy.
 */
function pathOf(energies: readonly number[]): string {
  const least = Math.min(...energies);
  const heights = energies.map((energy) => Math.log10(energy / least));
  const highest = Math.max(...heights, 1e-6);
  const [width, height] = size;
  return heights
    .map((h, i) => `${((i * width) / (energies.length - 1)).toFixed(1)},${(height * (1 - h / highest)).toFixed(1)}`)
    .join(' ');
}

/** Plots how the energy of the non-linear method falls. */
export function EnergyCurve({ energies }: { energies: readonly number[] }) {
  const last = energies.at(-1);
  if (last === undefined) return null;
  return (
    <span class="energy" data-steps={energies.length}>
      {energies.length > 1 && (
        <svg viewBox={`-2 -2 ${size[0] + 4} ${size[1] + 4}`} width={size[0]} height={size[1]} aria-hidden="true">
          <polyline points={pathOf(energies)} />
        </svg>
      )}
      {t('energy', { value: last.toPrecision(6) })}
    </span>
  );
}
