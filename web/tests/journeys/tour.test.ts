import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { gesture, names, pageView, type Spot } from './actions.ts';
import { picture, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

const tail: Spot[] = [[300, 430], [240, 400], [150, 300], [110, 200], [150, 190], [200, 280], [260, 350], [310, 400]];

async function atStep(page: Page, step: number): Promise<void> {
  await page.waitForSelector(`.tour[data-step="${step}"]`);
  // Screen readers read the step out.
  expect(await page.evaluate(() => document.activeElement?.matches('.tour'))).toBe(true);
}

it('offers the tour once, and doing each step leads to the next', async () => {
  const { page } = stage;
  const images = page.locator('.samples img');
  await expect.poll(() => images.evaluateAll((all) => all.every((image) => (image as HTMLImageElement).naturalWidth > 200))).toBe(true);
  expect(await images.count()).toBe(6);
  await picture(page, 'start-first-visit');
  await page.click('#begin-tour');
  await atStep(page, 0);
  const before = await names(page);
  await picture(page, 'tour-draw');
  await gesture(page, tail);
  await atStep(page, 1);
  expect(await names(page)).toHaveLength(before.length + 1);
  await page.getByText('Take me there').click();
  const box = await page.locator('.model canvas').boundingBox();
  if (!box) throw new Error('no relief');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 65, y - 20, { steps: 6 });
  await page.mouse.up();
  await atStep(page, 2);
  await picture(page, 'tour-turned');
  await page.click('#export');
  await page.click('#print');
  await atStep(page, 3);
  await picture(page, 'tour-printed');
  await page.getByRole('button', { name: 'Done' }).click();
  await page.waitForSelector('.tour', { state: 'detached' });
  await page.reload();
  await page.waitForSelector('#empty');
  expect(await page.locator('#begin-tour').count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('can be done by keys alone', async () => {
  const { page } = stage;
  const press = async (key: string, times = 1): Promise<void> => {
    for (let i = 0; i < times; i++) await page.keyboard.press(key);
  };
  await page.click('#empty');
  await page.locator('#tour').focus();
  await press('Enter');
  await atStep(page, 0);
  const show = async (): Promise<void> => {
    await press('Tab', 2);
    await press('Enter');
  };
  await show();
  await press('Shift+ArrowLeft', 2);
  await press('Enter');
  await press('Shift+ArrowLeft', 3);
  await press('ArrowUp', 4);
  await press('Shift+ArrowRight', 3);
  await picture(page, 'tour-keys');
  await press('Enter');
  await atStep(page, 1);
  await show();
  await press('ArrowRight', 4);
  await atStep(page, 2);
  await show();
  await press('Enter');
  await page.locator('#print').focus();
  await press('Enter');
  await atStep(page, 3);
  expect(stage.troubles).toEqual([]);
});

it('does not cover the drawing on a phone', async () => {
  const { page } = stage;
  await page.setViewportSize({ width: 390, height: 844 });
  try {
    await page.click('#empty');
    await page.locator('#tour').click();
    await atStep(page, 0);
    await picture(page, 'tour-phone');
    const card = await page.locator('.tour').boundingBox();
    const { at } = await pageView(page);
    expect(card?.y).toBeGreaterThan(at([300, 700])[1]);
    await gesture(page, tail);
    await atStep(page, 1);
    await picture(page, 'tour-phone-turn');
  } finally {
    await page.setViewportSize({ width: 1360, height: 800 });
  }
  expect(stage.troubles).toEqual([]);
});
