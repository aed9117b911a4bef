import { expect, it } from 'vitest';
import { placed, scaledTo } from '../../view/room_place';
import { randomNumbers } from './random';

type Vector = [number, number, number];

function moved(matrix: Float32Array, [x, y, z]: Vector): Vector {
  const row = (k: number): number => matrix[k]! * x + matrix[4 + k]! * y + matrix[8 + k]! * z + matrix[12 + k]!;
  return [row(0), row(1), row(2)];
}

/** Returns a pose somewhere that looks to the left and upwards by the given angles. */
function poseOf(yaw: number, pitch: number, at: Vector): Float32Array {
  const [s, c, u, v] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  return new Float32Array([c, 0, -s, 0, s * u, v, c * u, 0, s * v, -u, c * v, 0, ...at, 1]);
}

const positions = new Float32Array([100, 50, -20, 500, 50, 0, 100, 250, 30, 500, 250, 10]);

it('a model in the room has the given size, around its middle', () => {
  const { scale, middle } = scaledTo(positions, 0.1);
  expect(scale * 400).toBeCloseTo(0.1);
  expect(middle).toEqual([300, 150, 5]);
});

it('it stands upright in front of the viewer, wherever that is, and faces them', () => {
  const random = randomNumbers(3);
  const sized = scaledTo(positions, 0.1);
  for (let k = 0; k < 50; k++) {
    const at: Vector = [4 * random() - 2, 2 * random(), 4 * random() - 2];
    const pose = poseOf(6 * random(), random() - 0.5, at);
    const place = placed(sized, pose, 0.7);
    const middle = moved(place, [300, 150, 5]);
    expect(Math.hypot(...middle.map((x, i) => x - at[i]!))).toBeCloseTo(0.7, 4);
    const ahead: Vector = [pose[8]!, pose[9]!, pose[10]!];
    middle.forEach((x, i) => expect(x).toBeCloseTo(at[i]! - 0.7 * ahead[i]!, 4));
    const up = moved(place, [300, 250, 5]).map((x, i) => x - middle[i]!);
    [0, 100 * sized.scale, 0].forEach((x, i) => expect(up[i]).toBeCloseTo(x, 6));
    const front = moved(place, [300, 150, 105]).map((x, i) => x - middle[i]!) as Vector;
    expect(front[0] * ahead[0] + front[2] * ahead[2]).toBeGreaterThan(0);
    expect(front[0] * ahead[2] - front[2] * ahead[0]).toBeCloseTo(0, 5);
  }
});
