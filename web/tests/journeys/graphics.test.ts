import { expect, it } from 'vitest';
import { choosePart, sample } from './actions.ts';
import { changedRelief, closeStage, openStage, picture, settled, stageOfFile } from './browser.ts';
import { killGraphics } from './storage.ts';

const stage = stageOfFile({ anew: true });

/** How many colours a screenshot of the relief has: a blank pane has few. */
async function colours(page: typeof stage.page): Promise<number> {
  const shot = (await page.locator('.model canvas').screenshot()).toString('base64');
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context?.drawImage(image, 0, 0);
    const { data: pixels } = context?.getImageData(0, 0, image.width, image.height) ?? { data: [] };
    const seen = new Set<number>();
    for (let i = 0; i < pixels.length; i += 4) seen.add(((pixels[i] as number) << 16) + ((pixels[i + 1] as number) << 8) + (pixels[i + 2] as number));
    return seen.size;
  }, shot);
}

it('brings the relief back, as it was turned, when the graphics end', async () => {
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

it('draws the relief without graphics, says so, and lets it be turned and picked', async () => {
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
