import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { openRing } from '../support/pictures.ts';
import { choosePart, gesture, oval, sample } from './actions.ts';
import { picture, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Returns the problems that axe finds on the current page, one line each. */
async function violations(page: Page): Promise<string[]> {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { axe: checker } = window as unknown as { axe: { run(): Promise<{ violations: { id: string; nodes: { html: string; failureSummary: string }[] }[] }> } };
    const { violations: found } = await checker.run();
    return found.flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html.slice(0, 160)} — ${failureSummary.replace(/\s+/g, ' ')}`));
  });
}

/** Every state of the page, with the steps to it from the state before. */
const states: [string, (page: Page) => Promise<unknown>][] = [
  ['start', async () => undefined],
  ['workspace', (page) => sample(page, 'bunny')],
  ['a part', (page) => choosePart(page, 'body')],
  ['export', (page) => page.click('#export')],
  ['something to hold', async (page) => {
    await page.click('#print');
    await page.waitForSelector('[data-solid="3mf"]:not([disabled])');
  }],
  ['settings', (page) => page.click('#settings')],
  ['versions', (page) => page.click('#versions')],
  ['keys', (page) => page.click('#keys')],
  ['tour', (page) => page.click('#tour')],
  ['draw', (page) => page.keyboard.press('Escape').then(() => page.keyboard.press('2'))],
  ['profile', (page) => page.keyboard.press('9')],
  ['paint', (page) => page.keyboard.press('b')],
  ['a drawn part', async (page) => {
    await page.click('.brand');
    await page.click('#empty');
    await gesture(page, oval(500, 400, 200, 150));
    await page.waitForSelector('.swatches');
  }],
  ['scribble', async (page) => {
    await page.setInputFiles('input[type=file]', { name: 'ring.png', mimeType: 'image/png', buffer: Buffer.from(openRing()) });
    await page.waitForSelector('.scribble-bar[data-tint-ms]');
    await page.waitForSelector('.parts li');
    await page.click('[data-doubt=next]');
  }],
  ['shelf', async (page) => {
    await page.waitForTimeout(300);
    await page.click('.brand');
    await page.waitForSelector('.samples.kept li');
  }],
];

it.each(['light', 'dark'] as const)('has no accessibility problem that axe finds in any state, %s', async (colorScheme) => {
  const { page } = stage;
  await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
  const found: Record<string, string[]> = {};
  for (const [name, go] of states) {
    await go(page);
    await page.waitForTimeout(150);
    await picture(page, `axe-${colorScheme}-${name.replace(' ', '-')}`);
    found[name] = await violations(page);
  }
  expect(found).toEqual(Object.fromEntries(states.map(([name]) => [name, []])));
});
