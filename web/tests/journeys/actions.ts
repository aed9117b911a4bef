import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import type { CDPSession, Page } from 'playwright-core';
import { pictures, settled } from './browser.ts';

/** Actions of a user that many journeys need. */

export type Spot = [number, number];

export async function sample(page: Page, name: string): Promise<void> {
  await page.click(`[data-sample=${name}]`);
  await settled(page);
}

/** Returns the names of the parts, nearest first. */
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

/** Returns the viewport of a page that fits its pane: its scale, and a function from its px to the screen. */
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

const sessions = new WeakMap<Page, Promise<CDPSession>>();

function sessionOf(page: Page): Promise<CDPSession> {
  const session = sessions.get(page) ?? page.context().newCDPSession(page);
  sessions.set(page, session);
  return session;
}

/** Clicks or drags as fast as the browser allows. Many moves arrive at once, as from a fast hand. */
export async function stroke(page: Page, spots: readonly Spot[], at: (spot: Spot) => Spot, { shift = false } = {}): Promise<void> {
  const [first, last] = [spots[0], spots.at(-1)];
  if (!first || !last) throw new Error('nowhere to go');
  const session = await sessionOf(page);
  const send = (type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', spot: Spot, buttons: number): Promise<unknown> => {
    const [x, y] = at(spot);
    const button = buttons === 0 && type === 'mouseMoved' ? 'none' : 'left';
    return session.send('Input.dispatchMouseEvent', { type, x, y, button, buttons, clickCount: 1, modifiers: shift ? 8 : 0 });
  };
  await Promise.all([
    send('mouseMoved', first, 0), send('mousePressed', first, 1),
    ...spots.slice(1).map((spot) => send('mouseMoved', spot, 1)), send('mouseReleased', last, 0),
  ]);
}

/** Clicks or drags over a page that fits its pane; spots are px of the page. */
export async function gesture(page: Page, spots: readonly Spot[], size: Spot = [1000, 800], keys: { shift?: boolean } = {}): Promise<void> {
  const { at } = await pageView(page, size);
  const between = ([x, y]: Spot, [u, v]: Spot): Spot[] => [1, 2, 3].map((k) => [x + (k / 3) * (u - x), y + (k / 3) * (v - y)]);
  const path = spots.flatMap((spot, i) => (i === 0 ? [spot] : between(spots[i - 1] as Spot, spot)));
  await stroke(page, path, at, keys);
}

/** Returns the outer ring of a part in a saved project. */
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

/** Presses a button many times, faster than a user could. */
export function clicks(page: Page, selector: string, times: number): Promise<void> {
  return page.evaluate(([button, count]) => {
    for (let k = 0; k < Number(count); k++) document.querySelector<HTMLElement>(String(button))?.click();
  }, [selector, times] as const);
}

/** Sets few vertices, so that building takes little time. */
export async function fewVertices(page: Page): Promise<void> {
  await page.click('#settings');
  const slider = page.locator('.sheet .slider input').first();
  await slider.fill((await slider.getAttribute('min')) ?? '');
  await page.keyboard.press('Escape');
}
