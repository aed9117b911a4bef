import { expect, it } from 'vitest';
import { sample } from './actions.ts';
import { changedRelief, picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

/** Sets a mesh that takes long enough to solve for the checks made meanwhile. */
async function chooseNonlinear(): Promise<void> {
  const { page } = stage;
  await page.click('#settings');
  await page.locator('.sheet .slider input').first().fill('100000');
  await page.locator('.sheet select').first().selectOption('nonlinear');
  await page.click('#settings');
}

it('plots the energy of the non-linear method as it falls, and shows h, f and g', async () => {
  const { page } = stage;
  await sample(page, 'wolf');
  await chooseNonlinear();
  await page.waitForFunction(() => Number(document.querySelector<HTMLElement>('.energy')?.dataset['steps'] ?? 0) >= 2);
  await picture(page, 'nonlinear-running');
  await settled(page);
  for (const field of ['inflation', 'shift', 'relief']) {
    await changedRelief(page, async () => {
      await page.click(`[data-field=${field}]`);
      await page.waitForFunction((name) => document.querySelector(`[data-field=${name}]`)?.getAttribute('aria-pressed') === 'true', field);
    });
    await stillPicture(page, `nonlinear-${field}`);
  }
  expect(stage.troubles).toEqual([]);
});

it('stops the non-linear method when asked, and keeps the coarse relief', async () => {
  const { page } = stage;
  await sample(page, 'wolf');
  await chooseNonlinear();
  await page.waitForSelector('.stop button');
  await page.click('.stop button');
  await page.waitForFunction(() => document.querySelector<HTMLElement>('.numbers')?.dataset['phase'] === 'idle');
  expect(await page.locator('.stop').count()).toBe(0);
  expect(Number(await page.locator('.numbers').getAttribute('data-nodes'))).toBeGreaterThan(0);
  expect(stage.troubles).toEqual([]);
});
