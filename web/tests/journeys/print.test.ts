import { unzipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { downloaded, sample } from './actions.ts';
import { picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

beforeEach(() => stage.page.setDefaultTimeout(60_000));

/** Returns the sides of the solid, mm, and its volume, cm³, as the panel shows them once they differ from `before`. */
async function facts(page: Page, before = ''): Promise<{ text: string; numbers: number[] }> {
  await page.waitForFunction((old) => {
    const now = document.querySelector('#solid-facts')?.textContent ?? '';
    return now !== '' && now !== old;
  }, before);
  const text = (await page.locator('#solid-facts').textContent()) ?? '';
  return { text, numbers: (text.match(/[0-9.]+/g) ?? []).map(Number) };
}

/** Waits for the model, which the processor draws here. */
async function drawnPicture(page: Page, name: string): Promise<void> {
  await stillPicture(page, name);
}

async function openPrint(page: Page): Promise<void> {
  await page.click('#export');
  await page.click('#print');
}

it('shows plaques, cut-outs, medals and figures in millimetres, and their files', async () => {
  const { page } = stage;
  await sample(page, 'lamb');
  await openPrint(page);
  const plaque = await facts(page);
  expect(Math.max(...plaque.numbers.slice(0, 3))).toBeCloseTo(100, 0);
  await drawnPicture(page, 'print-plaque');
  await page.click('[data-kind=medal]');
  const medal = await facts(page, plaque.text);
  expect(medal.numbers[0]).toBeCloseTo(medal.numbers[1]!, 0);
  await page.locator('.print .slider input').first().fill('12');
  const low = await facts(page, medal.text);
  expect(low.numbers[2]).toBeLessThan(12.1);
  await drawnPicture(page, 'print-medal');
  await page.click('[data-kind=figure]');
  await facts(page, low.text);
  await drawnPicture(page, 'print-figure');
  const printed = await downloaded(page, () => page.click('[data-solid="3mf"]'), 'lamb.3mf');
  expect(Object.keys(unzipSync(new Uint8Array(printed)))).toContain('3D/3dmodel.model');
  const stl = await downloaded(page, () => page.click('[data-solid=stl]'), 'lamb-figure.stl');
  expect(stl.length).toBe(84 + 50 * stl.readUInt32LE(80));
  await page.keyboard.press('Escape');
  await page.locator('.print').waitFor({ state: 'detached' });
  await settled(page);
  await picture(page, 'print-closed');
  expect(stage.troubles).toEqual([]);
});

it('shows the findings of the print check with the size that fixes them', async () => {
  const { page } = stage;
  await sample(page, 'wolf');
  await openPrint(page);
  const plaque = await facts(page);
  expect(await page.locator('.finding').count()).toBe(0);
  await page.click('[data-kind=figure]');
  let now = await facts(page, plaque.text);
  await page.locator('[data-trouble=overhang]').waitFor();
  await drawnPicture(page, 'print-findings');
  const size = page.locator('.print input[type=number]');
  const neck = page.locator('[data-trouble=neck]');
  let millimetres = 10;
  for (let round = 0; round < 4; ++round) {
    await size.fill(String(millimetres));
    await size.blur();
    now = await facts(page, now.text);
    if ((await neck.count()) === 0) break;
    const enough = Number(/make the model (\d+) mm/.exec((await neck.textContent()) ?? '')?.[1]);
    expect(enough).toBeGreaterThan(millimetres);
    millimetres = enough;
  }
  expect(millimetres).toBeGreaterThan(10);
  expect(await neck.count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('exports a web page and a model for phones', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  await page.click('#export');
  const html = (await downloaded(page, () => page.click('[data-export=html]'), 'bunny.html')).toString();
  expect(html).toContain('<canvas>');
  expect(html).not.toMatch(/https?:\/\//);
  const usdz = await downloaded(page, () => page.click('[data-export=usdz]'), 'bunny.usdz');
  expect(Object.keys(unzipSync(new Uint8Array(usdz)))).toEqual(['relief.usda', 'drawing.png']);
  expect(stage.troubles).toEqual([]);
});

it('shows the maps under a lamp that is dragged', async () => {
  const { page } = stage;
  await sample(page, 'lamb');
  await page.click('#export');
  await page.click('#lit-maps');
  const canvas = page.locator('.lit-maps');
  await canvas.waitFor();
  await canvas.scrollIntoViewIfNeeded();
  const box = (await canvas.boundingBox())!;
  /** Returns the mean brightness of the pixels that are not transparent. */
  const brightness = (): Promise<number> =>
    canvas.evaluate((node) => {
      const { width, height } = node as HTMLCanvasElement;
      const { data } = (node as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
      let sum = 0;
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (data[i + 3]! > 128) [sum, count] = [sum + data[i]!, count + 1];
      return sum / count;
    });
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForTimeout(300);
  const front = await brightness();
  await page.mouse.move(box.x + box.width - 4, box.y + 8);
  await page.waitForTimeout(300);
  await picture(page, 'lit-maps');
  expect(await brightness()).toBeLessThan(0.95 * front);
  expect(stage.troubles).toEqual([]);
});
