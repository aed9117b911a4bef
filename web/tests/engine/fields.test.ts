import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, expect, it } from 'vitest';
import type { Surface } from '../../engine/messages';
import type { ReliefService } from '../../engine/relief_service';
import { root } from '../support/command_line';
import { must, shown, startService, usual } from './service';

let service: ReliefService;
beforeAll(async () => {
  service = await startService();
});

const options = { ...usual, method: 'nonlinear', vertices: 3000 } as const;

function heights(surface: Surface): Float32Array {
  return surface.positions.filter((_, i) => i % 3 === 2);
}

it('reports the energy while the non-linear method runs, down to the energy of the report', () => {
  const { scene } = must(service.importSvg(readFileSync(join(root, 'examples/lamb.svg'))));
  const energies: number[] = [];
  const { report } = must(
    service.build({ scene, options, ...shown }, (_stage, _done, energy) => {
      if (energy !== undefined) energies.push(energy);
    }),
  );
  expect(energies.length).toBeGreaterThan(3);
  for (const energy of energies) expect(energy).toBeGreaterThan(0);
  expect(energies.at(-1)! / report.energy).toBeCloseTo(1, 3);
});

it('shows the heights as the sum of inflation and shift', () => {
  // The rim is refined by the heights; with a huge tolerance all fields have the same vertices.
  const at = { ...shown, tolerance: 1e6 };
  const { scene } = must(service.importSvg(readFileSync(join(root, 'examples/wolf.svg'))));
  const { surface } = must(service.build({ scene, options: { ...options, method: 'approximate' }, ...at }, () => undefined));
  const h = heights(surface);
  const f = heights(must(service.surface({ ...at, field: 'inflation' })));
  const g = heights(must(service.surface({ ...at, field: 'shift' })));
  expect([f.length, g.length]).toEqual([h.length, h.length]);
  // The surface of g has an inflation of 1 px added.
  const gaps = h.map((height, i) => Math.abs(height - (f[i]! + g[i]! - 1)));
  expect(gaps.filter((gap) => gap < 1e-3).length).toBeGreaterThan(0.99 * h.length);
});

it('gives hidden surfaces the colour of their own part', () => {
  const square = (x: number, y: number, side: number) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
  const scene = JSON.stringify({
    format: 'relievo-scene', version: 1, canvas: { width: 200, height: 200 },
    parts: [{ id: 'back', outline: [square(30, 30, 140)] }, { id: 'front', outline: [square(80, 80, 60)] }],
    relations: [{ upper: 'front', lower: 'back', relation: 'above' }],
  });
  const inFront = (i: number): boolean => [i % 200, Math.floor(i / 200)].every((at) => at >= 80 && at < 140);
  const rgba = Uint8Array.from({ length: 4 * 200 * 200 }, (_, k) => (k % 4 === 3 || (k % 4 === 0) === inFront(k >> 2) ? 255 : 0));
  const drawing = { rgba, width: 200, height: 200 };
  const { surface } = must(service.build({ ...shown, scene, options: { ...options, method: 'approximate' }, drawing }, () => undefined));
  const [back, front] = surface.parts;
  expect([back!.hiddenCount > 100, front!.hiddenCount]).toEqual([true, 0]);
  const last = back!.firstTriangle + back!.triangleCount;
  const hidden = surface.triangles.slice(3 * (last - back!.hiddenCount), 3 * last);
  const colors = new Set([...hidden].map((v) => surface.colors.slice(3 * v, 3 * v + 3).join(' ')));
  expect([...colors]).toEqual(['0 255 255']);
});
