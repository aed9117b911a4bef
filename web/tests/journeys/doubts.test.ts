import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { relievo, root } from '../support/command_line.ts';
import { gesture, names, oval, save, type Spot } from './actions.ts';
import { pngOf } from '../support/pictures.ts';
import { picture, pictures, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });
const size: Spot = [900, 1000];

interface Project {
  scene: { parts: { id: string }[]; joins: { upper: string; lower: string; line: Spot[] }[] };
  corrections: { order: unknown[]; joins: unknown[]; no_joins: unknown[] };
}

async function project(): Promise<Project> {
  const files = unzipSync(await save(stage.page, 'doubts.relievo'));
  const read = (name: string): unknown => JSON.parse(new TextDecoder().decode(files[name]));
  const { segmentation } = read('project.json') as { segmentation: Pick<Project, 'corrections'> };
  return { scene: read('scene.json') as Project['scene'], corrections: segmentation.corrections };
}

/** A head on a body, of two colours each, on feet: nothing tells which half is in front. */
function figure(): Uint8Array {
  const inside = (x: number, y: number, at: Spot, radii: Spot): boolean => Math.hypot((x - at[0]) / radii[0], (y - at[1]) / radii[1]) < 1;
  return pngOf(600, 600, (x, y) => {
    if (inside(x, y, [220, 540], [50, 40]) || inside(x, y, [380, 540], [50, 40])) return [120, 80, 40, 255];
    if (inside(x, y, [300, 170], [110, 100])) return x > 300 ? [210, 80, 110, 255] : [230, 190, 120, 255];
    if (inside(x, y, [300, 380], [150, 170])) return x > 300 ? [90, 140, 200, 255] : [200, 120, 60, 255];
    return [255, 255, 255, 255];
  });
}

it('asks about uncertain guesses one at a time, and accepts an answer or undoes it', async () => {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', { name: 'figure.png', mimeType: 'image/png', buffer: Buffer.from(figure()) });
  await page.waitForSelector('.parts li');
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await settled(page);
  const count = async (): Promise<number> => Number(await page.getAttribute('.doubt-bar', 'data-doubts'));
  const all = await count();
  expect(all).toBeGreaterThan(2);
  const goTo = async (kind: string): Promise<void> => {
    if (await page.isVisible('[data-doubt=close]')) await page.click('[data-doubt=close]');
    for (let k = 0; k < all && (await page.getAttribute('.doubt-bar', 'data-kind')) !== kind; ++k) await page.click('[data-doubt=next]');
    await page.waitForSelector(`.doubt-bar[data-kind=${kind}]`);
  };
  await goTo('order');
  await picture(page, 'doubt-order');
  const guessed = await names(page);
  await page.click('[data-doubt=yes]');
  await expect.poll(count).toBe(all - 1);
  expect((await project()).corrections.order).toHaveLength(1);
  expect(await names(page)).toEqual(guessed);
  await page.keyboard.press('Control+z');
  await expect.poll(count).toBe(all);

  await goTo('order');
  await page.click('[data-doubt=no]');
  await settled(page);
  expect(await names(page)).not.toEqual(guessed);
  await page.keyboard.press('Control+z');
  await settled(page);
  expect(await names(page)).toEqual(guessed);

  await goTo('join');
  await picture(page, 'doubt-join');
  const before = await project();
  await page.click('[data-doubt=no]');
  const after = await project();
  expect(after.scene.joins.length).toBe(before.scene.joins.length - 1);
  expect(after.corrections.no_joins).toHaveLength(1);
  await expect.poll(count).toBe(all - 1);
  expect(stage.troubles).toEqual([]);
});

it('accepts and undoes joins by a tap, and orders by a tap on the part that comes nearer', async () => {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', join(root, 'examples/bear.png'));
  await page.waitForSelector('.parts li');
  await settled(page);
  const { scene } = await project();
  const [first] = scene.joins;
  if (!first) throw new Error('nothing is joined');
  const middle = first.line[Math.floor(first.line.length / 2)] as Spot;
  await page.keyboard.press('3');
  await gesture(page, [middle], size);
  expect((await project()).scene.joins.map(({ upper }) => upper)).not.toContain(first.upper);
  await picture(page, 'join-refused');
  await gesture(page, [middle], size);
  expect((await project()).scene.joins.map(({ upper }) => upper)).toContain(first.upper);

  await page.click('.brand');
  await page.click('#empty');
  const box = (left: number, right: number): Spot[] => [[left, 200], [right, 200], [right, 500], [left, 500], [left, 202]];
  await gesture(page, box(200, 500));
  await gesture(page, box(400, 700));
  const drawn = await names(page);
  expect(drawn).toHaveLength(2);
  await page.keyboard.press('4');
  await gesture(page, [[300, 350]]);
  expect(await names(page)).toEqual([...drawn].reverse());
  await gesture(page, [[300, 350]]);
  expect(await page.locator('.notice').innerText()).toContain('in front');
  expect(await names(page)).toEqual([...drawn].reverse());
  await picture(page, 'order-tapped');
  // A tap on the outline of a part that lies on another switches their relation.
  await page.keyboard.press('2');
  await gesture(page, oval(300, 350, 30, 30));
  await page.keyboard.press('3');
  await gesture(page, [[330, 350]]);
  expect(await page.locator('.notice').innerText()).toContain('free');
  const file = unzipSync(await save(page, 'relation.relievo'));
  const { relations } = JSON.parse(new TextDecoder().decode(file['scene.json'])) as { relations: { relation: string }[] };
  expect(relations.map(({ relation }) => relation)).toEqual(['free']);
  expect(stage.troubles).toEqual([]);
});

it('finds as many parts as the slider demands, and the command line agrees', async () => {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', join(root, 'examples/bear.png'));
  await page.waitForSelector('.parts li');
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await settled(page);
  const guessed = await names(page);
  const slider = page.locator('.part-count input');
  expect(Number(await slider.inputValue())).toBe(guessed.length);
  const settleAt = async (count: number): Promise<string[]> => {
    await slider.fill(`${count}`);
    await expect.poll(() => page.locator('.parts li').count()).not.toBe(guessed.length);
    await page.waitForSelector('.scribble-bar[data-pending=false]');
    await settled(page);
    return names(page);
  };
  expect(await settleAt(6)).toHaveLength(6);
  await picture(page, 'parts-fewer');
  const again = join(pictures, 'six.json');
  relievo('segment', join(root, 'examples/bear.png'), '--parts', '6', '-o', again);
  const outlines = (scene: { parts: { outline: unknown }[] }): unknown => scene.parts.map(({ outline }) => outline);
  expect(outlines((await project()).scene as never)).toEqual(outlines(JSON.parse(readFileSync(again, 'utf8'))));
  await page.keyboard.press('Control+z');
  await settled(page);
  expect(await names(page)).toEqual(guessed);
  expect((await settleAt(18)).length).toBeGreaterThan(guessed.length);
  await picture(page, 'parts-more');
  expect(stage.troubles).toEqual([]);
});
