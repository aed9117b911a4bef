/** The colours of labels: far from those of the labels before, the same in every session. */

type Rgb = readonly [number, number, number];

const golden = 0.618034;
/** Hues come near again after 5, 8 or 13 steps; these do not then. */
const lightness = [0.4, 0.54, 0.68] as const;

/** In [0, 255], of values in [0, 1]. */
function rgbOf(hue: number, saturation: number, lightness: number): Rgb {
  const amplitude = saturation * Math.min(lightness, 1 - lightness);
  const channel = (shift: number): number => {
    const k = (shift + 12 * hue) % 12;
    return Math.round(255 * (lightness - amplitude * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

export function labelColor(label: number): Rgb {
  return rgbOf((0.06 + label * golden) % 1, 0.75, lightness[label % 3] as number);
}
