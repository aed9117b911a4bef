import { unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { openRing, openRingSize } from '../support/pictures.ts';
import { gesture, names, pageView, save, type Spot } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const size: Spot = [...openRingSize];
const stage = stageOfFile({ anew: true });

interface Stroke {
  kind: string;
  part?: string;
  points: Spot[];
}

async function strokes(): Promise<Stroke[]> {
  const project = unzipSync(await save(stage.page, 'gaps.relievo'));
  const head = JSON.parse(Buffer.from(project['project.json']!).toString()) as { segmentation: { scribbles: { strokes: Stroke[] } } };
  return head.segmentation.scribbles.strokes;
}

async function openDrawing(): Promise<void> {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', { name: 'ring.png', mimeType: 'image/png', buffer: Buffer.from(openRing()) });
  await page.waitForSelector('.parts li');
  await settled(page);
}

async function understood(): Promise<void> {
  await stage.page.waitForSelector('.scribble-bar[data-pending=false]');
}

it('shows the gaps that were closed and asks about each, undoably', async () => {
  const { page } = stage;
  await openDrawing();
  const guessed = await names(page);
  expect(guessed.length).toBe(2);
  await page.waitForSelector('.doubt-bar[data-doubts]');
  const doubts = Number(await page.getAttribute('.doubt-bar', 'data-doubts'));
  await gesture(page, [[370, 160]], size);
  await page.waitForSelector('.doubt-bar[data-kind=gap] [data-doubt=no]');
  await picture(page, 'gap-asked');
  await page.click('.doubt-bar[data-kind=gap] [data-doubt=no]');
  await understood();
  await picture(page, 'gap-opened');
  expect((await names(page)).length).toBe(1);
  expect((await strokes()).map(({ kind }) => kind)).toEqual(['outside']);
  await page.keyboard.press('Control+z');
  expect(await names(page)).toEqual(guessed);

  await gesture(page, [[370, 160]], size);
  await page.click('.doubt-bar[data-kind=gap] [data-doubt=yes]');
  await understood();
  expect(await names(page)).toEqual(guessed);
  await page.waitForSelector(doubts > 1 ? `.doubt-bar[data-doubts="${doubts - 1}"]` : '.doubt-bar', { state: doubts > 1 ? 'attached' : 'detached' });
  expect((await strokes()).map(({ kind }) => kind)).toEqual(['outside', 'hard']);
  expect(stage.troubles).toEqual([]);
});

it('moves strokes by hand and by keys, and makes soft ones', async () => {
  const { page } = stage;
  await openDrawing();
  await page.check('#soft');
  await gesture(page, [[120, 120], [120, 200]], size);
  await understood();
  const [drawn] = await strokes();
  expect(drawn!.kind).toBe('soft');

  await page.click('[data-brush=move]');
  await gesture(page, [[120, 160], [150, 170]], size);
  await understood();
  const [moved] = await strokes();
  const { scale } = await pageView(page, size);
  for (const k of [0, 1]) expect(Math.abs(moved!.points[0]![k]! - drawn!.points[0]![k]! - [30, 10][k]!)).toBeLessThan(2 / scale);
  await page.locator('.paper canvas').first().focus();
  await page.keyboard.press('Shift+ArrowLeft');
  await understood();
  const [pushed] = await strokes();
  expect(pushed!.points.map(([x, y]) => [x + 10, y])).toEqual(moved!.points.map(([x, y]) => [x, y]));
  await picture(page, 'stroke-moved');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect((await strokes())[0]!.points).toEqual(drawn!.points);
  await page.locator('.paper canvas').first().focus();
  await page.keyboard.press('.');
  await page.keyboard.press('Delete');
  await understood();
  expect(await strokes()).toEqual([]);
  expect(stage.troubles).toEqual([]);
});
