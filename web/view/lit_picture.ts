/** Ambient light, and the light that the lamp adds. */
const ambient = 0.35;
const lamp = 0.75;

/** The position of the lamp to the right and up, each in [-1, 1]. */
export type Aim = readonly [number, number];

/** Returns the unit vector (right, up, towards the viewer) to a lamp. */
export function lightFrom([right, up]: Aim): readonly [number, number, number] {
  const toViewer = Math.sqrt(Math.max(0.05, 1 - right * right - up * up));
  const length = Math.hypot(right, up, toViewer);
  return [right / length, up / length, toViewer / length];
}

/**
 * Lights a drawing as a game does: each pixel of `drawing` by the normal in the same pixel of the normal
 * map, whose green points up. Both are straight RGBA of the same size, and so is the result.
 */
export function litPicture(drawing: Uint8ClampedArray, normals: Uint8ClampedArray, aim: Aim): Uint8ClampedArray<ArrayBuffer> {
  const light = lightFrom(aim);
  const lit = new Uint8ClampedArray(drawing.length);
  for (let i = 0; i < lit.length; i += 4) {
    let facing = 0;
    for (let k = 0; k < 3; k++) facing += ((normals[i + k] as number) / 127.5 - 1) * (light[k] as number);
    const brightness = ambient + lamp * Math.max(0, facing);
    for (let k = 0; k < 3; k++) lit[i + k] = (drawing[i + k] as number) * brightness;
    lit[i + 3] = Math.min(drawing[i + 3] as number, normals[i + 3] as number);
  }
  return lit;
}
