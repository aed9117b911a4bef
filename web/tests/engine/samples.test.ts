import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import validator from 'gltf-validator';
import { beforeAll, describe, expect, it } from 'vitest';
import { type BuildOptions, isFailure, type SolidFormat, type SolidOptions, type Texture } from '../../engine/messages';
import type { ReliefService } from '../../engine/relief_service';
import { relievo, root, temporaryFolder } from '../support/command_line';
import { pngOf } from '../support/pictures';
import { must, shown, startService, usual, usualFile } from './service';

const samples = ['bunny', 'elephant', 'farmer', 'lamb', 'unicorn', 'wolf'];

const quiet = (): void => undefined;

let service: ReliefService;

beforeAll(async () => {
  service = await startService();
});

function importSample(name: string): string {
  return must(service.importSvg(readFileSync(join(root, 'examples', `${name}.svg`)))).scene;
}

function build(scene: string, changed: Partial<BuildOptions> = {}) {
  return must(
    service.build(
      { scene, options: { ...usual, ...changed }, ...shown },
      quiet,
    ),
  );
}

describe('the engine and the command line', () => {
  const folder = temporaryFolder();

  /** Returns the file that the command line makes of the same scene. */
  function native(name: string, scene: string, ...more: string[]): void {
    const file = join(folder, `${name}.json`);
    writeFileSync(file, scene);
    relievo('build', file, '-q', '--vertices', '20000', ...more);
  }

  it.each(samples)('make the same bytes of %s', (name) => {
    const scene = importSample(name);
    native(name, scene, '-o', join(folder, `${name}.glb`), '--normal-map', join(folder, `${name}.png`));
    build(scene);
    const [file] = must(service.encode('glb', name, usualFile, null)).files;
    expect(Buffer.from(file!.bytes).equals(readFileSync(join(folder, `${name}.glb`)))).toBe(true);
    const map = must(service.map('normal', 2048, false)).bytes;
    expect(Buffer.from(map).equals(readFileSync(join(folder, `${name}.png`)))).toBe(true);
  });

  it('make the same lines of the contour of a circle', () => {
    const size = 200;
    const middle = size / 2;
    const radius = 87;
    const [black, orange] = [[0, 0, 0], [232, 160, 106]] as const;
    const paint = (x: number, y: number) => {
      const inside = radius - Math.hypot(x + 0.5 - middle, y + 0.5 - middle);
      const mixed = Math.min(1, Math.max(0, inside - 5.5));
      const [r, g, b] = black.map((ink, c) => Math.round((1 - mixed) * ink + mixed * orange[c]!)) as [number, number, number];
      return [r, g, b, Math.round(255 * Math.min(1, Math.max(0, inside + 0.5)))] as const;
    };
    const outline = Array.from({ length: 120 }, (_, i) => {
      const turn = (i * Math.PI) / 60;
      return [middle + radius * Math.cos(turn), middle + radius * Math.sin(turn)];
    });
    const scene = JSON.stringify({
      format: 'relievo-scene', version: 1, canvas: { width: size, height: size }, drawing: 'circle.png',
      parts: [{ id: 'ball', outline: [outline] }],
    });
    writeFileSync(join(folder, 'circle.png'), pngOf(size, size, paint));
    build(scene);
    const rgba = Uint8Array.from(Array.from({ length: size * size }, (_, i) => paint(i % size, Math.floor(i / size))).flat());
    const picture = { rgba, width: size, height: size };
    for (const [inkWidth, options] of [[1, []], [2, ['--ink-width', '2']], [0, ['--ink', 'none']]] as const) {
      native('circle', scene, '-o', join(folder, 'circle.glb'), ...options);
      const [file] = must(service.encode('glb', 'circle', { sizeMm: 100, inkWidth }, picture)).files;
      expect(Buffer.from(file!.bytes).equals(readFileSync(join(folder, 'circle.glb')))).toBe(true);
    }
    const reach = (positions: Float32Array | undefined): number => positions?.reduce((most, x, i) => (i % 3 === 0 ? Math.max(most, x) : most), 0) ?? 0;
    for (const [inkWidth, most] of [[1, 187], [2, 193]] as const) {
      const { surface } = must(service.dress(shown.tolerance, inkWidth, picture));
      // The surface ends at the inner edge of the contour.
      expect(reach(surface.positions)).toBeCloseTo(181, -0.5);
      expect(Math.abs(reach(surface.ink?.positions) - most)).toBeLessThan(1.5);
    }
    expect(must(service.dress(shown.tolerance, 0, picture)).surface.ink).toBeUndefined();
  });

  it('make the same bytes after edits that reuse the build before', () => {
    const scene = importSample('wolf');
    const edited = scene.replace(/"c": ?[0-9.]+/g, '"c": 3.1');
    expect(edited).not.toBe(scene);
    native('edited', edited, '-o', join(folder, 'edited.glb'), '--depth-map', join(folder, 'edited.png'));
    build(scene);
    const { report } = build(edited);
    expect(report.times['mesh']).toBeUndefined();
    expect(report.times['order']).toBeGreaterThan(0);
    const map = must(service.map('depth', 2048, false)).bytes;
    expect(Buffer.from(map).equals(readFileSync(join(folder, 'edited.png')))).toBe(true);
    const [file] = must(service.encode('glb', 'edited', usualFile, null)).files;
    expect(Buffer.from(file!.bytes).equals(readFileSync(join(folder, 'edited.glb')))).toBe(true);
  });

  it('make the same bytes in every format, and by the non-linear method', () => {
    const scene = importSample('lamb');
    const outputs = ['obj', 'ply', 'stl'].flatMap((format) => ['-o', join(folder, `lamb.${format}`)]);
    native('lamb', scene, '--method', 'nonlinear', ...outputs);
    build(scene, { method: 'nonlinear' });
    for (const format of ['obj', 'ply', 'stl'] as const) {
      const [file] = must(service.encode(format, 'lamb', usualFile, null)).files;
      expect(Buffer.from(file!.bytes).equals(readFileSync(join(folder, `lamb.${format}`)))).toBe(true);
    }
  });

  it('make the same bytes of solids', () => {
    const scene = importSample('lamb');
    const plaque = { size: 80, back: 'flat', base: 'plate', height: 9, detail: true, thickness: 2, hole: 4, ring: 0 } as const;
    native('plaque', scene, '-o', join(folder, 'plaque.stl'), '--profile', 'solid', '--base', 'plate', '--height', '9', '--height-mode', 'detail', '--hole', '4', '--size', '80');
    native('figure', scene, '-o', join(folder, 'figure.stl'), '-o', join(folder, 'figure.usdz'), '-o', join(folder, 'figure.3mf'), '--profile', 'figure', '--back', 'parts');
    build(scene);
    const none: Texture = { rgba: new Uint8Array(), width: 0, height: 0 };
    const same = (format: SolidFormat, name: string, options: SolidOptions): void => {
      const [file] = must(service.encodeSolid(format, name, { ...options, inkWidth: 1 }, none)).files;
      expect(Buffer.from(file!.bytes).equals(readFileSync(join(folder, `${name}.${format}`)))).toBe(true);
    };
    same('stl', 'plaque', plaque);
    const figure = { ...plaque, size: 100, back: 'parts', base: 'none', height: 0, detail: false, hole: 0 } as const;
    same('stl', 'figure', figure);
    same('usdz', 'figure', figure);
    native('standing', scene, '-o', join(folder, 'standing.stl'), '--profile', 'figure', '--base', 'round');
    same('stl', 'standing', { back: 'plain', base: 'round' });
    const packed = unzipSync(readFileSync(join(folder, 'figure.3mf')));
    for (const { name, bytes } of must(service.encodeSolid('3mf', 'figure', { ...figure, inkWidth: 1 }, none)).files)
      expect(Buffer.from(bytes).equals(packed[name]!), name).toBe(true);
    for (const [wrong, where] of [[{ size: -1 }, 'size'], [{ base: 'square' }, 'base'], [{ sizes: 1 }, 'sizes']] as const) {
      const refused = service.solid(wrong as SolidOptions, none);
      expect(isFailure(refused) && refused.error).toMatchObject({ code: 'usage', where });
    }
  });
});

describe('the engine', () => {
  it('embeds a drawing in files that the validator accepts', async () => {
    build(importSample('wolf'), { vertices: 4000 });
    const texture = { rgba: new Uint8Array(64 * 64 * 4).fill(200), width: 64, height: 64 };
    const [file] = must(service.encode('glb', 'wolf', usualFile, texture)).files;
    const report = await validator.validateBytes(file!.bytes);
    expect(report.issues.numErrors).toBe(0);
    expect(report.issues.numWarnings).toBe(0);
  });

  it('returns surfaces whose parts cover all triangles, inside the canvas', () => {
    const scene = importSample('bunny');
    const { surface, report } = build(scene, { vertices: 4000 });
    const { canvas } = JSON.parse(scene) as { canvas: { width: number; height: number } };
    const total = surface.parts.reduce((sum, part) => sum + part.triangleCount, 0);
    expect(total).toBe(surface.triangles.length / 3);
    expect(surface.normals.length).toBe(surface.positions.length);
    for (let i = 0; i < surface.positions.length; i += 3) {
      expect(surface.positions[i]).toBeGreaterThanOrEqual(0);
      expect(surface.positions[i]).toBeLessThanOrEqual(canvas.width);
    }
    expect(report.maxViolation).toBeLessThan(1e-6);
  });

  it('shows joins, equal heights and ramps where the scene has them', () => {
    const { overlays } = build(importSample('wolf'), { vertices: 4000 });
    expect(overlays.joins.length % 4).toBe(0);
    expect(overlays.joins.length).toBeGreaterThan(0);
    expect(overlays.ramps.length % 6).toBe(0);
    for (let i = 4; i < overlays.ramps.length; i += 6) {
      expect(overlays.ramps[i]).toBeGreaterThanOrEqual(0);
      expect(overlays.ramps[i]).toBeLessThanOrEqual(1);
    }
  });

  it('names the cause when it refuses a scene, and stays usable', () => {
    const scene = importSample('lamb');
    const broken = scene.replace(/"c": [0-9.]+/, '"c": -1');
    const refused = service.build({ scene: broken, options: usual, ...shown }, quiet);
    expect(isFailure(refused) && refused.error.code).toBe('bad_input');
    expect(isFailure(refused) && refused.error.where).toBe('parts[0].c');
    expect(isFailure(refused) && refused.error.culprit).toEqual({ list: 'parts', index: 0 });
    build(scene, { vertices: 2000 });
  });

  it('removes scripts and references from a hostile drawing', () => {
    const hostile = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 500" onload="x()">
      <script>x()</script><foreignObject><p>x</p></foreignObject>
      <image href="https://example.org/a.png" width="9" height="9"/>
      <g data-relievo="part" id="a"><path fill="red" d="M50 50H400V400H50Z"/></g></svg>`;
    const { paintable } = must(service.importSvg(new TextEncoder().encode(hostile)));
    expect(paintable).not.toMatch(/script|foreignObject|example\.org/);
    expect(paintable).toContain('M50 50H400V400H50Z');
  });

  it('gives the page a drawing whose styles are resolved', () => {
    const styled = `<?xml version="1.0" encoding="UTF-16"?><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 500">
      <style>:root{--c:#d95} rect{fill:var(--c);transform:translate(10%,20px)}</style>
      <rect x="50" y="50" width="300" height="300"/></svg>`;
    const utf16 = new Uint8Array(2 * styled.length);
    [...styled].forEach((letter, i) => (utf16[2 * i] = letter.charCodeAt(0)));
    const { paintable, lineArt } = must(service.importSvg(utf16));
    expect(paintable).toContain('fill:#d95');
    expect(paintable).toContain('matrix(1 0 0 1 50 20)');
    expect(paintable).not.toContain('<style');
    expect(lineArt).toBe(false);
  });

  it('takes a drawing of one picture for a flat one', () => {
    const picture = 'iVBORw0KGgoAAAANSUhEUgAAAAQAAAACCAYAAAB/qH1jAAAAE0lEQVR4nGP4z8DwH4QZYABdAACnegf5wTo2swAAAABJRU5ErkJggg==';
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 200"><image width="400" height="200" href="data:image/png;base64,${picture}"/></svg>`;
    const imported = must(service.importSvg(new TextEncoder().encode(svg)));
    expect(imported.lineArt).toBe(true);
    expect(imported.paintable).toContain(picture);
  });

  it('tells whether the shapes of a drawing are those that are painted', () => {
    const svg = new TextEncoder().encode('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40"><path fill="#c54" d="M0 0H20V40H0z"/></svg>');
    const painting = (width: number): Texture => {
      const rgba = new Uint8Array(4 * 40 * 40);
      for (let i = 0; i < 40 * 40; i++) if (i % 40 < width) rgba.set([204, 85, 68, 255], 4 * i);
      return { rgba, width: 40, height: 40 };
    };
    expect(must(service.departsFromPaint(svg, painting(20))).departs).toBe(false);
    expect(must(service.departsFromPaint(svg, painting(10))).departs).toBe(true);
    expect(must(service.departsFromPaint(svg, painting(30))).departs).toBe(true);
  });
});
