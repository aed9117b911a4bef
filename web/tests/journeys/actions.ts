import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { pictures, settled } from './browser.ts';

/** What a person does, over and over. */

export type Spot = [number, number];

export async function sample(page: Page, name: string): Promise<void> {
  await page.click(`[data-sample=${name}]`);
  await settled(page);
}

/** Names of the parts, nearest first. */
export function names(page: Page): Promise<string[]> {
  return page.locator('.parts .name').allInnerTexts();
}

export async function choosePart(page: Page, name: string): Promise<void> {
  await page.locator('.parts li').nth((await names(page)).indexOf(name)).click();
}

export async function downloaded(page: Page, act: () => Promise<void>, name: string): Promise<Buffer> {
  const waiting = page.waitForEvent('download');
  await act();
  const path = join(pictures, name);
  await (await waiting).saveAs(path);
  return readFileSync(path);
}

export function save(page: Page, name: string): Promise<Buffer> {
  return downloaded(page, () => page.click('#save'), name);
}

/** Where spots of a page that fits its pane are on the screen. */
export async function spotsOn(page: Page, spots: Spot[], [width, height]: Spot): Promise<Spot[]> {
  const box = await page.locator('.paper canvas').first().boundingBox();
  if (!box) throw new Error('no page to draw on');
  const [left, margin] = [90, 24];
  const room = box.width - left - margin;
  const scale = Math.min(room / width, (box.height - 2 * margin) / height);
  return spots.map(([x, y]) => [
    box.x + left + (room - scale * width) / 2 + scale * x,
    box.y + (box.height - scale * height) / 2 + scale * y,
  ]);
}

/** A click or a drag over a page that fits its pane; spots are its px. */
export async function gesture(page: Page, spots: Spot[], size: Spot = [1000, 800]): Promise<void> {
  const [first, ...others] = await spotsOn(page, spots, size);
  if (!first) throw new Error('nowhere to go');
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const spot of others) await page.mouse.move(...spot, { steps: 3 });
  await page.mouse.up();
}

export function oval(x: number, y: number, rx: number, ry: number): Spot[] {
  return Array.from({ length: 33 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 32;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });
}
