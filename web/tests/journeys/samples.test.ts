import { expect, it } from 'vitest';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });

it('shows the relief of a sample soon after a click', async () => {
  const { page } = stage;
  await page.waitForSelector('[data-sample=wolf] img');
  await picture(page, 'start');
  const begin = Date.now();
  await page.click('[data-sample=wolf]');
  await settled(page);
  console.info(`sample to full relief: ${Date.now() - begin} ms`);
  await picture(page, 'wolf');
  expect(stage.troubles).toEqual([]);
});
