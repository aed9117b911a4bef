import { createRequire } from 'node:module';
import { expect, it } from 'vitest';
import { sample } from './actions.ts';
import { picture, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });
const emulator = createRequire(import.meta.url).resolve('iwer/build/iwer.min.js');

it('shows the model in the room if the browser can, and comes back', async () => {
  const { page } = stage;
  await sample(page, 'unicorn');
  await page.click('#export');
  await page.waitForSelector('[data-export=turntable]');
  expect(await page.locator('#room').count()).toBe(0);

  await page.addInitScript({ path: emulator });
  await page.addInitScript(() => {
    const { IWER } = window as unknown as { IWER: { XRDevice: new (kind: unknown) => { installRuntime(how: object): void }; metaQuest3: unknown } };
    const device = new IWER.XRDevice(IWER.metaQuest3);
    device.installRuntime({ forceInstall: true });
    Object.assign(window, { headset: device });
  });
  await page.reload();
  await page.waitForSelector('[data-sample]');
  await sample(page, 'unicorn');
  await page.click('#export');
  // The emulated headset draws over the middle of the page.
  const look = (): Promise<Buffer> => page.screenshot({ clip: { x: 580, y: 300, width: 170, height: 200 } });
  const alone = await look();
  const canvases = await page.locator('canvas').count();
  await page.click('#room');
  await expect.poll(async () => (await look()).equals(alone)).toBe(false);
  await picture(page, 'room');
  expect(await page.locator('canvas').count()).toBe(canvases + 1);
  const before = await look();
  await page.evaluate(async () => {
    const { headset } = window as unknown as { headset: { controllers: { right?: { position: { set(x: number, y: number, z: number): void }; updateButtonValue(name: string, value: number): void } } } };
    const hand = headset.controllers.right;
    if (!hand) throw new Error('no hand');
    hand.position.set(0.02, 1.3, -0.3);
    const frames = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 300));
    await frames();
    hand.updateButtonValue('trigger', 1);
    await frames();
    hand.updateButtonValue('trigger', 0);
  });
  await expect.poll(async () => (await look()).equals(before)).toBe(false);
  await picture(page, 'room-placed');
  await page.evaluate(() => (window as unknown as { headset: { activeSession?: { end(): Promise<void> } } }).headset.activeSession?.end());
  await expect.poll(() => page.locator('canvas').count()).toBe(canvases);
  expect(await page.locator('#room').isVisible()).toBe(true);
  expect(stage.troubles).toEqual([]);
});
