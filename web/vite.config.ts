import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { contentPolicy, offlineCopy } from './build_plugins.ts';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** The core, built by the wasm preset. */
const core = at('../build/wasm/bindings/wasm');

const journeysOf = (...names: string[]): string[] => names.map((name) => `tests/journeys/${name}.test.ts`);
/** Journeys that measure times. They run alone. */
const measured = journeysOf('responsive');
/** Journeys of everyday use: opening, drawing, scribbling, correcting, saving. The long run has all others too. */
const everyday = journeysOf('doubts', 'drawing', 'editing', 'gaps', 'hands', 'layers', 'pictures', 'projects', 'safety', 'samples', 'scribbles', 'strokes');
const journeys = process.env['RELIEVO_LONG'] ? journeysOf('*') : everyday;
const journey = { retry: 1, testTimeout: 120_000, hookTimeout: 120_000, expect: { poll: { timeout: 30_000 } } };

export default defineConfig({
  base: './',
  plugins: [contentPolicy(), offlineCopy()],
  resolve: {
    alias: [
      { find: '#relievo', replacement: `${core}/relievo.mjs` },
      { find: /^#core\.wasm/, replacement: `${core}/relievo.wasm` },
      { find: /^#network\.bin/, replacement: at('../src/understanding/perception/network.bin') },
    ],
  },
  server: { fs: { allow: [at('..')] } },
  preview: { host: '127.0.0.1', port: 8080 },
  worker: { format: 'es' },
  build: { outDir: at('../build/web'), emptyOutDir: true, assetsInlineLimit: 0, chunkSizeWarningLimit: 900 },
  test: {
    projects: [
      { extends: true, test: { name: 'unit', include: ['tests/unit/**/*.test.ts'], testTimeout: 60_000 } },
      {
        extends: true,
        test: { name: 'engine', include: ['tests/engine/**/*.test.ts'], testTimeout: 180_000 },
      },
      {
        extends: true,
        test: { ...journey, name: 'journeys', include: journeys, exclude: measured, maxWorkers: 2, sequence: { groupOrder: 1 } },
      },
      {
        extends: true,
        test: { ...journey, name: 'measured', include: measured, fileParallelism: false, sequence: { groupOrder: 2 } },
      },
    ],
  },
});
