import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { unzipSync } from 'fflate';
import validator from 'gltf-validator';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { closeStage, openStage, picture, pictures, reopen, settled, type Stage } from './browser.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const program = process.env['RELIEVO'] ?? join(root, 'build/dev/apps/cli/relievo');

let stage: Stage;
beforeAll(async () => {
  stage = await openStage();
});
afterAll(() => closeStage(stage));

async function downloaded(page: Page, act: () => Promise<void>, name: string): Promise<Buffer> {
  const waiting = page.waitForEvent('download');
  await act();
  const path = join(pictures, name);
  await (await waiting).saveAs(path);
  return readFileSync(path);
}

const save = (page: Page, name: string): Promise<Buffer> =>
  downloaded(page, () => page.click('#save'), name);

const names = (page: Page): Promise<string[]> => page.locator('.parts .name').allInnerTexts();

async function sample(page: Page, name: string): Promise<void> {
  await page.click(`[data-sample=${name}]`);
  await settled(page);
}

it('orders, joins and hollows parts by keyboard, and undo leads back to the same bytes', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  const before = await save(page, 'before.relievo');
  const order = await names(page);
  await page.locator('.parts li').nth(2).click();
  await page.keyboard.press('PageDown');
  expect((await names(page))[3]).toBe(order[2]);
  await page.keyboard.press('j');
  await page.keyboard.press('h');
  await page.locator('.slider input').first().fill('6');
  await settled(page);
  await picture(page, 'edited');
  const after = await save(page, 'after.relievo');
  expect(after.equals(before)).toBe(false);
  const undo = page.locator('#undo');
  while (await undo.isEnabled()) await undo.click();
  expect((await save(page, 'undone.relievo')).equals(before)).toBe(true);
  const redo = page.locator('#redo');
  while (await redo.isEnabled()) await redo.click();
  expect((await save(page, 'redone.relievo')).equals(after)).toBe(true);
});

it('keeps the work when the browser is ended, and a saved project opens again', async () => {
  await settled(stage.page);
  const before = await save(stage.page, 'kept.relievo');
  await stage.page.waitForSelector('.saved.yes');
  await reopen(stage);
  const { page } = stage;
  await page.click('#go-on');
  await settled(page);
  expect((await save(page, 'recovered.relievo')).equals(before)).toBe(true);
  await page.click('.brand');
  await page.setInputFiles('input[type=file]', join(pictures, 'kept.relievo'));
  await settled(page);
  expect((await save(page, 'opened.relievo')).equals(before)).toBe(true);
});

it('exports the model that the command line makes of the saved project', async () => {
  const { page } = stage;
  const project = unzipSync(await save(page, 'export.relievo'));
  await page.click('#export');
  const glb = await downloaded(page, () => page.click('[data-export=glb]'), 'export.glb');
  const report = await validator.validateBytes(new Uint8Array(glb));
  expect(report.issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  for (const name of ['scene.json', 'drawing.png']) writeFileSync(join(pictures, name), project[name]!);
  const native = join(pictures, 'native.glb');
  execFileSync(program, ['build', join(pictures, 'scene.json'), '-q', '--vertices', '20000', '-o', native]);
  expect(glb.equals(readFileSync(native))).toBe(true);
  for (const kind of ['obj', 'ply', 'stl', 'normal', 'depth', 'part', 'picture']) {
    const bytes = await downloaded(page, () => page.click(`[data-export=${kind}]`), `export-${kind}`);
    expect(bytes.length).toBeGreaterThan(1000);
  }
  await picture(page, 'export');
});

it('sets a soft range with two clicks and joins with a line', async () => {
  const { page } = stage;
  await page.keyboard.press('Escape');
  await page.click('.brand');
  await sample(page, 'elephant');
  await page.keyboard.press('5');
  const box = (await page.locator('.paper canvas').first().boundingBox())!;
  await page.locator('.parts li').nth(1).click();
  for (const [x, y] of [[0.5, 0.45], [0.55, 0.55]] as const) {
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await page.mouse.down();
    await page.mouse.up();
    await picture(page, `range-${x}`);
  }
  await settled(page);
  await picture(page, 'range');
  expect(stage.troubles).toEqual([]);
});
