import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll } from 'vitest';

export const root = fileURLToPath(new URL('../../..', import.meta.url));

/** Runs the command line; the tests need it built. */
export function relievo(...words: string[]): void {
  const program = process.env['RELIEVO'] ?? join(root, 'build/dev/apps/cli/relievo');
  if (!existsSync(program)) throw new Error(`${program} is not built; set RELIEVO to another`);
  execFileSync(program, words);
}

/** A folder for what the tests of a file or group write, which goes with the last of them. */
export function temporaryFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'relievo-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
