import { expect, it } from 'vitest';
import { names } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });

/** A snowman with ink lines, as a PNG file. */
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

it('guesses the parts of a flat picture, which can then be changed as any others', async () => {
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
