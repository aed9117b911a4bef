import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { encode } from 'modern-gif';
import { expect, it } from 'vitest';
import { root } from '../support/command_line.ts';
import { disc } from '../support/pictures.ts';
import { names } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

const lineArt = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><g fill="none" stroke="#000" stroke-width="4">
<ellipse cx="220" cy="180" rx="120" ry="80"/><circle cx="90" cy="90" r="55"/></g></svg>`;

async function give(...files: { name: string; bytes: Uint8Array; type?: string }[]): Promise<void> {
  await stage.page.setInputFiles('input[type=file]', files.map(({ name, bytes, type }) => ({ name, mimeType: type ?? '', buffer: Buffer.from(bytes) })));
}

it('finds the parts of a vector drawing of lines only as those of a flat picture', async () => {
  const { page } = stage;
  await give({ name: 'lines.svg', bytes: Buffer.from(lineArt) });
  await page.waitForSelector('.scribble-bar[data-tint-ms]');
  await page.waitForSelector('.parts li');
  expect((await names(page)).length).toBe(2);
  await settled(page);
  await picture(page, 'line-art');
  expect(stage.troubles).toEqual([]);
});

it('opens a GIF, and pictures by their content and not by their names', async () => {
  const { page } = stage;
  const side = 200;
  const data = new Uint8ClampedArray(4 * side * side).map((_, i) => {
    const [x, y] = [(i >> 2) % side, Math.floor((i >> 2) / side)];
    const away = Math.hypot(x - side / 2, y - side / 2);
    return i % 4 === 3 ? 255 : Math.abs(away - 70) < 3 ? 0 : away < 70 && i % 4 === 0 ? 220 : 255;
  });
  const gif = new Uint8Array(await encode({ width: side, height: side, frames: [{ data, delay: 100 }] }));
  for (const file of [{ name: 'ring.gif', bytes: gif, type: 'image/gif' }, { name: 'nameless', bytes: disc(200, 80, [20, 120, 90]) }]) {
    await page.goto(stage.url);
    await give(file);
    await page.waitForSelector('.scribble-bar[data-tint-ms]');
    await page.waitForSelector('.parts li');
    expect((await names(page)).length).toBe(1);
  }
  expect(stage.troubles).toEqual([]);
});

it('opens a scene file with or without its drawing, and refuses other files', async () => {
  const { page } = stage;
  const part = { id: 'disc', outline: [[[40, 40], [160, 40], [160, 160], [40, 160]]], c: 4, d: 1 };
  const scene = { format: 'relievo-scene', version: 1, canvas: { width: 200, height: 200 }, drawing: 'disc.png', parts: [part] };
  const file = { name: 'scene.json', bytes: Buffer.from(JSON.stringify(scene)) };
  await give(file, { name: 'disc.png', bytes: disc(200, 80, [20, 120, 90]), type: 'image/png' });
  await settled(page);
  await picture(page, 'scene-file');
  expect(await names(page)).toEqual(['disc']);
  await page.goto(stage.url);
  await give(file);
  await page.waitForFunction(() => document.querySelector('.notice')?.textContent?.includes('disc.png'));
  for (const [name, text] of [['other.json', '{"a":1}'], ['bad.json', JSON.stringify({ ...scene, parts: [{ ...part, outline: [[[0, 0], [1, 1]]] }] })], ['model.glb', 'glTF1234'], ['a.svg.gz', '\x1f\x8b\x08']] as const) {
    await page.goto(stage.url);
    await give({ name, bytes: Buffer.from(text, 'latin1') });
    await page.waitForFunction((file) => document.querySelector('[role=status]')?.textContent?.includes(file), name);
  }
  expect(stage.troubles).toEqual([]);
});

it('says what the files of other programs are, and what to do with them', async () => {
  const { page } = stage;
  const foreign = [
    ['fox.xcf', 'gimp xcf v011\0', 'OpenRaster'],
    ['fox.png', '<!DOCTYPE html><p>Not Found</p>', 'download it again'],
    ['fox.json', '{"v":"5","fr":30,"op":60,"layers":[]}', 'Lottie'],
    ['fox.heic', '\0\0\0\x18ftypheic\0\0\0\0', 'save it as JPEG or PNG'],
  ] as const;
  for (const [name, text, remedy] of foreign) {
    await page.goto(stage.url);
    await give({ name, bytes: Buffer.from(text, 'latin1') });
    await page.waitForFunction((words) => document.querySelector('[role=status]')?.textContent?.includes(words), remedy);
  }
  expect(stage.troubles).toEqual([]);
});

it('opens a photo of twelve megapixels and finds its parts', async () => {
  const { page } = stage;
  const bear = readFileSync(join(root, 'examples/bear.png')).toString('base64');
  const photo = await page.evaluate(async (data) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))]));
    const canvas = new OffscreenCanvas(3000, 4000);
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
    context.fillStyle = '#f2ede2';
    context.fillRect(0, 0, 3000, 4000);
    context.drawImage(image, 150, 500, 2700, 3000);
    const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.9 })).arrayBuffer());
    let text = '';
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
  }, bear);
  await give({ name: 'photo.jpg', bytes: Buffer.from(photo, 'base64'), type: 'image/jpeg' });
  await page.waitForSelector('.parts li', { timeout: 60_000 });
  await settled(page);
  await picture(page, 'photo');
  expect((await names(page)).length).toBeGreaterThan(3);
  expect(stage.troubles).toEqual([]);
});
