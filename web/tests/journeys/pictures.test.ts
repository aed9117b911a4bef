import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { pngOf } from '../support/pictures.ts';
import { names } from './actions.ts';
import { coloursOfRelief, picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: false });

/** Returns a PNG file of a snowman with ink lines. */
function snowman(): Promise<string> {
  const canvas = document.createElement('canvas');
  canvas.width = 600;
  canvas.height = 800;
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, 600, 800);
  context.lineWidth = 7;
  context.strokeStyle = '#222';
  for (const [y, rx, ry, color] of [[560, 190, 180, '#cfe3f2'], [320, 140, 130, '#dcebf6'], [150, 95, 90, '#eaf3fa']] as const) {
    context.beginPath();
    context.ellipse(300, y, rx, ry, 0, 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
    context.stroke();
  }
  return new Promise((resolve) => resolve(canvas.toDataURL('image/png')));
}

/** Returns a picture of an orange ball that blends into green paper over two pixels. */
function ballOnGreen(): Buffer {
  return Buffer.from(pngOf(600, 600, (x, y) => {
    const share = Math.min(1, Math.max(0, (200.5 - Math.hypot(x - 299.5, y - 299.5)) / 2));
    const mix = (paint: number, paper: number): number => Math.round(share * paint + (1 - share) * paper);
    return [mix(230, 40), mix(130, 170), mix(40, 60), 255];
  }));
}

/** Counts the greenish colours of the relief. */
async function green(page: Page): Promise<number> {
  return (await coloursOfRelief(page)).filter(([red, green_]) => green_ > 1.15 * red).length;
}

it('shows no paper colour on the rim of a turned relief', async () => {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', { name: 'ball.png', mimeType: 'image/png', buffer: ballOnGreen() });
  await page.waitForSelector('.parts li');
  await settled(page);
  await page.locator('.model canvas').focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowRight');
  await expect.poll(() => green(page)).toBe(0);
  await picture(page, 'rim-without-paper');
  expect(stage.troubles).toEqual([]);
});

it('guesses the parts of a flat picture, which can then be edited like any others', async () => {
  const { page } = stage;
  const url = await page.evaluate(snowman);
  const buffer = Buffer.from(url.split(',')[1] ?? '', 'base64');
  await page.setInputFiles('input[type=file]', { name: 'snowman.png', mimeType: 'image/png', buffer });
  await page.waitForSelector('.parts li');
  await settled(page);
  await picture(page, 'guessed');
  expect((await names(page)).length).toBe(3);
  await page.keyboard.press('Control+z');
  expect(await page.locator('.parts li').count()).toBe(0);
  await page.keyboard.press('Control+Shift+z');
  await settled(page);
  expect(stage.troubles).toEqual([]);
});

it('draws contours as lines of any width, or leaves them out', async () => {
  const { page } = stage;
  // The words on the buttons are dark too.
  const dark = async (): Promise<number> => (await coloursOfRelief(page)).filter((colour) => Math.max(...colour) < 80).length;
  const dressed = (width: number): Promise<unknown> => page.waitForSelector(`.model[data-contours="${width}"]`, { timeout: 60_000 });
  const changeSettings = async (change: () => Promise<void>): Promise<void> => {
    const settings = page.getByRole('button', { name: 'Settings' });
    await settings.click();
    await change();
    await settings.click();
  };
  await page.locator('.model canvas').focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowRight');
  await dressed(1);
  await changeSettings(() => page.getByLabel('Width of contours').fill('2.5'));
  await dressed(2.5);
  await stillPicture(page, 'broad-contours');
  const broad = await dark();
  await changeSettings(() => page.locator('#contours').uncheck());
  await dressed(0);
  await expect.poll(dark).toBeLessThan(0.8 * broad);
  await picture(page, 'no-contours');
  await page.keyboard.press('Control+z');
  await dressed(2.5);
  await expect.poll(dark).toBe(broad);
  expect(stage.troubles).toEqual([]);
});
