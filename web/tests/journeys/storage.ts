import { readdirSync, readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';

/** The content of the browser's storage, read without the editor. */
export interface KeptEntry {
  id: string;
  name: string;
  versions: { number: number }[];
  done: number[];
  undone: number[];
  /** The number of parts, and of joins, in every version, oldest first. */
  parts: number[];
  joins: number[];
}

/** Returns every document of the shelf, by name. */
export function shelfOf(page: Page): Promise<KeptEntry[]> {
  return page.evaluate(async () => {
    const asked = <T>(request: IDBRequest<T>): Promise<T> =>
      new Promise((resolve, reject) => {
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(new Error('no storage'));
      });
    const database = await asked(indexedDB.open('relievo'));
    const transaction = database.transaction(['entries', 'versions']);
    const entries = await asked<KeptEntry[]>(transaction.objectStore('entries').getAll());
    const versions = await asked<{ id: string; fields: { parts: string; joins: string } }[]>(transaction.objectStore('versions').getAll());
    database.close();
    return entries
      .map(({ id, name, versions: notes, done, undone }) => {
        const own = versions.filter((version) => version.id === id);
        const count = (text: string): number => (JSON.parse(text) as unknown[]).length;
        return {
          id, name, versions: notes, done, undone,
          parts: own.map(({ fields }) => count(fields.parts)), joins: own.map(({ fields }) => count(fields.joins)),
        };
      })
      .sort((a, b) => a.name.localeCompare(b.name));
  });
}

interface Process {
  id: number;
  parent: number;
  words: string[];
}

function processes(): Process[] {
  return readdirSync('/proc').filter((entry) => /^\d+$/.test(entry)).flatMap((entry) => {
    try {
      // Some programs write all their arguments as one.
      const words = readFileSync(`/proc/${entry}/cmdline`, 'utf8').split(/[\0 ]/);
      const parent = Number(/\) \S (\d+)/.exec(readFileSync(`/proc/${entry}/stat`, 'utf8'))?.[1]);
      return [{ id: Number(entry), parent, words }];
    } catch {
      // The process has ended.
      return [];
    }
  });
}

function browserOf(profile: string): number {
  const browser = processes().find(({ words }) => words.includes(`--user-data-dir=${profile}`) && !words.some((word) => word.startsWith('--type=')));
  if (!browser) throw new Error('the browser does not run');
  return browser.id;
}

/** Returns a process and all its descendants. */
function familyOf(first: number): Process[] {
  const all = processes();
  const isOurs = ({ id, parent }: Process): boolean => {
    const above = all.find((one) => one.id === parent);
    return id === first || (above !== undefined && isOurs(above));
  };
  return all.filter(isOurs);
}

/** Kills the browser of a profile at once, as a crash does. */
export async function killBrowser(profile: string): Promise<void> {
  const browser = browserOf(profile);
  const ours = new Set(familyOf(browser).map(({ id }) => id));
  process.kill(browser, 'SIGKILL');
  // Its child processes end a little later and lock the storage until then.
  const lives = ({ id, words }: Process): boolean => ours.has(id) && words.some((word) => word !== '');
  for (let i = 0; i < 100 && processes().some(lives); i++) await new Promise((resolve) => setTimeout(resolve, 50));
}

/** Kills the graphics process of the browser of a profile. */
export function killGraphics(profile: string): void {
  const graphics = familyOf(browserOf(profile)).filter((one) => one.words.includes('--type=gpu-process'));
  if (graphics.length === 0) throw new Error('the browser has no graphics');
  for (const { id } of graphics) process.kill(id, 'SIGKILL');
}
