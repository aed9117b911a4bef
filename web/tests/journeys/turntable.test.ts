import { decode, decodeFrames } from 'modern-gif';
import { expect, it } from 'vitest';
import { downloaded, sample } from './actions.ts';
import { picture, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });

/** Returns the share of pixels that differ clearly. */
function difference(a: Uint8ClampedArray, b: Uint8ClampedArray): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) if (Math.abs(a[i]! - b[i]!) > 24) count++;
  return (4 * count) / a.length;
}

it('records the model swaying from side to side forever', async () => {
  const { page } = stage;
  // Without a graphics processor each picture takes half a second.
  page.setDefaultTimeout(100_000);
  await sample(page, 'lamb');
  await page.click('#export');
  await picture(page, 'export-views');
  const bytes = new Uint8Array(await downloaded(page, () => page.click('[data-export=turntable]'), 'turntable.gif'));
  const gif = decode(bytes);
  expect([gif.version, gif.frames.length, gif.looped]).toEqual(['89a', 40, true]);
  expect(Math.max(gif.width, gif.height)).toBe(480);
  const frames = decodeFrames(bytes, { gif });
  const [first, right, middle, left] = [0, 10, 20, 30].map((i) => frames[i]!.data) as [Uint8ClampedArray, Uint8ClampedArray, Uint8ClampedArray, Uint8ClampedArray];
  expect(difference(right, left)).toBeGreaterThan(0.05);
  expect(difference(first, right)).toBeGreaterThan(0.02);
  // The model passes the front on its way back and ends where it began.
  expect(difference(first, middle)).toBeLessThan(0.01);
  expect(difference(first, frames[39]!.data)).toBeLessThan(difference(first, right));
  expect(stage.troubles).toEqual([]);
});
