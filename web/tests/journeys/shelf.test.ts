import type { Page } from 'playwright-core';
import { beforeEach, expect, it } from 'vitest';
import { disc } from '../support/pictures.ts';
import { clicks, fewVertices, names, pageView, type Spot, stroke } from './actions.ts';
import { picture, reopen, stageOfFile } from './browser.ts';
import { killBrowser, shelfOf } from './storage.ts';

const stage = stageOfFile({ anew: true });
/** Number of edits: the name, the number of vertices, and one for each part. */
const edits = 50;
const parts = edits - 2;
// The window is small, since only the storage matters here.
beforeEach(() => stage.page.setViewportSize({ width: 1200, height: 640 }));

const blob = Array.from({ length: 13 }, (_, i): Spot => [62 * Math.cos((i * Math.PI) / 6), 80 * Math.sin((i * Math.PI) / 6)]);

/** Draws strokes in rows, one part each. */
async function drawParts(page: Page, from: number, to: number): Promise<void> {
  const { at } = await pageView(page);
  for (let i = from; i < to; i++)
    await stroke(page, blob.map(([x, y]): Spot => [x + 90 + 90 * (i % 10), y + 110 + 140 * Math.floor(i / 10)]), at);
}

/** Waits until everything is saved. */
async function kept(page: Page): Promise<void> {
  await page.waitForTimeout(150);
  await page.waitForSelector('.saved.yes');
}

async function rename(page: Page, name: string): Promise<void> {
  await page.fill('.document-name', name);
  await page.keyboard.press('Enter');
}

async function begin(page: Page, name: string, parts: number): Promise<void> {
  await page.click('#empty');
  await page.waitForSelector('.paper canvas');
  await rename(page, name);
  await fewVertices(page);
  await drawParts(page, 0, parts);
}

it('keeps every step of two documents when the browser is killed, and opens both with their undo history', async () => {
  const { page } = stage;
  await begin(page, 'first', parts);
  await page.click('.brand');
  await begin(page, 'second', parts);
  // The last stroke is saved before a user could close the window.
  await kept(page);
  await killBrowser(stage.profile);
  await reopen(stage);
  const all = await shelfOf(stage.page);
  expect(all.map(({ name }) => name)).toEqual(['first', 'second']);
  for (const { parts: inVersions, done } of all) {
    expect(inVersions).toEqual([0, 0, 0, ...Array.from({ length: parts }, (_, i) => i + 1)]);
    expect(done.length).toBe(edits + 1);
  }
  await picture(stage.page, 'shelf');
  for (const name of ['second', 'first']) {
    await stage.page.click(`.samples.kept button:has-text("${name}")`);
    await stage.page.waitForSelector('.parts li');
    expect((await names(stage.page)).length).toBe(parts);
    await clicks(stage.page, '#undo', edits);
    await stage.page.waitForSelector('#undo:disabled');
    expect((await names(stage.page)).length).toBe(0);
    await clicks(stage.page, '#redo', edits);
    expect((await names(stage.page)).length).toBe(parts);
    await kept(stage.page);
    await stage.page.click('.brand');
  }
  // Looking at saved states makes no new ones.
  expect((await shelfOf(stage.page)).map(({ versions }) => versions.length)).toEqual([edits + 1, edits + 1]);
  expect(stage.troubles).toEqual([]);
}, 300_000);

it('goes back to any version by a slider, which is a step that can be undone', async () => {
  const { page } = stage;
  await page.click('.samples.kept button:has-text("first")');
  await page.waitForSelector('.parts li');
  await page.click('#versions');
  await page.locator('.versions input[type=range]').fill('12');
  await page.waitForTimeout(300);
  await picture(page, 'versions');
  await page.click('#go-back');
  expect((await names(page)).length).toBe(10);
  await page.click('#undo');
  expect((await names(page)).length).toBe(parts);
  expect(stage.troubles).toEqual([]);
});

it('replaces nothing by opening, dropping or starting a drawing, and brings back thrown away drawings', async () => {
  const { page } = stage;
  const before = (await shelfOf(page)).length;
  await begin(page, 'third', 2);
  await page.setInputFiles('input[type=file]', { name: 'dropped.png', mimeType: 'image/png', buffer: Buffer.from(disc(300, 110, [200, 80, 60])) });
  await page.waitForSelector('.scribble-bar');
  await kept(page);
  await page.click('.brand');
  await page.click('#empty');
  await page.click('.brand');
  const all = await shelfOf(page);
  // An empty page is not saved.
  expect(all.length).toBe(before + 2);
  expect(all.find(({ name }) => name === 'third')?.parts.at(-1)).toBe(2);
  const card = page.locator('.samples.kept li', { hasText: 'third' });
  await card.locator('.throw-away').click();
  await card.waitFor({ state: 'detached' });
  await page.click('#bring-back');
  await card.waitFor();
  await card.locator('button').first().click();
  await page.waitForSelector('.parts li');
  expect((await names(page)).length).toBe(2);
  expect(stage.troubles).toEqual([]);
});

it('lets one tab at a time change a document; the other may take it over or copy it, and no stroke is lost', async () => {
  const { page } = stage;
  await begin(page, 'shared', 3);
  await kept(page);
  const second = await stage.context.newPage();
  await second.goto(stage.url);
  await second.click('.samples.kept button:has-text("shared")');
  await second.waitForSelector('[role=alertdialog]');
  await second.click('#take-over');
  await second.waitForSelector('.parts li');
  await page.waitForSelector('[data-alert=takenOver]');
  await picture(page, 'taken-over');
  await second.keyboard.press('2');
  await drawParts(second, 3, 5);
  await kept(second);
  // Drawing in the first tab continues on a copy.
  await drawParts(page, 5, 6);
  await kept(page);
  const mine = (await shelfOf(page)).filter(({ name }) => name.startsWith('shared'));
  expect(mine.map(({ name, parts }) => [name, parts.at(-1)])).toEqual([['shared', 5], ['shared (copy)', 4]]);
  await second.close();
  await page.click('.brand');
  await page.locator('.samples.kept .name', { hasText: /^shared$/ }).click();
  await page.waitForSelector('.parts li');
  expect((await names(page)).length).toBe(5);
  expect(stage.troubles).toEqual([]);
});

it('warns while the storage is full, offers to save, and loses nothing', async () => {
  const { page } = stage;
  await begin(page, 'full', 1);
  await kept(page);
  // Imitates the error of the browser, whose own count of free storage lags behind by up to a minute.
  await page.evaluate(() => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('The storage is full', 'QuotaExceededError');
    };
    window.addEventListener('room-again', () => (IDBObjectStore.prototype.put = put), { once: true });
  });
  const drawn = 3;
  await drawParts(page, 1, drawn);
  await page.waitForSelector('[data-alert=unsaved]');
  await picture(page, 'storage-full');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('#save-now')]);
  expect(file.suggestedFilename()).toBe('full.relievo');
  const asked = page.waitForEvent('dialog');
  const leaving = page.close({ runBeforeUnload: true });
  const dialog = await asked;
  expect(dialog.type()).toBe('beforeunload');
  await dialog.dismiss();
  await leaving;
  await page.evaluate(() => window.dispatchEvent(new Event('room-again')));
  await page.waitForFunction(() => !document.querySelector('[data-alert]'), undefined, { timeout: 15_000 });
  await kept(page);
  expect((await shelfOf(page)).find(({ name }) => name === 'full')?.parts.at(-1)).toBe(drawn);
  expect(stage.troubles).toEqual([]);
});
