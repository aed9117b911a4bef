/** A 4 × 4 matrix, column by column. */
export type Mat4 = Float32Array;

type Vector = readonly [number, number, number];

/** The size of a model: metres per px, and its middle, px, which becomes the origin. */
interface Sized {
  readonly scale: number;
  readonly middle: Vector;
}

/** Returns the size with which the longer of the two sides of a model across the page, in px, is `length` m long. */
export function scaledTo(positions: Float32Array, length: number): Sized {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3] as number, x);
    max[i % 3] = Math.max(max[i % 3] as number, x);
  });
  const side = (k: 0 | 1 | 2): number => (max[k] as number) - (min[k] as number);
  const middle = (k: 0 | 1 | 2): number => ((max[k] as number) + (min[k] as number)) / 2;
  return { scale: length / Math.max(side(0), side(1), 1e-9), middle: [middle(0), middle(1), middle(2)] };
}

/** Returns the matrix that places a model upright, `reach` m in front of a pose of eyes or of a hand and facing it. */
export function placed({ scale, middle }: Sized, pose: Float32Array, reach: number): Mat4 {
  const column = (k: number): Vector => [pose[4 * k] as number, pose[4 * k + 1] as number, pose[4 * k + 2] as number];
  const back = column(2);
  const from = column(3);
  const level = Math.hypot(back[0], back[2]);
  const [sin, cos] = level < 1e-6 ? [0, 1] : [back[0] / level, back[2] / level];
  const at = ([0, 1, 2] as const).map((k) => from[k] - reach * back[k]) as [number, number, number];
  const [x, y, z] = middle;
  return new Float32Array([
    scale * cos, 0, -scale * sin, 0,
    0, scale, 0, 0,
    scale * sin, 0, scale * cos, 0,
    at[0] - scale * (cos * x + sin * z), at[1] - scale * y, at[2] - scale * (cos * z - sin * x), 1,
  ]);
}
