import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { strToU8, zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { relievo, root } from '../support/command_line.ts';
import { disc, photoshopOf } from '../support/pictures.ts';
import { downloaded, names } from './actions.ts';
import { picture, pictures, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

const body = disc(400, 170, [214, 120, 70]);
const head = disc(220, 100, [90, 140, 190]);

function oraOf(stack: string): Buffer {
  const entries = { mimetype: strToU8('image/openraster'), 'stack.xml': strToU8(stack), 'data/1.png': body, 'data/2.png': head };
  return Buffer.from(zipSync(entries, { level: 0 }));
}

const layers = '<layer name="part:head" src="data/2.png" x="300" y="20"/><layer name="part:body" src="data/1.png" x="60" y="90"/>';

it('opens the layers of an OpenRaster file as parts, painted as they were', async () => {
  const { page } = stage;
  const buffer = oraOf(`<image w="600" h="520"><stack>${layers}</stack></image>`);
  await page.setInputFiles('input[type=file]', { name: 'figure.ora', mimeType: 'image/openraster', buffer });
  await settled(page);
  expect(await names(page)).toEqual(['head', 'body']);
  await picture(page, 'ora');
  expect(stage.troubles).toEqual([]);
});

it('opens the layers of a Photoshop document, and one of a single layer as a flat picture', async () => {
  const { page } = stage;
  const inside = (radius: number) => (x: number, y: number) => [214, 120, radius, Math.hypot(x - 149.5, y - 149.5) < radius ? 255 : 0] as const;
  const figure = [
    { name: 'body', left: 60, top: 150, size: 300, paint: inside(140) },
    { name: 'head', left: 190, top: 10, size: 300, paint: inside(90) },
  ];
  const open = (layers_: typeof figure): Promise<void> =>
    page.setInputFiles('input[type=file]', { name: 'figure.psd', mimeType: 'image/vnd.adobe.photoshop', buffer: Buffer.from(photoshopOf(520, 460, layers_)) });
  await open(figure);
  await settled(page);
  expect(await names(page)).toEqual(['head', 'body']);
  await picture(page, 'psd');
  await open(figure.slice(0, 1));
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  expect(stage.troubles).toEqual([]);
});

it('opens several pictures as the layers of one drawing, dropped or chosen', async () => {
  const { page } = stage;
  const files = [['2 head.png', head], ['10 hat.png', disc(150, 60, [120, 60, 120])], ['1 body.png', body]] as const;
  await page.setInputFiles('input[type=file]', files.map(([name, bytes]) => ({ name, mimeType: 'image/png', buffer: Buffer.from(bytes) })));
  await settled(page);
  await picture(page, 'layers');
  expect((await names(page)).length).toBeGreaterThan(0);
  expect(stage.troubles).toEqual([]);
});

it('opens a dropped folder with its table of order', async () => {
  const { page, context, profile } = stage;
  const folder = join(profile, 'walrus');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'layers.tsv'), 'order_back_to_front\tfile\tname\tx\ty\n2\ta.png\thead\t300\t20\n1\tb.png\tbody\t60\t90\n');
  writeFileSync(join(folder, 'a.png'), head);
  writeFileSync(join(folder, 'b.png'), body);
  writeFileSync(join(folder, 'notes.txt'), 'of the artist');
  const session = await context.newCDPSession(page);
  const data = { items: [], files: [folder], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await session.send('Input.dispatchDragEvent', { type, x: 400, y: 300, data });
  await settled(page);
  expect(await names(page)).toEqual(['head', 'body']);
  expect(await page.locator('.document-name').inputValue()).toBe('walrus');
  expect(stage.troubles).toEqual([]);
});

it('refuses archives that are damaged or unpack without end, with a message', async () => {
  const { page } = stage;
  const broken = oraOf('<image w="600" h="520"><stack><layer src="data/9.png"/></stack></image>');
  const entity = oraOf('<!DOCTYPE a [<!ENTITY b SYSTEM "http://198.51.100.1/">]><image w="600" h="520"><stack>&b;</stack></image>');
  const cut = oraOf(`<image w="600" h="520"><stack>${layers}</stack></image>`).subarray(0, 900);
  for (const [name, buffer] of [['broken.ora', broken], ['entity.ora', entity], ['cut.ora', cut]] as const) {
    await page.setInputFiles('input[type=file]', { name, mimeType: '', buffer });
    await page.waitForFunction((file) => document.querySelector('[role=status]')?.textContent?.includes(file), name);
  }
  expect(stage.troubles).toEqual([]);
});

it('writes the parts as layers to paint on, as the command line does, and opens them again as the same parts', async () => {
  const { page } = stage;
  const drawing = join(root, 'examples/bear.png');
  await page.setInputFiles('input[type=file]', drawing);
  await settled(page);
  const guessed = await names(page);
  await page.click('#export');
  const psd = await downloaded(page, () => page.click('[data-export=psd]'), 'bear.psd');
  const native = join(pictures, 'bear-native.psd');
  relievo('segment', drawing, '-q', '-o', native);
  expect(psd.equals(readFileSync(native))).toBe(true);
  await page.setInputFiles('input[type=file]', join(pictures, 'bear.psd'));
  await expect.poll(() => page.locator('.document-name').inputValue()).toBe('bear');
  await page.waitForSelector('.scribble-bar', { state: 'detached' });
  await settled(page);
  expect(await names(page)).toEqual(guessed);
  await stillPicture(page, 'psd-again');
  expect(stage.troubles).toEqual([]);
});
