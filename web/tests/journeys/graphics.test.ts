import { expect, it } from 'vitest';
import { choosePart, sample } from './actions.ts';
import { changedRelief, closeStage, coloursOfRelief, openStage, picture, settled, stageOfFile } from './browser.ts';
import { killGraphics } from './storage.ts';

const stage = stageOfFile({ anew: true });

/** Counts distinct colours; a blank pane has few. */
async function colours(page: typeof stage.page): Promise<number> {
  return (await coloursOfRelief(page)).length;
}

it('restores the relief, turned as before, when the graphics are lost', async () => {
  const { page } = stage;
  await sample(page, 'lamb');
  await page.locator('.model canvas').focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
  await page.waitForTimeout(1500);
  const before = await colours(page);
  expect(before).toBeGreaterThan(1000);
  await page.locator('.model canvas').evaluate((canvas: HTMLCanvasElement) => Object.assign(canvas.dataset, { lost: 'soon' }));
  killGraphics(stage.profile);
  await page.waitForSelector('.model canvas:not([data-lost])');
  await expect.poll(() => colours(page), { timeout: 30_000 }).toBeGreaterThan(before / 2);
  await picture(page, 'graphics-again');
  await choosePart(page, 'body');
  await page.locator('.slider input').first().fill('6');
  await settled(page);
});

it('draws the relief without 3D graphics, says so, and lets the user turn it and select parts', async () => {
  const plain = await openStage(['--use-gl=disabled']);
  try {
    const { page } = plain;
    await sample(page, 'lamb');
    await page.waitForSelector('.plain-graphics');
    await page.waitForFunction(() => document.querySelector('.numbers')?.textContent !== '');
    await picture(page, 'no-graphics');
    expect(await colours(page)).toBeGreaterThan(1000);
    const box = await page.locator('.model canvas').boundingBox();
    if (!box) throw new Error('no relief');
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await page.waitForSelector('.parts li[aria-selected=true]');
    await changedRelief(page, async () => {
      await page.mouse.move(box.x + 100, box.y + 100);
      await page.mouse.down();
      await page.mouse.move(box.x + 160, box.y + 100, { steps: 3 });
      await page.mouse.up();
    });
    await picture(page, 'no-graphics-turned');
  } finally {
    await closeStage(plain);
  }
});
