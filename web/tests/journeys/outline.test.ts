import { expect, it } from 'vitest';
import { grips } from '../../document/reshape.ts';
import { choosePart, gesture, outlineOf, oval, pageView, sample, save, type Spot } from './actions.ts';
import { picture, settled, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

/** Returns the point of a ring that is farthest in a direction. */
function farthest(ring: Spot[], [x, y]: Spot): Spot {
  return ring.reduce((a, b) => (a[0] * x + a[1] * y > b[0] * x + b[1] * y ? a : b));
}

it('pushes an outline by its grips, redraws a stretch of it, and undoes both', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(500, 420, 220, 160));
  await settled(page);
  const before = await save(page, 'outline-before.relievo');
  const first = await outlineOf(page, 'part');
  const right = farthest(first, [1, 0]);
  await page.keyboard.press('8');
  // The first grip is the first point of an outline.
  const grip = first[0]!;
  await gesture(page, [grip, [grip[0] + 40, grip[1] - 5], [grip[0] + 80, grip[1] - 10]]);
  await settled(page);
  const pushed = await outlineOf(page, 'part');
  expect(farthest(pushed, [1, 0])[0]).toBeGreaterThan(right[0] + 60);
  await picture(page, 'outline-pushed');
  const left = farthest(pushed, [-1, 0]);
  const top = pushed.reduce((a, b) => (Math.hypot(a[0] - 380, a[1] - 285) < Math.hypot(b[0] - 380, b[1] - 285) ? a : b));
  const bottom = pushed.reduce((a, b) => (Math.hypot(a[0] - 380, a[1] - 555) < Math.hypot(b[0] - 380, b[1] - 555) ? a : b));
  await gesture(page, [offGrip(pushed, top), [300, 250], [200, 340], [190, 460], [300, 570], offGrip(pushed, bottom)]);
  await settled(page);
  const redrawn = await outlineOf(page, 'part');
  expect(farthest(redrawn, [-1, 0])[0]).toBeLessThan(left[0] - 40);
  await picture(page, 'outline-redrawn');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect((await save(page, 'outline-undone.relievo')).equals(before)).toBe(true);
  expect(stage.troubles).toEqual([]);
});

/** Returns a point of the ring near `spot` between two grips, on a page that fits its pane. */
function offGrip(ring: Spot[], spot: Spot): Spot {
  return ring[(ring.indexOf(spot) + 1) % ring.length] ?? spot;
}

it('shows hidden outlines dashed, and extends a part below another', async () => {
  const { page } = stage;
  await sample(page, 'elephant');
  await choosePart(page, 'body');
  await page.keyboard.press('8');
  await page.waitForTimeout(200);
  await picture(page, 'outline-hidden');
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForTimeout(200);
  await picture(page, 'outline-hidden-dark');
  await page.emulateMedia({ colorScheme: 'light' });
  const before = await outlineOf(page, 'body');
  const { scale } = await pageView(page);
  const spots = grips([before], (4 * 12) / scale).map((grip): Spot => [grip.point[0], grip.point[1]]);
  const left = farthest(spots, [-1, 0]);
  await gesture(page, [left, [left[0] - 20, left[1]], [left[0] - 40, left[1]]]);
  await settled(page);
  expect(farthest(await outlineOf(page, 'body'), [-1, 0])[0]).toBeLessThan(left[0] - 35);
  await picture(page, 'outline-extended');
  expect(stage.troubles).toEqual([]);
});

it('refuses an outline that would cross itself with a message, and moves grips by keys', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(500, 420, 220, 60));
  await settled(page);
  await page.keyboard.press('8');
  const first = await outlineOf(page, 'part');
  await gesture(page, [first[0]!]);
  await page.locator('.paper canvas').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowRight');
  const moved = await outlineOf(page, 'part');
  expect(farthest(moved, [1, 0])[0]).toBeCloseTo(farthest(first, [1, 0])[0] + 11, 0);
  await page.keyboard.press('Control+z');
  expect(await outlineOf(page, 'part')).toEqual(first);
  await gesture(page, [first[0]!, [400, 420], [200, 420]]);
  expect(await page.locator('[role=status]').innerText()).toContain('cross itself');
  expect(stage.troubles).toEqual([]);
});
