import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { choosePart, sample } from './actions.ts';
import { settled, stageOfFile } from './browser.ts';
import { mainThreadTasks } from './trace.ts';

const stage = stageOfFile({ anew: false });

/** Longest task that a hand does not feel, ms of processor time. */
const longest = 100;

async function wander(selector: string, pressed: boolean): Promise<void> {
  const { page } = stage;
  const box = await page.locator(selector).first().boundingBox();
  if (!box) throw new Error(`no ${selector}`);
  await page.mouse.move(box.x + 120, box.y + 300);
  if (pressed) await page.mouse.down();
  for (let i = 0; i < 12; i++) await page.mouse.move(box.x + 120 + 20 * i, box.y + 300 + 6 * i);
  if (pressed) await page.mouse.up();
  await page.waitForTimeout(300);
}

const deeds: Record<string, () => Promise<void>> = {
  'opening a sample': () => sample(stage.page, 'elephant'),
  'wandering over the relief': () => wander('.model canvas', false),
  'turning the relief': () => wander('.model canvas', true),
  'wandering over the drawing': () => wander('.paper canvas', false),
  'changing a part': async () => {
    await choosePart(stage.page, 'body');
    await stage.page.locator('.slider input').first().fill('6');
    await settled(stage.page);
  },
  'undoing': async () => {
    await stage.page.click('#undo');
    await settled(stage.page);
  },
};

it.each(Object.keys(deeds))('keeps the page free for the hand while %s', async (name) => {
  const tasks = await mainThreadTasks(stage.page, deeds[name] as () => Promise<void>);
  expect(tasks.length).toBeGreaterThan(10);
  console.info(`${name}: longest task ${Math.max(...tasks).toFixed(0)} ms of processor time`);
  expect(Math.max(...tasks)).toBeLessThan(longest);
  expect(stage.troubles).toEqual([]);
});

it('leaves the graphics, which may make their thread wait, to a worker', async () => {
  await stage.page.goto(stage.url);
  await sample(stage.page, 'bunny');
  const taken = await stage.page.locator('.model canvas').evaluate((canvas: HTMLCanvasElement) => {
    try {
      return canvas.getContext('webgl2') === null;
    } catch {
      return true;
    }
  });
  expect(taken).toBe(true);
});

it('is loaded with no more than a megabyte, compressed, samples included', () => {
  const built = fileURLToPath(new URL('../../../build/web', import.meta.url));
  const files = readdirSync(built, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const sizes = files.map((file) => [file.name, brotliCompressSync(readFileSync(join(file.parentPath, file.name))).length] as const);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  console.info(`${files.length} files, ${Math.round(total / 1000)} kB compressed`);
  expect(total).toBeLessThan(1_000_000);
});
