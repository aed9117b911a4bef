/** Colours of labels: each far from those of the labels before it, and the same in every session. */

type Rgb = readonly [number, number, number];

/** The step from hue to hue, the golden ratio: it spreads hues evenly, however many there are. */
const golden = 0.618034;
/** Hues become similar again after 5, 8 or 13 labels; the lightness then differs. */
const lightness = [0.4, 0.54, 0.68] as const;

/** Converts a colour with values in [0, 1] to channels in [0, 255]. */
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
