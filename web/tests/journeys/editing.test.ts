import { expect, it } from 'vitest';
import { choosePart, gesture, names, outlineOf, oval, pageView, sample, save } from './actions.ts';
import { picture, settled, stageOfFile, stillPicture } from './browser.ts';

const stage = stageOfFile({ anew: true });

it('orders, joins and hollows parts by keyboard, and undo leads back to the same bytes', async () => {
  const { page } = stage;
  await sample(page, 'bunny');
  const before = await save(page, 'before.relievo');
  const order = await names(page);
  await page.locator('.parts li').nth(2).click();
  await page.keyboard.press('PageDown');
  expect((await names(page))[3]).toBe(order[2]);
  await page.keyboard.press('j');
  await page.keyboard.press('h');
  await page.locator('.slider input').first().fill('6');
  await settled(page);
  await picture(page, 'edited');
  const after = await save(page, 'after.relievo');
  expect(after.equals(before)).toBe(false);
  const undo = page.locator('#undo');
  while (await undo.isEnabled()) await undo.click();
  expect((await save(page, 'undone.relievo')).equals(before)).toBe(true);
  const redo = page.locator('#redo');
  while (await redo.isEnabled()) await redo.click();
  expect((await save(page, 'redone.relievo')).equals(after)).toBe(true);
  expect(stage.troubles).toEqual([]);
});

it('sets a soft range with two clicks', async () => {
  const { page } = stage;
  await sample(page, 'elephant');
  await choosePart(page, 'near-ear');
  await page.keyboard.press('5');
  const ear = await outlineOf(page, 'near-ear');
  await gesture(page, [ear[0]!]);
  await gesture(page, [ear[Math.floor(ear.length / 6)]!]);
  await settled(page);
  await picture(page, 'range');
  const clear = page.locator('.neighbour .chip', { hasText: 'Clear ranges' });
  expect(await clear.count()).toBe(1);
  await clear.click();
  expect(await clear.count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('joins with a line across the root', async () => {
  const { page } = stage;
  await sample(page, 'elephant');
  const tail = await outlineOf(page, 'tail');
  const root = tail.reduce((a, b) => (a[0] < b[0] ? a : b));
  await choosePart(page, 'tail');
  await page.keyboard.press('Home');
  expect((await names(page))[0]).toBe('tail');
  await page.keyboard.press('3');
  await gesture(page, [[root[0], root[1] - 25], [root[0] - 6, root[1]], [root[0] + 2, root[1] + 25]]);
  await settled(page);
  await picture(page, 'joined');
  expect(await page.locator('.parts li').first().locator('.joined').count()).toBe(1);
  expect(stage.troubles).toEqual([]);
});

it('joins with a click on a suggestion', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(400, 400, 200, 150));
  await gesture(page, oval(640, 400, 130, 60));
  await settled(page);
  await page.keyboard.press('3');
  await page.keyboard.press('Escape');
  await page.waitForTimeout(200);
  await picture(page, 'suggested');
  const part = await outlineOf(page, 'part 2');
  const root = part.reduce((a, b) => (a[0] < b[0] ? a : b));
  await gesture(page, [root]);
  await settled(page);
  expect(await page.locator('.parts li .joined').count()).toBe(1);
  expect(stage.troubles).toEqual([]);
});

it('orders with an arrow', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(400, 400, 200, 150));
  await gesture(page, oval(650, 400, 150, 150));
  expect(await names(page)).toEqual(['part 2', 'part']);
  await page.keyboard.press('4');
  await gesture(page, [[300, 400], [720, 400]]);
  expect(await names(page)).toEqual(['part', 'part 2']);
  await settled(page);
  expect(stage.troubles).toEqual([]);
});

it('loses nothing when the engine crashes', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(400, 400, 200, 150));
  await settled(page);
  for (const worker of page.workers())
    await worker.evaluate(() => {
      setTimeout(() => {
        throw new Error('dead');
      });
    });
  await page.waitForTimeout(300);
  stage.troubles.length = 0;
  await gesture(page, oval(650, 500, 120, 100));
  await settled(page);
  expect(await names(page)).toEqual(['part 2', 'part']);
  expect(stage.troubles).toEqual([]);
});

it('names the part that prevents a build, and keeps the last good relief', async () => {
  const { page } = stage;
  await page.click('#empty');
  await gesture(page, oval(400, 400, 200, 150));
  await gesture(page, oval(600, 500, 120, 100));
  await page.keyboard.press('1');
  await page.keyboard.press('j');
  await settled(page);
  const nodes = await page.locator('.numbers').getAttribute('data-nodes');
  // Slides an end of the join so far that the join lies beside the body.
  const { at } = await pageView(page);
  await page.mouse.move(...at([488, 535]));
  await page.mouse.down();
  await page.mouse.move(...at([704, 450]));
  await page.mouse.up();
  await page.waitForSelector('.trouble');
  await stillPicture(page, 'trouble');
  expect(await page.locator('.parts li.culprit .name').innerText()).toBe('part 2');
  expect(await page.locator('.trouble').innerText()).toContain('join');
  expect(await page.locator('.numbers').getAttribute('data-nodes')).toBe(nodes);
  await page.keyboard.press('Control+z');
  await settled(page);
  expect(await page.locator('.trouble').count()).toBe(0);
  expect(stage.troubles).toEqual([]);
});

it('keeps a name that is being typed while the relief is made', async () => {
  const { page } = stage;
  await sample(page, 'lamb');
  await choosePart(page, 'body');
  await page.locator('.slider input').first().fill('5');
  const field = page.locator('.part-panel input.title');
  await field.fill('belly');
  await settled(page);
  expect(await field.inputValue()).toBe('belly');
  await field.blur();
  expect(await names(page)).toContain('belly');
  await page.locator('.document-name').fill('');
  await page.locator('.document-name').blur();
  expect(await page.locator('.document-name').inputValue()).toBe('lamb');
  expect(stage.troubles).toEqual([]);
});
