import * as Comlink from 'comlink';
import { encode } from 'modern-gif';

interface Animation {
  /** RGBA, all of one size. */
  pictures: readonly Uint8ClampedArray<ArrayBuffer>[];
  width: number;
  height: number;
  /** Indices of the pictures in the order in which they are shown. */
  order: readonly number[];
  /** Duration of each picture, ms. */
  delay: number;
}

const endpoint = {
  /** Encodes a GIF file that repeats forever. */
  async encode({ pictures, width, height, order, delay }: Animation): Promise<ArrayBuffer> {
    const frames = order.map((index) => ({ data: pictures[index] ?? new Uint8ClampedArray(4 * width * height), delay }));
    const bytes = await encode({ width, height, frames, looped: true });
    return Comlink.transfer(bytes, [bytes]);
  },
};

export type AnimationEndpoint = typeof endpoint;

Comlink.expose(endpoint);
