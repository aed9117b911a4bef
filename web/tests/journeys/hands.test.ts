import type { CDPSession } from 'playwright-core';
import { expect, it } from 'vitest';
import { gesture, names, oval, pageView, sample, type Spot } from './actions.ts';
import { changedRelief, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

/** Returns the leftmost and topmost pixels of paper on the screen. */
async function paperBox(): Promise<{ left: number; top: number; width: number }> {
  return stage.page.locator('.paper canvas').first().evaluate((canvas: HTMLCanvasElement) => {
    const { width, height } = canvas;
    const { data } = (canvas.getContext('2d') as CanvasRenderingContext2D).getImageData(0, 0, width, height);
    const covered = (x: number, y: number): boolean => (data[4 * (y * width + x) + 3] as number) > 0;
    let [left, right, top] = [width, 0, height];
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++)
        if (covered(x, y)) [left, right, top] = [Math.min(left, x), Math.max(right, x), Math.min(top, y)];
    return { left, top, width: right - left };
  });
}

async function emptyPage(): Promise<void> {
  await stage.page.click('#empty');
  await gesture(stage.page, oval(500, 400, 150, 100));
  await settled(stage.page);
}

it('pans with the space bar, the middle button and the wheel, and draws nothing meanwhile', async () => {
  const { page } = stage;
  await emptyPage();
  const before = await paperBox();
  const { at } = await pageView(page);
  const [x, y] = at([300, 300]);
  await page.mouse.move(x, y);
  await page.keyboard.down('Space');
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 40, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up('Space');
  await page.waitForTimeout(100);
  expect((await paperBox()).left).toBeCloseTo(before.left + 60, -0.5);
  await page.mouse.down({ button: 'middle' });
  await page.mouse.move(x, y, { steps: 4 });
  await page.mouse.up({ button: 'middle' });
  await page.waitForTimeout(100);
  expect((await paperBox()).left).toBeCloseTo(before.left, -0.5);
  await page.mouse.wheel(-30, -50);
  await page.waitForTimeout(100);
  const wheeled = await paperBox();
  expect([wheeled.left - before.left, wheeled.top - before.top]).toEqual([30, 50]);
  expect((await names(page)).length).toBe(1);
  expect(stage.troubles).toEqual([]);
});

it('zooms about the pointer with the wheel and Ctrl, and about the middle by keys', async () => {
  const { page } = stage;
  await emptyPage();
  const before = await paperBox();
  const { at } = await pageView(page);
  await page.mouse.move(...at([0, 0]));
  await page.keyboard.down('Control');
  await page.mouse.wheel(0, 120);
  await page.keyboard.up('Control');
  await page.waitForTimeout(100);
  const smaller = await paperBox();
  expect(smaller.width / before.width).toBeCloseTo(Math.exp(-0.5), 1);
  expect(Math.abs(smaller.left - before.left)).toBeLessThan(3);
  await page.keyboard.press('0');
  await page.waitForTimeout(100);
  expect(await paperBox()).toEqual(before);
  await page.keyboard.press('-');
  await page.waitForTimeout(100);
  expect((await paperBox()).width / before.width).toBeCloseTo(0.8, 1);
  expect(stage.troubles).toEqual([]);
});

function touch(session: CDPSession, type: 'touchStart' | 'touchMove' | 'touchEnd', spots: Spot[]): Promise<unknown> {
  const touchPoints = spots.map(([x, y], id) => ({ x, y, id }));
  return session.send('Input.dispatchTouchEvent', { type, touchPoints });
}

it('pinches with two fingers, and draws with one', async () => {
  const { page } = stage;
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto(stage.url);
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
  const { at } = await pageView(page);
  const spots = oval(500, 400, 200, 150).map(at);
  await touch(session, 'touchStart', [spots[0]!]);
  for (const spot of spots.slice(1)) await touch(session, 'touchMove', [spot]);
  await touch(session, 'touchEnd', []);
  await page.waitForSelector('.parts li', { state: 'attached' });
  expect((await names(page)).length).toBe(1);
  await settled(page);
  await stillPicture(page, 'phone');
  const before = await paperBox();
  const [x, y] = (await pageView(page)).at([500, 400]);
  await touch(session, 'touchStart', [[x - 30, y], [x + 30, y]]);
  for (let i = 1; i <= 6; i++) await touch(session, 'touchMove', [[x - 30 + 2.5 * i, y], [x + 30 - 2.5 * i, y]]);
  await touch(session, 'touchEnd', []);
  await page.waitForTimeout(200);
  expect((await paperBox()).width / before.width).toBeCloseTo(0.5, 1);
  expect((await names(page)).length).toBe(1);
  // A tap of two fingers undoes.
  await touch(session, 'touchStart', [[x - 30, y], [x + 30, y]]);
  await touch(session, 'touchEnd', []);
  await page.waitForFunction(() => document.querySelectorAll('.parts li').length === 0);
  await session.send('Emulation.setTouchEmulationEnabled', { enabled: false });
  await session.detach();
  await page.setViewportSize({ width: 1360, height: 800 });
  expect(stage.troubles).toEqual([]);
});

it('orders by dragging in the list and by Page Up, Page Down, Home and End', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  const [first, second, third] = await names(page);
  const items = page.locator('.parts li');
  await items.nth(0).dragTo(items.nth(2));
  expect((await names(page)).slice(0, 3)).toEqual([second, third, first]);
  await items.nth(2).focus();
  await items.nth(2).click();
  await page.keyboard.press('PageUp');
  await page.keyboard.press('PageUp');
  expect((await names(page)).slice(0, 3)).toEqual([first, second, third]);
  await page.keyboard.press('End');
  expect((await names(page)).at(-1)).toBe(first);
  await page.keyboard.press('Home');
  expect((await names(page))[0]).toBe(first);
  await page.keyboard.press('PageDown');
  expect((await names(page)).slice(0, 2)).toEqual([second, first]);
  expect(stage.troubles).toEqual([]);
});

it('turns the relief by arrow keys', async () => {
  const { page } = stage;
  await sample(page, 'lamb');
  await page.locator('.model canvas').focus();
  await changedRelief(page, () => page.keyboard.press('ArrowRight'));
  expect(stage.troubles).toEqual([]);
});

it('can be installed', async () => {
  const { page } = stage;
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  const session = await page.context().newCDPSession(page);
  const { errors } = await session.send('Page.getAppManifest');
  expect(errors).toEqual([]);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  const ids = installabilityErrors.map((error) => error.errorId);
  // A browser without a window reports itself as private, which is no error of the page.
  expect(ids.filter((id) => id !== 'in-incognito')).toEqual([]);
  await session.detach();
  expect(stage.troubles).toEqual([]);
});
