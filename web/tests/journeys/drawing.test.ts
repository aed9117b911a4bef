import { expect, it } from 'vitest';
import { gesture, names, oval, type Spot } from './actions.ts';
import { picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: false });

const leg: Spot[] = [
  [420, 480], [415, 560], [410, 650], [415, 700], [450, 720], [490, 700], [500, 650], [500, 560], [495, 480],
];

it('makes a figure of strokes on an empty page, undoes it and brings it back', async () => {
  const { page } = stage;
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  await gesture(page, oval(560, 420, 260, 150));
  await gesture(page, oval(300, 280, 120, 110));
  await gesture(page, leg);
  await gesture(page, leg.map(([x, y]) => [x + 230, y]));
  await settled(page);
  const drawn = ['part 4', 'part 3', 'part 2', 'part'];
  expect(await names(page)).toEqual(drawn);
  // Open strokes are joined to the body, closed ones are not.
  expect(await page.locator('.parts li .joined').count()).toBe(2);
  await picture(page, 'strokes');
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  expect(await names(page)).toEqual([]);
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+Shift+z');
  expect(await names(page)).toEqual(drawn);
  expect(stage.troubles).toEqual([]);
});

it('tilts the page into depth while the key is held', async () => {
  const { page } = stage;
  await page.goto(stage.url);
  await page.click('[data-sample=unicorn]');
  await settled(page);
  await page.mouse.move(100, 400);
  await page.keyboard.down('v');
  await page.mouse.move(120, 420);
  await page.waitForSelector('canvas.peek.shown');
  await stillPicture(page, 'peek');
  await page.keyboard.up('v');
  await page.waitForFunction(() => !document.querySelector('canvas.peek.shown, canvas.peek.leaving'));
  expect(stage.troubles).toEqual([]);
});
