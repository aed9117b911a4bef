import * as Comlink from 'comlink';
import { encode } from 'modern-gif';

interface Animation {
  /** RGBA, all of one size. */
  pictures: readonly Uint8ClampedArray<ArrayBuffer>[];
  width: number;
  height: number;
  /** Which picture is shown when. */
  order: readonly number[];
  /** How long each is shown, ms. */
  delay: number;
}

const endpoint = {
  /** A GIF file that is repeated without end. */
  async encode({ pictures, width, height, order, delay }: Animation): Promise<ArrayBuffer> {
    const frames = order.map((index) => ({ data: pictures[index] ?? new Uint8ClampedArray(4 * width * height), delay }));
    const bytes = await encode({ width, height, frames, looped: true });
    return Comlink.transfer(bytes, [bytes]);
  },
};

export type AnimationEndpoint = typeof endpoint;

Comlink.expose(endpoint);
