import { unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { choosePart, sample, save, type Spot } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

interface SavedPart { id: string; lean?: Spot }

async function leanOf(name: string): Promise<Spot | undefined> {
  const project = unzipSync(await save(stage.page, 'leaning.relievo'));
  const scene = JSON.parse(new TextDecoder().decode(project['scene.json'])) as { parts: SavedPart[] };
  return scene.parts.find((part) => part.id === name)?.lean;
}

it('leans a part to the right and to the bottom, and back', async () => {
  const { page } = stage;
  await sample(page, 'wolf');
  await choosePart(page, 'body');
  const model = page.locator('.model canvas').first();
  const before = await model.screenshot();
  await page.getByLabel('Right nearer').fill('0.5');
  await settled(page);
  await page.getByLabel('Base nearer').fill('-0.25');
  await settled(page);
  await picture(page, 'lean');
  expect((await model.screenshot()).equals(before)).toBe(false);
  expect(await leanOf('body')).toEqual([0.5, -0.25]);
  await page.keyboard.press('Escape');
  await page.click('#undo');
  await choosePart(page, 'body');
  expect(await page.getByLabel('Right nearer').inputValue()).toBe('0');
  expect(await page.getByLabel('Base nearer').inputValue()).toBe('0');
  expect(await leanOf('body')).toBeUndefined();
  expect(stage.troubles).toEqual([]);
});
