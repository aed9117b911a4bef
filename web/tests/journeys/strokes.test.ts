import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { disc } from '../support/pictures.ts';
import { randomNumbers } from '../unit/random.ts';
import { choosePart, fewVertices, names, oval, pageView, type Spot, stroke } from './actions.ts';
import { picture, settled, stageOfFile, stillPicture } from './browser.ts';
import { shelfOf } from './storage.ts';

const stage = stageOfFile({ anew: true });

function ellipse(x: number, y: number, rx: number, ry = rx): Spot[] {
  return oval(x, y, rx, ry).filter((_, i) => i % 2 === 0);
}

interface Said {
  parts: number;
  notice: string;
}

/** Returns the number of parts and the notice once the page has drawn the last stroke. */
function state(page: Page): Promise<Said> {
  return page.evaluate(async () => {
    await new Promise((resolve) => setTimeout(resolve));
    return {
      parts: document.querySelectorAll('.parts li').length,
      notice: document.querySelector('.notice')?.textContent ?? '',
    };
  });
}

/** Undoes down to one part if there are many. Chooses the tool again, which clears the notice. */
function fewParts(page: Page): Promise<void> {
  return page.evaluate(() => {
    const click = (selector: string): void => document.querySelector<HTMLElement>(selector)?.click();
    const parts = document.querySelectorAll('.parts li').length;
    if (parts > 5) for (let extra = parts - 1; extra > 0; extra--) click('#undo');
    click('[data-tool=draw]');
  });
}

/** Number of random strokes; more in the long run of all tests. */
const randomStrokes = process.env['RELIEVO_LONG'] ? 300 : 20;

it(`makes something of ${randomStrokes} random strokes, or says why not`, async () => {
  const { page } = stage;
  await page.setViewportSize({ width: 1000, height: 560 });
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  const random = randomNumbers(7);
  const between = (least: number, most: number): number => least + (most - least) * random();
  const shapes: (() => Spot[])[] = [
    () => ellipse(between(100, 900), between(100, 700), between(2, 150), between(2, 150)),
    () => [[between(50, 950), between(50, 750)], [between(50, 950), between(50, 750)]],
    () => Array.from({ length: Math.ceil(between(3, 12)) }, (): Spot => [between(100, 900), between(100, 700)]),
    () => Array.from({ length: 10 }, (_, i): Spot => [300 + i * between(5, 40), i % 2 ? 300 : between(300, 400)]),
    () => [[between(0, 1000), between(0, 800)]],
    () => Array.from({ length: 16 }, (_, i): Spot => [500 + 8 * i * Math.cos(i / 2), 400 + 8 * i * Math.sin(i / 2)]),
    () => Array.from({ length: 14 }, (_, i): Spot => [500 + 150 * Math.sin((i * 2 * Math.PI) / 13), 400 + 90 * Math.sin((i * 4 * Math.PI) / 13)]),
  ];
  await fewVertices(page);
  await stroke(page, ellipse(500, 400, 180, 130), at);
  let before = await state(page);
  let [made, refused] = [0, 0];
  for (let i = 0; i < randomStrokes; i++) {
    await stroke(page, (shapes[i % shapes.length] as () => Spot[])(), at);
    const after = await state(page);
    if (after.parts > before.parts) made++;
    else {
      expect(after.notice.length).toBeGreaterThan(10);
      refused++;
    }
    if (i === 11) await picture(page, 'random-strokes');
    await fewParts(page);
    before = await state(page);
    expect(before).toEqual({ parts: after.parts > 5 ? 1 : after.parts, notice: '' });
  }
  console.info(`${made} strokes made something, ${refused} were refused with a message`);
  expect(made).toBeGreaterThan(randomStrokes * 5 / 6);
  expect(stage.troubles).toEqual([]);
}, 300_000);

const leg = (x: number, y: number, down: number): Spot[] => [
  [x, y], [x - 4, y + 0.5 * down], [x - 14, y + 0.9 * down], [x + 4, y + down], [x + 40, y + down], [x + 58, y + 0.9 * down], [x + 52, y + 0.5 * down], [x + 56, y],
];
const ear = (x: number, y: number, lean: number): Spot[] => [[x, y], [x + lean - 8, y - 60], [x + lean + 12, y - 95], [x + lean + 38, y - 58], [x + 52, y]];

it('makes an animal of twelve gestures, all of it joined', async () => {
  const { page } = stage;
  await page.setViewportSize({ width: 1360, height: 800 });
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  const begun = Date.now();
  await stroke(page, oval(560, 430, 220, 125), at);
  await stroke(page, oval(320, 290, 125, 110), at);
  await page.click('#join-offer');
  await stroke(page, leg(420, 500, 200), at);
  await stroke(page, leg(650, 500, 200), at);
  await page.click('#behind');
  await stroke(page, leg(490, 500, 180), at);
  await stroke(page, leg(710, 490, 185), at);
  await page.click('#behind');
  await stroke(page, ear(235, 225, -25), at);
  await stroke(page, ear(345, 215, 25), at);
  await stroke(page, [[740, 390], [800, 340], [840, 290], [870, 220], [905, 190]], at);
  await stroke(page, ellipse(285, 275, 13, 17), at);
  await stroke(page, ellipse(360, 275, 13, 17), at);
  const drawn = Date.now() - begun;
  expect((await names(page)).length).toBe(11);
  // Head, legs, ears and tail; the eyes are details that lie on the head.
  const joins = async () => (await shelfOf(page)).find(({ parts }) => parts.at(-1) === 11)?.joins.at(-1);
  await expect.poll(joins, { timeout: 10_000 }).toBe(8);
  expect(drawn).toBeLessThan(40_000);
  console.info(`drawn in ${(drawn / 1000).toFixed(1)} s`);
  await settled(page);
  // Waits until nothing is selected and the texture has arrived.
  await page.keyboard.press('Escape');
  await stillPicture(page, 'animal');
  expect(stage.troubles).toEqual([]);
});

it('joins a head to what it lies on with J, and leaves its ear alone', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  await stroke(page, oval(560, 430, 220, 125), at);
  await stroke(page, oval(320, 290, 125, 110), at);
  await stroke(page, ear(345, 215, 25), at);
  expect(await page.locator('.parts li .joined').count()).toBe(1);
  await choosePart(page, 'part 2');
  await page.keyboard.press('j');
  await page.waitForFunction(() => document.querySelectorAll('.parts li .joined').length === 2);
  await page.keyboard.press('j');
  await page.waitForFunction(() => document.querySelectorAll('.parts li .joined').length === 1);
  await choosePart(page, 'part');
  await page.keyboard.press('j');
  expect((await state(page)).notice).not.toBe('');
  expect(await page.locator('.parts li .joined').count()).toBe(1);
  expect(stage.troubles).toEqual([]);
});

it('never makes a part of paper, wherever a scribble begins', async () => {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', { name: 'disc.png', mimeType: 'image/png', buffer: Buffer.from(disc(400, 120, [200, 80, 60])) });
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await page.waitForSelector('.parts li');
  const { at } = await pageView(page, [400, 400]);
  const before = await state(page);
  for (const spots of [[[20, 20], [60, 30], [120, 20]], [[0, 200], [2, 300]]] as Spot[][]) {
    await stroke(page, spots, at);
    await page.waitForFunction(() => document.querySelector('.notice')?.textContent !== '');
    expect((await state(page)).parts).toBe(before.parts);
    await page.keyboard.press('7');
  }
  // A stroke that continues into the figure counts only there.
  await stroke(page, [[20, 200], [60, 200], [140, 200], [200, 200], [240, 210]], at);
  await page.waitForTimeout(1500);
  expect((await state(page)).parts).toBe(before.parts);
  await picture(page, 'paper-stroke');
  expect(stage.troubles).toEqual([]);
});

it('shows the relief of a stroke while the pen is down, and takes it back when the stroke is cancelled', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  const nodes = (): Promise<number> => page.locator('.numbers').getAttribute('data-nodes').then(Number);
  const spots = oval(500, 400, 200, 150);
  await page.mouse.move(...at(spots[0] as Spot));
  await page.mouse.down();
  for (const spot of spots.slice(1, 22)) await page.mouse.move(...at(spot), { steps: 2 });
  await page.waitForFunction(() => Number(document.querySelector<HTMLElement>('.numbers')?.dataset['nodes']) > 500);
  expect((await state(page)).parts).toBe(0);
  await stillPicture(page, 'swelling');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector<HTMLElement>('.numbers')?.dataset['nodes'] === '0');
  expect((await state(page)).parts).toBe(0);
  await stroke(page, spots, at);
  await settled(page);
  const full = await nodes();
  // Draws out beside the present shape, and back to it.
  await page.mouse.move(...at([720, 300]));
  await page.mouse.down();
  for (const spot of [[800, 260], [860, 330], [800, 420]] as Spot[]) await page.mouse.move(...at(spot), { steps: 4 });
  await page.waitForFunction((before) => document.querySelector<HTMLElement>('.numbers')?.dataset['nodes'] !== String(before), full);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await page.waitForFunction((before) => document.querySelector<HTMLElement>('.numbers')?.dataset['nodes'] === String(before), full);
  expect((await state(page)).parts).toBe(1);
  expect(stage.troubles).toEqual([]);
});

it('colours a part by a swatch, with the limbs that are one surface with it', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  await stroke(page, oval(560, 430, 220, 125), at);
  await stroke(page, leg(420, 500, 200), at);
  await settled(page);
  await page.click('[data-color="#85b79d"]');
  const pixel = (spot: Spot): Promise<number[]> => {
    const [x, y] = at(spot);
    return page.locator('.paper canvas').first().evaluate((canvas: HTMLCanvasElement, [left, top]) => {
      const box = canvas.getBoundingClientRect();
      const ratio = canvas.width / box.width;
      return [...(canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(ratio * ((left as number) - box.x), ratio * ((top as number) - box.y), 1, 1).data.slice(0, 3)];
    }, [x, y]);
  };
  await page.keyboard.press('Escape');
  for (const spot of [[620, 400], [445, 640]] as Spot[]) await expect.poll(() => pixel(spot)).toEqual([0x85, 0xb7, 0x9d]);
  await stillPicture(page, 'coloured');
  expect(stage.troubles).toEqual([]);
});

it('folds a part to a ridge by a line on it, and undoes that', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const { at } = await pageView(page);
  await stroke(page, oval(500, 400, 260, 180), at);
  await settled(page);
  await page.keyboard.press('9');
  await page.click('[data-cue=crease]');
  await stroke(page, [[60, 60], [110, 70], [160, 80]], at);
  expect((await state(page)).notice).not.toBe('');
  await stroke(page, [[300, 400], [400, 398], [500, 400], [600, 402], [700, 400]], at);
  await page.waitForSelector('[data-cue=clear]');
  await settled(page);
  await stillPicture(page, 'cue');
  expect((await state(page)).notice).toBe('');
  expect(await page.locator('.trouble').count()).toBe(0);
  await page.click('[data-cue=clear]');
  await page.waitForSelector('[data-cue=clear]', { state: 'detached' });
  await page.click('#undo');
  await page.waitForSelector('[data-cue=clear]');
  expect(stage.troubles).toEqual([]);
});
