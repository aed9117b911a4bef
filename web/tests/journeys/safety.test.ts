import { strToU8, zipSync } from 'fflate';
import { beforeAll, expect, it } from 'vitest';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });
beforeAll(async () => {
  await stage.page.addInitScript(() => {
    Object.assign(window, { ran: 0 });
  });
  await stage.page.goto(stage.url);
});

const part = '<g data-relievo="part" id="a"><path fill="#c96" d="M100 100H700V600H100Z"/></g>';
const script = 'window.ran=1';
const hostile: Record<string, string> = {
  script: `<script>${script}</script>`,
  onload: `<g onload="${script}" onclick="${script}"><rect width="9" height="9"/></g>`,
  foreign: `<foreignObject width="99" height="99"><body xmlns="http://www.w3.org/1999/xhtml"><img src="x" onerror="${script}"/><iframe src="javascript:${script}"/></body></foreignObject>`,
  link: `<a href="javascript:${script}"><rect width="9" height="9"/></a>`,
  image: '<image href="http://198.51.100.1/a.png" width="99" height="99"/>',
  style: '<style>@import url(http://198.51.100.1/a.css); rect{fill:url(http://198.51.100.1/#a)}</style><rect width="9" height="9"/>',
  use: '<use href="http://198.51.100.1/a.svg#x"/>',
  animate: `<set attributeName="onload" to="${script}"/><animate onbegin="${script}" attributeName="x" dur="1s"/>`,
};

it.each(Object.keys(hostile))('runs and fetches nothing of a drawing with %s', async (kind) => {
  const { page } = stage;
  const text = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 800 700" onload="${script}">${hostile[kind]}${part}</svg>`;
  await page.setInputFiles('input[type=file]', { name: `${kind}.svg`, mimeType: 'image/svg+xml', buffer: Buffer.from(text) });
  await settled(page);
  expect(await page.evaluate(() => (window as unknown as { ran: number }).ran)).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('refuses a drawing that grows without end and files that are no drawings, with a message', async () => {
  const { page } = stage;
  const bomb = `<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa">${'bcdefghij'
    .split('')
    .map((name, i) => `<!ENTITY ${name} "${`&${'abcdefghi'[i]};`.repeat(10)}">`)
    .join('')}]><svg xmlns="http://www.w3.org/2000/svg">&j;</svg>`;
  for (const [name, text] of [['bomb.svg', bomb], ['text.svg', 'no svg at all'], ['a.relievo', 'no zip'], ['a.exe', 'MZ']] as const) {
    await page.setInputFiles('input[type=file]', { name, mimeType: '', buffer: Buffer.from(text) });
    await page.waitForFunction((file) => document.querySelector('[role=status]')?.textContent?.includes(file), name);
  }
  expect(stage.troubles).toEqual([]);
});

it('runs no script of a hostile project', async () => {
  const { page } = stage;
  const name = `<img src=x onerror="${script}">`;
  const scene = {
    format: 'relievo-scene', version: 1, canvas: { width: 800, height: 700 },
    parts: [{ id: name, outline: [[[100, 100], [700, 100], [700, 600], [100, 600]]], c: 4, d: 1 }],
  };
  const head = { format: 'relievo-project', version: 1, name, settings: { vertices: 'many', method: name }, drawing: null, colors: { [name]: `url(http://198.51.100.1/)` } };
  const buffer = Buffer.from(zipSync({
    'project.json': strToU8(JSON.stringify(head)),
    'scene.json': strToU8(JSON.stringify(scene)),
    '../../../evil': strToU8('x'),
  }));
  await page.setInputFiles('input[type=file]', { name: 'evil.relievo', mimeType: '', buffer });
  await settled(page);
  expect(await page.locator('.parts .name').innerText()).toBe(name);
  expect(await page.evaluate(() => (window as unknown as { ran: number }).ran)).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('works without a network', async () => {
  const { page, context } = stage;
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.reload();
  // A language that is chosen later is also kept for use without a network.
  await page.getByRole('button', { name: 'Français', exact: true }).click();
  await page.locator('html[lang=fr]').waitFor();
  await context.setOffline(true);
  await page.reload();
  await page.locator('html[lang=fr]').waitFor();
  await page.click('[data-sample=lamb]');
  await settled(page);
  await picture(page, 'offline');
  await context.setOffline(false);
  expect(stage.troubles).toEqual([]);
});
