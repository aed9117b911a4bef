import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { relievo, root, temporaryFolder } from '../support/command_line.ts';
import { pngOf } from '../support/pictures.ts';
import { choosePart, downloaded, gesture, names, pageView, save, type Spot } from './actions.ts';
import { picture, pictures, reopen, settled, stageOfFile, stillPicture } from './browser.ts';

/** For models of the command line, which are named after their files. */
const folder = temporaryFolder();

const bear: Spot = [900, 1000];

const stage = stageOfFile({ anew: true });

async function openBear(): Promise<void> {
  const { page } = stage;
  await page.setInputFiles('input[type=file]', join(root, 'examples/bear.png'));
  await page.waitForSelector('.parts li');
  await settled(page);
}

/** Waits until the engine has handled every stroke. */
async function understood(): Promise<void> {
  await stage.page.waitForSelector('.scribble-bar[data-pending=false]');
}

async function scribble(...spots: Spot[]): Promise<void> {
  await gesture(stage.page, spots, bear);
  await understood();
}

interface Head {
  segmentation: { scribbles: { parts: string[]; strokes: { kind: string; part?: string }[] } };
}

function headOf(project: Buffer): Head {
  return JSON.parse(Buffer.from(unzipSync(project)['project.json']!).toString()) as Head;
}

interface ScenePart {
  id: string;
  outline: Spot[][];
}

interface Scene {
  parts: ScenePart[];
}

/** Returns the name and bounding box of each part, to a few px. The engine tests compare exactly. */
function boxOf({ id, outline }: ScenePart): [string, ...number[]] {
  const [xs, ys] = [0, 1].map((axis) => outline.flat().map((point) => point[axis] as number)) as [number[], number[]];
  return [id, ...[Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)].map((v) => Math.round(v / 8))];
}

function sceneOf(project: Buffer): Scene {
  return JSON.parse(Buffer.from(unzipSync(project)['scene.json']!).toString()) as Scene;
}

it('makes a model of a flat drawing with scribbles, which stay editable in the saved project', async () => {
  const { page } = stage;
  await openBear();
  await picture(page, 'scribble-guessed');
  const guessed = await names(page);
  const untouched = await save(page, 'bear-guessed.relievo');

  await scribble([430, 620], [470, 700]);
  await scribble([360, 660], [350, 740]);
  expect((await names(page)).length).toBe(guessed.length + 1);
  await scribble([280, 170], [270, 130]);
  await gesture(page, [[300, 150], [450, 180]], bear, { shift: true });
  await understood();
  expect((await names(page)).length).toBe(guessed.length);
  await page.keyboard.press('Control+z');
  expect((await names(page)).length).toBe(guessed.length + 1);
  await page.click('[data-brush=outside]');
  await scribble([60, 60], [120, 120]);
  await settled(page);
  await picture(page, 'scribble-bear');

  await choosePart(page, (await names(page))[0]!);
  await page.keyboard.press('Home');
  await page.keyboard.press('h');
  await settled(page);
  const project = await save(page, 'bear.relievo');
  const { scribbles } = headOf(project).segmentation;
  expect(scribbles.strokes.map(({ kind }) => kind)).toEqual(['hard', 'hard', 'hard', 'outside']);
  expect(Buffer.from(unzipSync(project)['drawing']!).equals(readFileSync(join(root, 'examples/bear.png')))).toBe(true);

  const steps = await undoAll();
  expect(await page.locator('.parts li').count()).toBe(0);
  await redo(1);
  expect((await save(page, 'bear-undone.relievo')).equals(untouched)).toBe(true);
  await redo(steps - 1);
  await settled(page);
  expect((await save(page, 'bear-redone.relievo')).equals(project)).toBe(true);
  expect(stage.troubles).toEqual([]);
});

async function undoAll(): Promise<number> {
  const { page } = stage;
  let steps = 0;
  for (; await page.locator('#undo').isEnabled(); steps++) await page.keyboard.press('Control+z');
  return steps;
}

async function redo(steps: number): Promise<void> {
  for (let i = 0; i < steps; i++) await stage.page.keyboard.press('Control+Shift+z');
}

it('opens a saved project again, continues its strokes, and builds as the command line does', async () => {
  await openBear();
  await scribble([430, 620], [470, 700]);
  await scribble([360, 660], [350, 740]);
  const before = await save(stage.page, 'bear-kept.relievo');
  await stage.page.waitForSelector('.saved.yes');
  await reopen(stage);
  const { page } = stage;
  await page.click('#go-on');
  await settled(page);
  expect((await save(page, 'bear-recovered.relievo')).equals(before)).toBe(true);
  await page.click('.brand');
  await page.setInputFiles('input[type=file]', join(pictures, 'bear-kept.relievo'));
  await settled(page);
  expect((await save(page, 'bear-opened.relievo')).equals(before)).toBe(true);

  await page.keyboard.press('7');
  const parts = (await names(page)).length;
  await page.waitForSelector('.stroke-list li');
  await picture(page, 'scribble-opened');
  expect(await page.locator('.stroke-list li').count()).toBe(2);
  await page.click('[data-brush=erase]');
  await scribble([340, 700], [370, 700]);
  expect(await page.locator('.stroke-list li').count()).toBe(1);
  expect((await names(page)).length).toBe(parts - 1);
  await settled(page);

  const project = await save(page, 'bear-erased.relievo');
  expect(headOf(project).segmentation.scribbles.strokes.length).toBe(1);
  await page.click('#export');
  const glb = await downloaded(page, () => page.click('[data-export=glb]'), 'bear.glb');
  const native = join(folder, 'bear.glb');
  relievo('build', join(pictures, 'bear-erased.relievo'), '-q', '--vertices', '20000', '-o', native);
  expect(glb.equals(readFileSync(native))).toBe(true);
  expect(stage.troubles).toEqual([]);
});

it('cuts the figure out by a mask, as the command line does', async () => {
  await openBear();
  const { page } = stage;
  const mask = join(pictures, 'bear-mask.png');
  // The mask leaves out the lowest third of the bear.
  writeFileSync(mask, pngOf(bear[0], bear[1], (_, y) => (y < 660 ? [255, 255, 255, 255] : [0, 0, 0, 255])));
  const small = join(pictures, 'small-mask.png');
  writeFileSync(small, pngOf(9, 10, () => [255, 255, 255, 255]));
  const choose = async (file: string): Promise<void> => {
    const chooser = page.waitForEvent('filechooser');
    await page.click('#figure-mask');
    await (await chooser).setFiles(file);
  };
  await choose(small);
  await page.waitForFunction(() => document.querySelector('[role=status]')?.textContent?.includes('900 × 1000'));
  const whole = await save(page, 'bear-whole.relievo');
  await choose(mask);
  await page.waitForFunction((parts) => document.querySelectorAll('.parts li').length !== parts, sceneOf(whole).parts.length);
  await settled(page);
  await picture(page, 'scribble-figure-mask');
  const cut = sceneOf(await save(page, 'bear-cut.relievo'));
  const native = join(pictures, 'bear-cut-native.relievo');
  relievo('segment', join(root, 'examples/bear.png'), '--figure', mask, '-q', '-o', native);
  expect(cut.parts.map(boxOf)).toEqual(sceneOf(readFileSync(native)).parts.map(boxOf));
  expect(stage.troubles).toEqual([]);
});

it('tints the parts while the pen is down, and forgets a stroke on Escape', async () => {
  const { page } = stage;
  await openBear();
  const count = (await names(page)).length;
  const times: number[] = [];
  const { at } = await pageView(page, bear);
  const spots = ([[430, 620], [450, 660], [470, 700], [490, 730], [500, 760]] satisfies Spot[]).map(at);
  await page.mouse.move(...spots[0]!);
  await page.mouse.down();
  for (const spot of spots.slice(1)) {
    await page.mouse.move(...spot, { steps: 4 });
    await page.waitForTimeout(250);
    times.push(Number(await page.locator('.scribble-bar').getAttribute('data-tint-ms')));
  }
  await page.emulateMedia({ colorScheme: 'dark' });
  await picture(page, 'scribble-pen-down-dark');
  await page.emulateMedia({ colorScheme: 'light' });
  await picture(page, 'scribble-pen-down');
  console.log(`scribble to tint at 0.9 megapixels: ${times.join(', ')} ms`);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await understood();
  expect((await names(page)).length).toBe(count);
  expect(await page.locator('.stroke-list li').count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('opens and saves a project of the command line without losing anything', async () => {
  const { page } = stage;
  const file = join(pictures, 'bear-segmented.relievo');
  relievo('segment', join(root, 'examples/bear.png'), '-q', '-o', file);
  await page.setInputFiles('input[type=file]', file);
  await settled(page);
  await choosePart(page, (await names(page))[2]!);
  await page.keyboard.press('PageUp');
  await settled(page);
  const saved = unzipSync(await save(page, 'bear-corrected.relievo'));
  const came = unzipSync(readFileSync(file));
  for (const name of ['drawing', 'labels.png']) expect(Buffer.from(saved[name]!).equals(Buffer.from(came[name]!))).toBe(true);
  const { corrections } = (JSON.parse(Buffer.from(saved['project.json']!).toString()) as { segmentation: { corrections: { order: unknown[] } } }).segmentation;
  expect(corrections.order.length).toBe(1);
  relievo('check', join(pictures, 'bear-corrected.relievo'));
  expect(stage.troubles).toEqual([]);
});

it('needs no pointer: arrows move the brush, Enter puts it down and lifts it', async () => {
  const { page } = stage;
  await openBear();
  const { keyboard } = page;
  for (let i = 0; i < 5; i++) await keyboard.press('Shift+ArrowDown');
  await keyboard.press('Enter');
  for (let i = 0; i < 4; i++) await keyboard.press('ArrowDown');
  await picture(page, 'scribble-keys');
  await keyboard.press('Enter');
  await understood();
  expect(await page.locator('.stroke-list li').count()).toBe(1);
  await page.locator('[data-brush=auto]').focus();
  await keyboard.press('ArrowLeft');
  expect(await page.locator('[data-brush=move]').getAttribute('aria-pressed')).toBe('true');
  await page.locator('.stroke-list [aria-label^=Remove]').focus();
  await keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelectorAll('.stroke-list li').length === 0);
  await understood();
  await keyboard.press('?');
  await picture(page, 'scribble-keys-panel');
  expect(stage.troubles).toEqual([]);
});

it('completes shapes that a new order hides, in the same step', async () => {
  const { page } = stage;
  await openBear();
  const before = sceneOf(await save(page, 'bear-before.relievo'));
  await choosePart(page, (await names(page)).at(-1)!);
  await page.keyboard.press('Home');
  // Saving waits until the engine has handled everything.
  const after = sceneOf(await save(page, 'bear-after.relievo'));
  await settled(page);
  await stillPicture(page, 'scribble-reordered');
  const front = after.parts.at(-1)!.id;
  expect(front).toBe(before.parts[0]!.id);
  const outline = (scene: Scene, id: string): string => JSON.stringify(scene.parts.find((part) => part.id === id));
  expect(outline(after, front)).not.toBe(outline(before, front));
  await page.keyboard.press('Control+z');
  expect(sceneOf(await save(page, 'bear-back.relievo'))).toEqual(before);
  await page.keyboard.press('Control+Shift+z');
  expect(sceneOf(await save(page, 'bear-forth.relievo'))).toEqual(after);
  expect(stage.troubles).toEqual([]);
});

it('runs no script of a hostile segmentation, and names its error', async () => {
  const { page } = stage;
  await page.evaluate(() => Object.assign(window, { ran: 0 }));
  const file = join(pictures, 'hostile.relievo');
  relievo('segment', join(root, 'examples/bear.png'), '-q', '-o', file);
  const entries = unzipSync(readFileSync(file));
  const text = Buffer.from(entries['project.json']!).toString();
  const script = '<img src=x onerror=\\"window.ran=1\\">';
  const renamed = (json: string): string => json.replaceAll('"part-1"', `"${script}"`);
  const stroke = `{"kind":"hard","part":"${script}","width":9,"points":[[450,700],[460,720]]}`;
  const scribbled = renamed(text).replace(/"scribbles":\s*\{[^}]*\}/, `"scribbles":{"parts":["${script}"],"strokes":[${stroke}]}`);
  const pack = (json: string, scene: string): Buffer =>
    Buffer.from(zipSync({ ...entries, 'project.json': strToU8(json), 'scene.json': strToU8(scene) }));
  const scene = renamed(Buffer.from(entries['scene.json']!).toString());
  writeFileSync(file, pack(scribbled, scene));
  await page.setInputFiles('input[type=file]', file);
  await settled(page);
  await page.keyboard.press('7');
  await page.waitForSelector('.stroke-list li');
  expect(await page.locator('.stroke-list .chip').first().innerText()).toContain('<img src=x');
  const bad = text.replace('"scribbles": {', '"scribbles": {"__proto__":{"ran":1},');
  await page.setInputFiles('input[type=file]', { name: 'bad.relievo', mimeType: '', buffer: pack(bad, scene) });
  await page.waitForFunction(() => document.querySelector('[role=status]')?.textContent?.includes('segmentation.scribbles'));
  expect(await page.evaluate(() => (window as unknown as { ran: number }).ran)).toBe(0);
  expect(stage.troubles).toEqual([]);
});
