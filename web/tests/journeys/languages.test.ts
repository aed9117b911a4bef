import { join } from 'node:path';
import { expect, it } from 'vitest';
import { sample } from './actions.ts';
import { pictures, stageOfFile } from './browser.ts';

const stage = stageOfFile({ anew: true });

/** Spaces letters by `more` of their size, as a wider font would. */
function setWider(more: number): Promise<void> {
  return stage.page.evaluate((more) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`* { letter-spacing: ${more}em; }`);
    document.adoptedStyleSheets = [sheet];
  }, more);
}

/** Returns texts that are cut off or wider than their element. */
function cutWords(): Promise<string[]> {
  return stage.page.evaluate(() => {
    const cut: string[] = [];
    for (const element of document.querySelectorAll<HTMLElement>('button, label, h2, .hint, summary')) {
      const shown = element.offsetParent !== null && !element.classList.contains('hidden');
      const { scrollWidth, clientWidth, scrollHeight, clientHeight } = element;
      const lines = element.classList.contains('hint') && scrollHeight > clientHeight + 1;
      if (shown && clientWidth > 0 && (lines || scrollWidth > clientWidth + 1)) cut.push(element.innerText);
    }
    if (document.documentElement.scrollWidth > innerWidth) cut.push('the page');
    return cut;
  });
}

it.each([['English', 'en'], ['Deutsch', 'de'], ['Français', 'fr'], ['Español', 'es'], ['日本語', 'ja']])('has room for %s, and remembers it', async (name, tag) => {
  const { page } = stage;
  await page.getByRole('button', { name, exact: true }).click();
  await page.locator(`html[lang=${tag}]`).waitFor();
  await setWider(0.06);
  const cut = await cutWords();
  await page.screenshot({ path: join(pictures, `language-${tag}-start.png`) });
  await sample(page, 'wolf');
  for (const tool of await page.locator('[data-tool]').all()) {
    await tool.click();
    cut.push(...(await cutWords()));
  }
  await page.locator('.parts li').first().click();
  cut.push(...(await cutWords()));
  await page.screenshot({ path: join(pictures, `language-${tag}.png`) });
  await page.click('#export');
  cut.push(...(await cutWords()));
  await page.screenshot({ path: join(pictures, `language-${tag}-export.png`) });
  await page.click('#print');
  await page.locator('#solid-facts').waitFor();
  cut.push(...(await cutWords()));
  await page.screenshot({ path: join(pictures, `language-${tag}-print.png`) });
  expect([...new Set(cut)]).toEqual([]);
  await page.reload();
  await page.locator('.languages').waitFor();
  await page.locator(`html[lang=${tag}]`).waitFor();
  expect(stage.troubles).toEqual([]);
});
