import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../../..', import.meta.url));

/** Runs the command line; the tests need it built. */
export function relievo(...words: string[]): void {
  const program = process.env['RELIEVO'] ?? join(root, 'build/dev/apps/cli/relievo');
  if (!existsSync(program)) throw new Error(`${program} is not built; set RELIEVO to another`);
  execFileSync(program, words);
}
