import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll } from 'vitest';

export const root = fileURLToPath(new URL('../../..', import.meta.url));

/** Runs the command line program, which must be built. */
export function relievo(...words: string[]): void {
  const program = process.env['RELIEVO'] ?? join(root, 'build/dev/apps/cli/relievo');
  if (!existsSync(program)) throw new Error(`${program} is not built; set RELIEVO to another`);
  execFileSync(program, words);
}

/** Makes a folder for the files of a test file or group; it is deleted after the last test. */
export function temporaryFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'relievo-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
