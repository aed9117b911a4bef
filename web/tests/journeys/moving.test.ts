import { expect, it } from 'vitest';
import { choosePart, gesture, names, outlineOf, oval, sample, type Spot } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

function shiftBetween(a: Spot[], b: Spot[]): Spot {
  expect(b.length).toBe(a.length);
  return [b[0]![0] - a[0]![0], b[0]![1] - a[0]![1]];
}

it('moves parts that were drawn by hand, with the pointer and with arrows, and gives them a flat top', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(500, 420, 200, 150));
  await gesture(page, [[600, 500], [640, 640], [660, 720], [700, 730], [720, 640], [690, 480]]);
  await settled(page);
  const [leg, body] = await names(page) as [string, string];
  const before = await outlineOf(page, leg);
  await page.keyboard.press('1');
  await gesture(page, [[670, 660], [610, 680]]);
  await settled(page);
  const [dx, dy] = shiftBetween(before, await outlineOf(page, leg));
  expect([Math.abs(dx + 60) < 3, Math.abs(dy - 20) < 3]).toEqual([true, true]);
  await page.locator('.paper canvas').first().focus();
  for (const key of ['ArrowUp', 'ArrowUp', 'Shift+ArrowRight']) await page.keyboard.press(key);
  const pushed = shiftBetween(before, await outlineOf(page, leg));
  expect([Math.round(pushed[0] - dx), Math.round(pushed[1] - dy)]).toEqual([10, -2]);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await outlineOf(page, leg)).toEqual(before);

  await choosePart(page, body);
  await page.getByLabel('Flat top').fill('0.9');
  await settled(page);
  await picture(page, 'flat-top');
  await page.keyboard.press('Escape');
  await page.click('#undo');
  await choosePart(page, body);
  expect(await page.getByLabel('Flat top').inputValue()).toBe('0');
  expect(stage.troubles).toEqual([]);
});

it('does not move parts that the drawing shows', async () => {
  const { page } = stage;
  await sample(page, 'wolf');
  const [first] = await names(page) as [string];
  const place = await outlineOf(page, first);
  await choosePart(page, first);
  await page.locator('.paper canvas').first().focus();
  await page.keyboard.press('ArrowLeft');
  expect(await outlineOf(page, first)).toEqual(place);
  expect(stage.troubles).toEqual([]);
});
