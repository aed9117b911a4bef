import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import type { CDPSession, Page } from 'playwright-core';
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

/** How a page of a size that fits its pane lies on the screen: its scale, and where its px are. */
export async function pageView(page: Page, [width, height]: Spot = [1000, 800]): Promise<{ scale: number; at(spot: Spot): Spot }> {
  const box = await page.locator('.paper canvas').first().boundingBox();
  if (!box) throw new Error('no page to draw on');
  const [left, bottom, margin] = [(page.viewportSize()?.width ?? 0) <= 900 ? 24 : 90, 68, 24];
  const room = box.width - left - margin;
  const tall = box.height - bottom - margin;
  const scale = Math.min(room / width, tall / height);
  const origin = [box.x + left + (room - scale * width) / 2, box.y + margin + (tall - scale * height) / 2] as const;
  return { scale, at: ([x, y]) => [origin[0] + scale * x, origin[1] + scale * y] };
}

/** A click or a drag over such a page; spots are its px. */
export async function gesture(page: Page, spots: Spot[], size: Spot = [1000, 800]): Promise<void> {
  const [first, ...others] = spots;
  if (!first) throw new Error('nowhere to go');
  const { at } = await pageView(page, size);
  await page.mouse.move(...at(first));
  await page.mouse.down();
  for (const spot of others) await page.mouse.move(...at(spot), { steps: 3 });
  await page.mouse.up();
}

/** The outer outline of a part, as a saved project has it. */
export async function outlineOf(page: Page, name: string): Promise<Spot[]> {
  const project = unzipSync(await save(page, 'outline.relievo'));
  const scene = JSON.parse(new TextDecoder().decode(project['scene.json'])) as {
    parts: { id: string; outline: Spot[][] }[];
  };
  return scene.parts.find((part) => part.id === name)?.outline[0] ?? [];
}

export function oval(x: number, y: number, rx: number, ry: number): Spot[] {
  return Array.from({ length: 33 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 32;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });
}

/** Presses a button many times, faster than a hand could. */
export function clicks(page: Page, selector: string, times: number): Promise<void> {
  return page.evaluate(([button, count]) => {
    for (let k = 0; k < Number(count); k++) document.querySelector<HTMLElement>(String(button))?.click();
  }, [selector, times] as const);
}

/** Coarse reliefs leave the machine to the hand. */
export async function fewVertices(page: Page): Promise<void> {
  await page.click('#settings');
  const slider = page.locator('.sheet .slider input').first();
  await slider.fill((await slider.getAttribute('min')) ?? '');
  await page.keyboard.press('Escape');
}

/** A stroke as fast as the browser takes it. */
export async function dash(session: CDPSession, spots: readonly Spot[], at: (spot: Spot) => Spot): Promise<void> {
  const send = (type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', spot: Spot): Promise<unknown> => {
    const [x, y] = at(spot);
    return session.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1 });
  };
  await Promise.all([send('mousePressed', spots[0] as Spot), ...spots.slice(1).map((spot) => send('mouseMoved', spot)), send('mouseReleased', spots.at(-1) as Spot)]);
}
