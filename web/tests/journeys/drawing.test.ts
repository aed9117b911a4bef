import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { closeStage, openStage, picture, settled, type Stage } from './browser.ts';

let stage: Stage;
beforeAll(async () => {
  stage = await openStage();
});
afterAll(() => closeStage(stage));

type Spot = [number, number];

/** A stroke of the hand over the page, in shares of the pane. */
async function stroke(page: Page, spots: Spot[]): Promise<void> {
  const box = await page.locator('.paper canvas').first().boundingBox();
  if (!box) throw new Error('no page to draw on');
  const at = ([x, y]: Spot): Spot => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(spots[0]!));
  await page.mouse.down();
  for (const spot of spots.slice(1)) await page.mouse.move(...at(spot));
  await page.mouse.up();
}

function arc(x: number, y: number, rx: number, ry: number, from: number, to: number): Spot[] {
  return Array.from({ length: 41 }, (_, i) => {
    const angle = from + ((to - from) * i) / 40;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });
}

const names = (page: Page): Promise<string[]> => page.locator('.parts .name').allInnerTexts();

it('makes a figure of strokes on an empty page', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  await stroke(page, arc(0.55, 0.48, 0.24, 0.13, 0, 2 * Math.PI));
  await stroke(page, arc(0.3, 0.36, 0.1, 0.1, 0, 2 * Math.PI));
  const leg: Spot[] = [
    [0.44, 0.5], [0.435, 0.55], [0.43, 0.6], [0.43, 0.66], [0.44, 0.7], [0.47, 0.72], [0.5, 0.7],
    [0.51, 0.66], [0.51, 0.6], [0.505, 0.55], [0.5, 0.5],
  ];
  await stroke(page, leg);
  await settled(page);
  expect(await names(page)).toEqual(['part 3', 'part 2', 'part']);
  // The open stroke is joined to the body, the closed one is not.
  expect(await page.locator('.parts li .joined').count()).toBe(1);
  await picture(page, 'strokes');
  expect(stage.troubles).toEqual([]);
});

it('undoes all of it and brings it back', async () => {
  const { page } = stage;
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  expect(await names(page)).toEqual([]);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+Shift+z');
  expect(await names(page)).toEqual(['part 3', 'part 2', 'part']);
});

it('shows the depth under the page while the key is held', async () => {
  const { page } = stage;
  await settled(page);
  await page.mouse.move(100, 400);
  await page.keyboard.down('v');
  await page.mouse.move(120, 420);
  await page.waitForTimeout(600);
  await picture(page, 'peek');
  await page.keyboard.up('v');
  await page.waitForTimeout(600);
  expect(await page.locator('canvas.peek.shown').count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});
