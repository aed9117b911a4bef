import * as Comlink from 'comlink';
import type { AnimationEndpoint } from './animation_worker';
import type { ModelView } from './model_view';

/** Steps from one side to the other, longest side, px, and duration of a picture, ms. */
const steps = 20;
const side = 480;
const delay = 50;
/** Largest angle to each side, radians; a relief has no back to show. */
const lean = 0.75;

/** Returns the angle of a pendulum on its way from one side to the other. */
function angleAt(step: number): number {
  return -lean * Math.cos((Math.PI * step) / steps);
}

/** Returns the order of the pictures for swaying there and back, starting at the front. */
function swayOrder(): number[] {
  const there = Array.from({ length: steps }, (_, i) => i);
  const cycle = [...there, ...there.map((i) => steps - i)];
  return [...cycle.slice(steps / 2), ...cycle.slice(0, steps / 2)];
}

/** Records the model on its way from one side to the other, lit and zoomed as now. The page stays responsive. */
async function recordSway(view: ModelView, ground: string): Promise<ImageData[]> {
  const { yaw, pitch } = view.angles;
  const pictures: ImageData[] = [];
  try {
    for (let step = 0; step <= steps; step++) {
      view.turn(angleAt(step), pitch);
      pictures.push(await view.snapshot(side, ground));
    }
  } finally {
    view.turn(yaw, pitch);
  }
  return pictures;
}

/** Returns a GIF file of the model swaying from side to side forever. */
export async function swayingGif(view: ModelView, ground: string): Promise<Uint8Array<ArrayBuffer>> {
  const recorded = await recordSway(view, ground);
  const { width, height } = recorded[0] as ImageData;
  const pictures = recorded.map((picture) => picture.data as Uint8ClampedArray<ArrayBuffer>);
  const animation = { pictures, width, height, order: swayOrder(), delay };
  const worker = new Worker(new URL('./animation_worker.ts', import.meta.url), { type: 'module' });
  try {
    const moved = Comlink.transfer(animation, pictures.map((picture) => picture.buffer));
    return new Uint8Array(await Comlink.wrap<AnimationEndpoint>(worker).encode(moved));
  } finally {
    worker.terminate();
  }
}
