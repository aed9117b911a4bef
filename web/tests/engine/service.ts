import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { type BuildOptions, type FileSettings, type Failure, isFailure } from '../../engine/messages';
import { ReliefService } from '../../engine/relief_service';
import { root } from '../support/command_line';

export const usual: BuildOptions = {
  method: 'approximate',
  vertices: 20000,
  edge: 0,
  rho: 0.25,
  alpha0: 0,
  lambdaBnd: 0.01,
  lambdaShift: 1,
  glue: true,
};

/** Settings of files, as the command line has them. */
export const usualFile: FileSettings = { sizeMm: 100, inkWidth: 1 };

export const shown = { drawing: null, visibility: 'orbit', tolerance: 0.25, field: 'relief' } as const;

export function must<T extends object>(value: T | Failure): T {
  if (isFailure(value)) throw new Error(`${value.error.where}: ${value.error.message}`);
  return value;
}

/** The weights that flat drawings are perceived with. */
export const network = new Uint8Array(readFileSync(join(root, 'src/understanding/perception/network.bin')));

export async function startService(): Promise<ReliefService> {
  const bytes = readFileSync(join(root, 'build/wasm/bindings/wasm/relievo.wasm'));
  return ReliefService.start(await WebAssembly.compile(bytes));
}
