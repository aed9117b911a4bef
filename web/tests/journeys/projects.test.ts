import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { unzipSync } from 'fflate';
import validator from 'gltf-validator';
import { afterAll, beforeAll, beforeEach, expect, it } from 'vitest';
import { choosePart, downloaded, sample, save } from './actions.ts';
import { closeStage, openStage, picture, pictures, reopen, settled, type Stage } from './browser.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const program = process.env['RELIEVO'] ?? join(root, 'build/dev/apps/cli/relievo');

let stage: Stage;
beforeAll(async () => {
  stage = await openStage();
});
beforeEach(async () => {
  await stage.page.goto(stage.url);
});
afterAll(() => closeStage(stage));

it('keeps the work when the browser is ended, and a saved project opens again', async () => {
  await sample(stage.page, 'farmer');
  await choosePart(stage.page, 'head');
  await stage.page.keyboard.press('PageDown');
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
  expect(stage.troubles).toEqual([]);
});

it('exports the model that the command line makes of the saved project, and all else', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  const project = unzipSync(await save(page, 'export.relievo'));
  await page.click('#export');
  await picture(page, 'export');
  const glb = await downloaded(page, () => page.click('[data-export=glb]'), 'export.glb');
  const report = await validator.validateBytes(new Uint8Array(glb));
  expect(report.issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  for (const name of ['scene.json', 'drawing.png']) writeFileSync(join(pictures, name), project[name]!);
  const native = join(pictures, 'native.glb');
  execFileSync(program, ['build', join(pictures, 'scene.json'), '-q', '--vertices', '20000', '-o', native]);
  expect(glb.equals(readFileSync(native))).toBe(true);
  const firstBytes: Record<string, string> = { obj: 'PK', ply: 'ply', stl: '', normal: '\x89PNG', depth: '\x89PNG', part: '\x89PNG', picture: '\x89PNG' };
  for (const [kind, first] of Object.entries(firstBytes)) {
    const bytes = await downloaded(page, () => page.click(`[data-export=${kind}]`), `export-${kind}`);
    expect(bytes.length).toBeGreaterThan(1000);
    expect(bytes.subarray(0, first.length).toString('latin1')).toBe(first);
  }
  expect(stage.troubles).toEqual([]);
});
