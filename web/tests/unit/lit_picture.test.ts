import { describe, expect, it } from 'vitest';
import { litPicture } from '../../view/lit_picture';

/** Pixels of the same colour with normals towards the viewer, to the right and upwards. */
const drawing = new Uint8ClampedArray([100, 100, 100, 255, 100, 100, 100, 255, 100, 100, 100, 128]);
const normals = new Uint8ClampedArray([128, 128, 255, 255, 255, 128, 128, 255, 128, 255, 128, 255]);

describe('a picture lit by its normal map', () => {
  const brightness = (right: number, up: number): number[] => {
    const lit = litPicture(drawing, normals, [right, up]);
    return [0, 4, 8].map((i) => lit[i] as number);
  };

  it('is brightest where the lamp shines straight on it', () => {
    const [front, right, upwards] = brightness(0, 0);
    expect(front).toBeGreaterThan(right as number);
    expect(right).toBe(upwards);
    expect(brightness(0.9, 0)[1]).toBeGreaterThan(brightness(0.9, 0)[2] as number);
    expect(brightness(0, 0.9)[2]).toBeGreaterThan(brightness(0, 0.9)[1] as number);
  });

  it('is dark, not black, on the far side, and as transparent as it was', () => {
    expect(brightness(-0.9, 0)[1]).toBe(35);
    expect(litPicture(drawing, normals, [0, 0])[11]).toBe(128);
  });
});
