import { unzipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { disc } from '../support/pictures.ts';
import { downloaded, pageView, type Spot } from './actions.ts';
import { closeStage, openStage, picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });
const file = { name: 'disc.png', mimeType: 'image/png', buffer: Buffer.from(disc(400, 140, [200, 80, 60])) };

/** Presses Tab until an element has the focus. */
async function tabTo(page: Page, selector: string): Promise<void> {
  for (let i = 0; i < 80; i++) {
    if (await page.evaluate((wanted) => document.activeElement?.matches(wanted) ?? false, selector)) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`${selector} is not reached`);
}

async function chosen(page: Page, act: () => Promise<void>): Promise<void> {
  const asked = page.waitForEvent('filechooser');
  await page.evaluate(() => document.hasFocus()); // after a round trip the browser has delivered its dialogs
  await act();
  await (await asked).setFiles(file);
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await page.waitForSelector('.parts li', { state: 'attached' });
}

/** Checks that the mesh of a 3MF package is closed: every edge occurs once in each direction. */
function expectPrint(bytes: Buffer): void {
  const model = new TextDecoder().decode(unzipSync(new Uint8Array(bytes))['3D/3dmodel.model']);
  const edges = new Map<string, number>();
  const corners = [...model.matchAll(/v1="(\d+)" v2="(\d+)" v3="(\d+)"/g)].map((match) => match.slice(1));
  expect(corners.length).toBeGreaterThan(5000);
  for (const triangle of corners)
    triangle.forEach((from, k) => edges.set(`${from} ${triangle[(k + 1) % 3]}`, (edges.get(`${from} ${triangle[(k + 1) % 3]}`) ?? 0) + 1));
  const open = [...edges].filter(([edge, count]) => count !== 1 || edges.get(edge.split(' ').reverse().join(' ')) !== 1);
  expect(open).toEqual([]);
}

it('goes from a flat picture to a print by keys alone', async () => {
  const { page } = stage;
  await tabTo(page, '#choose');
  await chosen(page, () => page.keyboard.press('Enter'));
  await settled(page);
  await tabTo(page, '[data-tool=scribble]');
  await page.keyboard.press('ArrowUp');
  await page.waitForSelector('[data-tool=hand][aria-pressed=true]');
  await page.keyboard.press('ArrowDown');
  await tabTo(page, '.paper canvas');
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.stroke-list li');
  await tabTo(page, '.parts li');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.part-panel');
  await tabTo(page, '.part-panel .slider input');
  await page.keyboard.press('ArrowRight');
  await settled(page);
  await page.keyboard.press('Control+e');
  await tabTo(page, '#print');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#solid-facts');
  await tabTo(page, '[data-solid="3mf"]');
  await picture(page, 'keys-alone');
  expectPrint(await downloaded(page, () => page.keyboard.press('Enter'), 'keys.3mf'));
  expect(stage.troubles).toEqual([]);
});

it('goes from a flat picture to a print by touch alone, on a phone', async () => {
  const phone = await openStage(['--touch-events=enabled']);
  try {
    const { page } = phone;
    await page.setViewportSize({ width: 390, height: 844 });
    const session = await page.context().newCDPSession(page);
    await session.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', spots: Spot[]): Promise<unknown> =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: spots.map(([x, y], id) => ({ x, y, id })) });
    const tap = async (selector: string): Promise<void> => {
      await page.locator(selector).first().scrollIntoViewIfNeeded();
      const box = await page.locator(selector).first().boundingBox();
      if (!box) throw new Error(`${selector} cannot be touched`);
      await touch('touchStart', [[box.x + box.width / 2, box.y + box.height / 2]]);
      await touch('touchEnd', []);
    };
    await chosen(page, () => tap('#choose'));
    await settled(page);
    const { at } = await pageView(page, [400, 400]);
    const stroke: Spot[] = [[150, 200], [200, 180], [250, 200], [250, 230]];
    await touch('touchStart', [at(stroke[0] as Spot)]);
    for (const spot of stroke.slice(1)) await touch('touchMove', [at(spot)]);
    await touch('touchEnd', []);
    await page.waitForSelector('.stroke-list li', { state: 'attached' });
    await settled(page);
    await stillPicture(page, 'phone-paper');
    await tap('.model .swap');
    await page.waitForSelector('.workspace[data-pane=model]');
    await tap('#light');
    await stillPicture(page, 'phone-model');
    await tap('#side');
    await page.waitForSelector('.parts li');
    await tap('.parts li');
    await page.waitForSelector('.part-panel');
    await picture(page, 'phone-parts');
    await tap('#side');
    await tap('.paper .swap');
    await tap('#peek');
    await page.waitForSelector('canvas.peek.shown');
    await tap('#peek');
    await tap('#export');
    await tap('#print');
    await tap('[data-kind=figure]');
    await page.waitForSelector('#solid-facts');
    await stillPicture(page, 'phone-print');
    expectPrint(await downloaded(page, () => tap('[data-solid="3mf"]'), 'touch.3mf'));
    expect(phone.troubles).toEqual([]);
  } finally {
    await closeStage(phone);
  }
});
