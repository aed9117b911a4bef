import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import validator from 'gltf-validator';
import { expect, it } from 'vitest';
import { relievo, temporaryFolder } from '../support/command_line.ts';
import { choosePart, downloaded, sample, save } from './actions.ts';
import { picture, pictures, reopen, settled, stageOfFile } from './browser.ts';

/** For models of the command line, which are named after their files. */
const folder = temporaryFolder();

const stage = stageOfFile({ anew: true });

it('keeps the work when the browser is closed, and opens a saved project', async () => {
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

it('exports the same model as the command line makes of the saved project, and all other files', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  const project = unzipSync(await save(page, 'export.relievo'));
  await page.click('#export');
  await picture(page, 'export');
  const glb = await downloaded(page, () => page.click('[data-export=glb]'), 'export.glb');
  const report = await validator.validateBytes(new Uint8Array(glb));
  expect(report.issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  for (const name of ['scene.json', 'drawing.png']) writeFileSync(join(pictures, name), project[name]!);
  const native = join(folder, 'bunny.glb');
  relievo('build', join(pictures, 'scene.json'), '-q', '--vertices', '20000', '-o', native);
  expect(glb.equals(readFileSync(native))).toBe(true);
  const firstBytes: Record<string, string> = { obj: 'PK', ply: 'ply', stl: '', normal: '\x89PNG', depth: '\x89PNG', part: '\x89PNG', picture: '\x89PNG' };
  for (const [kind, first] of Object.entries(firstBytes)) {
    const bytes = await downloaded(page, () => page.click(`[data-export=${kind}]`), `export-${kind}`);
    expect(bytes.length).toBeGreaterThan(1000);
    expect(bytes.subarray(0, first.length).toString('latin1')).toBe(first);
  }
  expect(stage.troubles).toEqual([]);
});
