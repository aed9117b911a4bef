import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { root } from '../support/command_line.ts';
import { pngOf } from '../support/pictures.ts';
import { randomNumbers } from '../unit/random.ts';
import { choosePart, pageView, sample, save } from './actions.ts';
import { pictures, settled, stageOfFile } from './browser.ts';
import { longestOfWorkers, mainThreadTasks } from './trace.ts';

const stage = stageOfFile({ anew: false });

/** Longest task that a user does not notice, ms of processor time on the usual machine. */
const longest = 100;
/** Processor time of `work` there, ms. */
const usualWork = 40;

/** Work of a fixed amount: elements are made, laid out and removed. */
function work(): void {
  const place = document.body.appendChild(document.createElement('div'));
  place.innerHTML = Array.from({ length: 4000 }, (_, i) => `<p>${i} <b>${i * i}</b></p>`).join('');
  place.getBoundingClientRect();
  place.remove();
}

/** Returns how many times slower than the usual machine this one is, at least 1. Limits are so much higher. */
async function slowness(): Promise<number> {
  const times: number[] = [];
  for (let i = 0; i < 3; i++) times.push(Math.max(...(await mainThreadTasks(stage.page, () => stage.page.evaluate(work)))));
  const [, median = 0] = times.sort((a, b) => a - b);
  console.info(`fixed work: ${median.toFixed(0)} ms of processor time`);
  return Math.max(1, median / usualWork);
}

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
  'undoing or redoing': async () => {
    // If the test is tried again, the change is undone already.
    await stage.page.click('#undo:enabled, #redo:enabled');
    await settled(stage.page);
  },
};

/** Returns a picture of a ring on grainy paper, which hardly compresses. */
function grainyDrawing(): Uint8Array {
  const random = randomNumbers(5);
  return pngOf(2000, 1400, (x, y) => {
    const ink = Math.abs(Math.hypot(x - 1000, y - 700) - 500) < 6;
    const grain = (): number => (ink ? 10 : 244) + Math.floor(11 * random());
    return [grain(), grain(), grain(), 255];
  });
}

/** Returns a drawing of fifty discs in ten rows that overlap their neighbours. */
function manyParts(): string {
  const discs = Array.from({ length: 50 }, (_, i) => {
    const [x, y] = [100 + 90 * (i % 5), 80 + 55 * Math.floor(i / 5)];
    return `<circle class="part" id="disc-${i}" cx="${x}" cy="${y}" r="60" fill="hsl(${7 * i},60%,60%)"/>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" width="560" height="660">${discs.join('')}</svg>`;
}

it.each(Object.keys(deeds))('keeps the page free for the hand while %s', async (name) => {
  const tasks = await mainThreadTasks(stage.page, deeds[name] as () => Promise<void>);
  expect(tasks.length).toBeGreaterThan(10);
  console.info(`${name}: longest task ${Math.max(...tasks).toFixed(0)} ms of processor time`);
  expect(Math.max(...tasks)).toBeLessThan(longest * (await slowness()));
  expect(stage.troubles).toEqual([]);
});

it('keeps the page responsive with fifty parts', async () => {
  const { page } = stage;
  const buffer = Buffer.from(manyParts());
  const tasks = await mainThreadTasks(page, async () => {
    await page.setInputFiles('input[type=file]', { name: 'many.svg', mimeType: 'image/svg+xml', buffer });
    await page.locator('.parts li').nth(49).waitFor();
    await settled(page);
    await choosePart(page, 'disc-20');
    await page.locator('.slider input').first().fill('6');
    await settled(page);
    await wander('.model canvas', true);
    await wander('.paper canvas', false);
  });
  console.info(`fifty parts: longest task ${Math.max(...tasks).toFixed(0)} ms of processor time`);
  expect(Math.max(...tasks)).toBeLessThan(longest * (await slowness()));
  expect(stage.troubles).toEqual([]);
});

it('needs little processor time for a coarse relief, for a full one and for a tint', async () => {
  const { page } = stage;
  const slider = page.locator('.slider input').first();
  await choosePart(page, 'body');
  await slider.fill('3');
  await settled(page);
  const [full, coarse] = await longestOfWorkers(page, async () => {
    await slider.fill('5');
    await settled(page);
  });
  await page.setInputFiles('input[type=file]', join(root, 'examples/bear.png'));
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await settled(page);
  // The relief is dressed once the hand has rested.
  await page.waitForTimeout(2500);
  const { at } = await pageView(page, [900, 1000]);
  await page.mouse.move(...at([430, 620]));
  await page.mouse.down();
  const [tint] = await longestOfWorkers(page, async () => {
    for (const x of [440, 460, 480]) {
      await page.mouse.move(...at([x, 660]));
      await page.waitForTimeout(300);
    }
  });
  await page.keyboard.press('Escape');
  await page.mouse.up();
  console.info(`full relief ${full?.toFixed(0)}, coarse one ${coarse?.toFixed(0)}, tint ${tint?.toFixed(0)} ms of processor time`);
  expect(Math.min(full!, coarse!, tint!)).toBeGreaterThan(1);
  expect(full).toBeLessThan(1000);
  expect(coarse).toBeLessThan(150);
  expect(tint).toBeLessThan(150);
});

it('keeps the page responsive while a large drawing is opened, saved and opened again', async () => {
  const { page } = stage;
  const drawing = join(pictures, 'grain.png');
  writeFileSync(drawing, grainyDrawing());
  const tasks = await mainThreadTasks(page, async () => {
    await page.setInputFiles('input[type=file]', drawing);
    await page.waitForSelector('.scribble-bar[data-tint-ms]');
    await settled(page);
    await save(page, 'grain.relievo');
    await page.setInputFiles('input[type=file]', join(pictures, 'grain.relievo'));
    await page.waitForSelector('[data-tool=select][aria-pressed=true]');
    await settled(page);
  });
  for (const name of ['grain.png', 'grain.relievo']) expect(statSync(join(pictures, name)).size).toBeGreaterThan(3_000_000);
  console.info(`large drawing: longest task ${Math.max(...tasks).toFixed(0)} ms of processor time`);
  expect(Math.max(...tasks)).toBeLessThan(longest * (await slowness()));
  expect(stage.troubles).toEqual([]);
});

it('draws in a worker, since graphics may block their thread', async () => {
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

it('loads at most 1.4 megabytes, compressed as by a static host, samples included', () => {
  const built = fileURLToPath(new URL('../../../build/web', import.meta.url));
  const files = readdirSync(built, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const sizes = files.map((file) => [file.name, gzipSync(readFileSync(join(file.parentPath, file.name))).length] as const);
  // A visit loads at most one language besides English.
  const words = sizes.filter(([name]) => /^(french|german|japanese|spanish)-/.test(name)).map(([, size]) => size);
  expect(words.length).toBe(4);
  // The first flat drawing loads the network.
  const [network] = sizes.filter(([name]) => name.startsWith('network-')).map(([, size]) => size);
  expect(network).toBeLessThan(400_000);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0) - network! - words.reduce((sum, size) => sum + size, 0) + Math.max(...words);
  console.info(`${files.length} files, ${Math.round(total / 1000)} kB compressed`);
  expect(total).toBeLessThan(1_400_000);
});
