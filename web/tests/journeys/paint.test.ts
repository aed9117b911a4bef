import { unzipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { gesture, names, oval, pageView, sample, save, type Spot } from './actions.ts';
import { picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

interface Head {
  paint?: { color: string | null; width: number; points: Spot[] }[];
  settings: { inkColor: string; inkWidth: number };
}

async function head(page: Page): Promise<Head> {
  const project = unzipSync(await save(page, 'paint.relievo'));
  return JSON.parse(new TextDecoder().decode(project['project.json'])) as Head;
}

/** Returns the colour on the screen at a px of the page. */
async function shown(page: Page, [x, y]: Spot, size?: Spot): Promise<number[]> {
  const { at } = await pageView(page, size);
  const box = await page.locator('.paper canvas').first().boundingBox();
  const [sx, sy] = at([x, y]);
  return page.locator('.paper canvas').first().evaluate((node: HTMLCanvasElement, [left, top]) => {
    const ratio = window.devicePixelRatio;
    return [...(node.getContext('2d')?.getImageData(Math.round(left! * ratio), Math.round(top! * ratio), 1, 1).data ?? [])].slice(0, 3);
  }, [sx - (box?.x ?? 0), sy - (box?.y ?? 0)]);
}

const red: [number, number, number] = [226, 125, 138];
const isRed = (color: number[]): boolean => color.every((value, i) => Math.abs(value - red[i]!) < 12);

it('adds eyes by a tap and a stroke, glued to the part below', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(500, 400, 220, 190));
  await settled(page);
  await page.click('#eyes');
  await gesture(page, [[420, 350], [580, 350]]);
  expect((await names(page)).filter((name) => name.startsWith('eye'))).toHaveLength(2);
  expect((await names(page)).filter((name) => name.startsWith('pupil'))).toHaveLength(2);
  await gesture(page, [[500, 480]]);
  expect((await names(page)).filter((name) => name.startsWith('eye'))).toHaveLength(3);
  await page.keyboard.press('Control+z');
  await settled(page);
  await page.click('#settings');
  await page.locator('#ink-color').fill('#204080');
  await page.locator('.slider input').nth(2).fill('3');
  expect((await head(page)).settings).toMatchObject({ inkColor: '#204080', inkWidth: 3 });
  await page.keyboard.press('Escape');
  await settled(page);
  await stillPicture(page, 'eyes');
  expect(stage.troubles).toEqual([]);
});

it('paints on the drawing and on the relief, rubs out, undoes, and keeps it in the project', async () => {
  const { page } = stage;
  await sample(page, 'elephant');
  const size: Spot = [1000, 800];
  await page.keyboard.press('b');
  await page.locator('.paint-bar input[type=range]').fill('30');
  const before = await shown(page, [600, 330], size);
  await gesture(page, [[520, 330], [600, 330], [680, 360]], size);
  await page.waitForTimeout(300);
  expect(isRed(before)).toBe(false);
  expect(isRed(await shown(page, [600, 330], size))).toBe(true);
  await picture(page, 'paint-drawing');

  const box = await page.locator('.model canvas').boundingBox();
  if (!box) throw new Error('no relief');
  await page.locator('.paint-bar [data-color="#8fb8de"]').click();
  const middle: Spot = [box.x + 0.55 * box.width, box.y + 0.5 * box.height];
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 60, middle[1] + 20, { steps: 8 });
  await page.mouse.up();
  await stillPicture(page, 'paint-relief');
  const painted = (await head(page)).paint ?? [];
  expect(painted.map(({ color, width }) => [color, width])).toEqual([['#e27d8a', 30], ['#8fb8de', 30]]);
  for (const [x, y] of painted[1]!.points) {
    expect(x).toBeGreaterThan(0);
    expect(x).toBeLessThan(size[0]);
    expect(y).toBeGreaterThan(0);
    expect(y).toBeLessThan(size[1]);
  }

  await page.click('#rub-out');
  await gesture(page, [[600, 300], [600, 360]], size);
  await page.waitForTimeout(300);
  expect(await shown(page, [600, 330], size)).toEqual(before);
  await page.keyboard.press('Control+z');
  await page.waitForTimeout(300);
  expect(isRed(await shown(page, [600, 330], size))).toBe(true);

  const file = await save(page, 'painted.relievo');
  await page.click('.brand');
  await page.setInputFiles('input[type=file]', { name: 'painted.relievo', mimeType: 'application/zip', buffer: file });
  await settled(page);
  await page.waitForTimeout(300);
  expect(isRed(await shown(page, [600, 330], size))).toBe(true);
  expect((await head(page)).paint).toEqual(painted);
  expect(stage.troubles).toEqual([]);
});
