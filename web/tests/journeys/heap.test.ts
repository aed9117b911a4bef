import type { CDPSession } from 'playwright-core';
import { expect, it } from 'vitest';
import { choosePart, sample } from './actions.ts';
import { settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: false });

/** Returns the size of the page's heap after garbage collection, bytes. */
async function heapOf(session: CDPSession): Promise<number> {
  await session.send('HeapProfiler.collectGarbage');
  return (await session.send('Runtime.getHeapUsage')).usedSize;
}

it('keeps its heap within ten megabytes over a thousand edits', async () => {
  const { page, context } = stage;
  await sample(page, 'wolf');
  await choosePart(page, 'body');
  const session = await context.newCDPSession(page);
  // Each edit is a separate step.
  const edit = (count: number): Promise<void> =>
    page.evaluate(async (edits) => {
      for (let i = 0; i < edits; i++) {
        document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'h', code: 'KeyH', bubbles: true }));
        await new Promise((resolve) => setTimeout(resolve, 0));
      }
    }, count);
  await edit(50);
  await settled(page);
  const before = await heapOf(session);
  await edit(1000);
  await settled(page);
  const grown = (await heapOf(session)) - before;
  console.info(`heap: ${Math.round(before / 1e5) / 10} MB, ${Math.round(grown / 1e5) / 10} MB more after 1000 edits`);
  expect(await page.locator('#undo').isEnabled()).toBe(true);
  expect(grown).toBeLessThan(10e6);
  expect(stage.troubles).toEqual([]);
});
