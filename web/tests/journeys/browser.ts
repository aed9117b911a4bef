import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type BrowserContext, chromium, type Page } from 'playwright-core';
import { preview, type PreviewServer } from 'vite';
import { afterAll, beforeAll, beforeEach, expect } from 'vitest';

const web = fileURLToPath(new URL('../..', import.meta.url));

/** The folder for screenshots of journeys, for people to look at. */
export const pictures = join(web, '../build/journeys');

/** The built page, served and opened in a browser with its own storage. */
export interface Stage {
  server: PreviewServer;
  context: BrowserContext;
  page: Page;
  url: string;
  profile: string;
  /** Further options of the browser. */
  words: readonly string[];
  /** All problems: console errors, violations of the policy, requests to other hosts. */
  troubles: string[];
}

function openContext(profile: string, words: readonly string[]): Promise<BrowserContext> {
  return chromium.launchPersistentContext(profile, {
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    headless: true,
    viewport: { width: 1360, height: 800 },
    acceptDownloads: true,
    locale: 'en-GB',
    args: [
      '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', '--use-angle=swiftshader',
      // Without a graphics processor the browser composes the page faster this way.
      '--enable-unsafe-swiftshader', '--disable-gpu-compositing', '--disable-accelerated-2d-canvas',
      ...words,
    ],
  });
}

function watch(stage: Stage): void {
  const { context, troubles, url } = stage;
  context.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  context.on('weberror', (error) => troubles.push(String(error.error())));
  context.on('request', (request) => {
    const address = request.url();
    if (!address.startsWith(url) && !/^(blob|data):/.test(address)) troubles.push(`request to ${address}`);
  });
}

export async function openStage(words: readonly string[] = []): Promise<Stage> {
  if (!existsSync(join(web, '../build/web/index.html'))) throw new Error('run "npm run build" first');
  mkdirSync(pictures, { recursive: true });
  const server = await preview({ root: web, preview: { port: 0, host: '127.0.0.1' }, logLevel: 'error' });
  const address = server.httpServer.address();
  if (address === null || typeof address === 'string') throw new Error('the server has no port');
  const url = `http://127.0.0.1:${address.port}/`;
  const profile = mkdtempSync(join(tmpdir(), 'relievo-browser-'));
  const context = await openContext(profile, words);
  const page = context.pages()[0] ?? (await context.newPage());
  const stage = { server, context, page, url, profile, words, troubles: [] };
  watch(stage);
  await openPage(stage);
  return stage;
}

/** Opens the page and waits for its first screen, since the page handles no drops or keys before. */
async function openPage(stage: Stage): Promise<void> {
  await stage.page.goto(stage.url);
  await stage.page.locator('button:visible').first().waitFor();
}

/** Ends the browser without warning and opens it again with the same storage. */
export async function reopen(stage: Stage): Promise<void> {
  // The browser may have ended already.
  await stage.context.close().catch(() => undefined);
  stage.context = await openContext(stage.profile, stage.words);
  watch(stage);
  stage.page = stage.context.pages()[0] ?? (await stage.context.newPage());
  await openPage(stage);
}

export async function closeStage(stage: Stage): Promise<void> {
  await stage.context.close();
  await stage.server.close();
  rmSync(stage.profile, { recursive: true, force: true });
}

/** Opens one stage for the tests of a file. With `anew` each test starts at the first screen. */
export function stageOfFile({ anew, words = [] }: { anew: boolean; words?: readonly string[] }): Stage {
  const stage = {} as Stage;
  beforeAll(async () => {
    Object.assign(stage, await openStage(words));
  });
  beforeEach(async () => {
    if (anew) await openPage(stage);
  });
  afterAll(() => closeStage(stage));
  return stage;
}

/** Waits until the full relief of the current document is on the screen. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(
    () => {
      const numbers = document.querySelector<HTMLElement>('.workspace[aria-busy=false] .numbers');
      return numbers?.dataset['phase'] === 'idle' && Number(numbers.dataset['nodes']) > 5000;
    },
    undefined,
    { timeout: 60_000 },
  );
}

/** Waits until the current relief, if there is one, is on the screen. */
async function seen(page: Page): Promise<void> {
  const isSeen = (): boolean => {
    const numbers = document.querySelector<HTMLElement>('.numbers');
    return !numbers || numbers.dataset['nodes'] === '0' || numbers.textContent !== '';
  };
  await page.waitForFunction(isSeen, undefined, { timeout: 5000 }).catch(() => undefined);
}

export async function picture(page: Page, name: string): Promise<void> {
  await seen(page);
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}

/** Takes a screenshot once nothing moves any more, since a worker draws the relief in its own time. */
export async function stillPicture(page: Page, name: string): Promise<void> {
  await seen(page);
  let before = await page.screenshot();
  for (let tries = 0; tries < 20; tries++) {
    await page.waitForTimeout(100);
    const now = await page.screenshot();
    if (now.equals(before)) break;
    before = now;
  }
  writeFileSync(join(pictures, `${name}.png`), before);
}

/** Runs an action and waits until the relief looks different. */
export async function changedRelief(page: Page, act: () => Promise<void>): Promise<void> {
  const canvas = page.locator('.model canvas');
  const before = await canvas.screenshot();
  await act();
  await expect.poll(async () => (await canvas.screenshot()).equals(before), { timeout: 15_000 }).toBe(false);
}

/** Returns each distinct colour of a screenshot of the relief as red, green and blue. */
export async function coloursOfRelief(page: Page): Promise<[number, number, number][]> {
  const shot = (await page.locator('.model canvas').screenshot()).toString('base64');
  const packed = await page.evaluate(async (data) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context?.drawImage(image, 0, 0);
    const { data: pixels } = context?.getImageData(0, 0, image.width, image.height) ?? { data: [] };
    const seen = new Set<number>();
    for (let i = 0; i < pixels.length; i += 4) seen.add(((pixels[i] as number) << 16) + ((pixels[i + 1] as number) << 8) + (pixels[i + 2] as number));
    return [...seen];
  }, shot);
  return packed.map((colour) => [colour >> 16, (colour >> 8) & 255, colour & 255]);
}
