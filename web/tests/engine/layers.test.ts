import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { strToU8, zipSync } from 'fflate';
import { beforeAll, describe, expect, it } from 'vitest';
import { isFailure, type OutputFile } from '../../engine/messages';
import type { ReliefService } from '../../engine/relief_service';
import { relievo, root, temporaryFolder } from '../support/command_line';
import { disc, photoshopOf } from '../support/pictures';
import { must, shown, startService, usual, usualFile } from './service';

let service: ReliefService;
beforeAll(async () => {
  service = await startService();
});

const folder = temporaryFolder();
const body = disc(200, 80, [200, 80, 60]);
const head = disc(100, 45, [60, 120, 190]);

const stack = `<?xml version="1.0"?><image version="0.0.3" w="320" h="240"><stack>
  <layer name="part:head" src="data/2.png" x="170" y="10"/>
  <layer name="shadow" src="data/2.png" x="0" y="0" visibility="hidden"/>
  <layer name="part:body" src="data/1.png" x="40" y="30"/></stack></image>`;

const ora: OutputFile[] = [
  { name: 'mimetype', bytes: strToU8('image/openraster') },
  { name: 'stack.xml', bytes: strToU8(stack) },
  { name: 'data/1.png', bytes: body },
  { name: 'data/2.png', bytes: head },
];

/** Returns a scene without the path of its drawing. */
function saidBy(scene: string): { joins?: object[]; relations?: object[] } {
  return { ...(JSON.parse(scene) as object), drawing: null } as object;
}

/** Expects the page to import the drawing exactly as the command line does. */
function expectSameScene(scene: string, input: string): void {
  const theirs = join(folder, 'understood.json');
  relievo('check', input, '-q', '-o', theirs);
  expect(saidBy(scene)).toEqual(saidBy(readFileSync(theirs, 'utf8')));
}

/** Expects the page's model and map of imported layers to equal those of the command line. */
function expectSameModel(files: OutputFile[], input: string): void {
  const [model, map] = [join(folder, 'layers.stl'), join(folder, 'depth.png')];
  relievo('build', input, '-q', '--vertices', '20000', '-o', model, '--depth-map', map);
  const { scene = '' } = must(service.importLayers(files));
  expectSameScene(scene, input);
  must(service.build({ scene, options: usual, ...shown }, () => undefined));
  const [stl] = must(service.encode('stl', 'layers', usualFile, null)).files;
  expect(Buffer.from(stl!.bytes).equals(readFileSync(model))).toBe(true);
  const depth = must(service.map('depth', 2048, false)).bytes;
  expect(Buffer.from(depth).equals(readFileSync(map))).toBe(true);
}

describe('a Photoshop document', () => {
  const paint = (red: number) => (x: number, y: number) => [red, 120, 60, Math.hypot(x - 99.5, y - 99.5) < 95 ? 255 : 0] as const;
  const layers = [
    { name: 'body', left: 40, top: 30, size: 200, paint: paint(200) },
    { name: 'head', left: 130, top: 90, size: 200, paint: paint(60) },
  ];

  it('makes the model that the command line makes', () => {
    const bytes = photoshopOf(400, 320, layers);
    const file = join(folder, 'figure.psd');
    writeFileSync(file, bytes);
    expectSameModel([{ name: 'figure.psd', bytes }], file);
  });

  it('of one layer is a flat picture', () => {
    const bytes = photoshopOf(400, 320, layers.slice(0, 1));
    const { scene, drawing } = must(service.importLayers([{ name: 'flat.psd', bytes }]));
    expect(scene).toBeUndefined();
    expect(drawing.length).toBeGreaterThan(100);
  });

  it('that is damaged is refused', () => {
    const bytes = photoshopOf(400, 320, layers).slice(0, 900);
    const refused = service.importLayers([{ name: 'cut.psd', bytes }]);
    expect(isFailure(refused) && refused.error.code).toBe('bad_input');
  });
});

describe('a layered drawing that does not say how its parts connect', () => {
  it.each(['bunny', 'farmer', 'wolf'])('is connected as by the command line: %s', (name) => {
    const said = readFileSync(join(root, `examples/${name}.svg`), 'utf8');
    const svg = said.replace(/<path class="join"[^>]*>/g, '').replace(/ data-relation="[a-z]*"/g, '');
    const file = join(folder, `${name}.svg`);
    writeFileSync(file, svg);
    const { scene } = must(service.importSvg(strToU8(svg)));
    expect(saidBy(scene).joins!.length).toBeGreaterThan(2);
    expect(saidBy(scene).relations!.length).toBeGreaterThan(2);
    expectSameScene(scene, file);
  });
});

describe('layers', () => {
  it('of an OpenRaster file make the model that the command line makes', () => {
    const file = join(folder, 'figure.ora');
    writeFileSync(file, zipSync(Object.fromEntries(ora.map(({ name, bytes }) => [name, bytes])), { level: 0 }));
    const { scene = '', proposed, warnings, drawing } = must(service.importLayers(ora));
    const { parts, canvas } = JSON.parse(scene) as { parts: { id: string }[]; canvas: object };
    expect(parts.map((part) => part.id)).toEqual(['body', 'head']);
    expect(canvas).toEqual({ width: 320, height: 240 });
    expect([proposed, warnings]).toEqual([false, []]);
    expect(Buffer.from(drawing.subarray(1, 4)).toString()).toBe('PNG');
    expectSameModel(ora, file);
  });

  it('that are separate pictures come in the natural order of their names', () => {
    const files = [
      { name: 'part10.png', bytes: disc(120, 55, [60, 120, 190]) },
      { name: 'part9.png', bytes: disc(240, 100, [200, 80, 60]) },
    ];
    const { scene = '' } = must(service.importLayers(files));
    const { parts } = JSON.parse(scene) as { parts: { id: string }[] };
    expect(parts.map((part) => part.id)).toEqual(['part9', 'part10']);
  });

  it('come in the order of a table among them, as on the command line', () => {
    const table = 'order_back_to_front\tfile\tname\tx\ty\n2\ta.png\thead\t170.0\t10\n1\tb.png\tbody\t40\t30\n';
    const files = [
      { name: 'layers.tsv', bytes: strToU8(table) as Uint8Array<ArrayBuffer> },
      { name: 'a.png', bytes: head },
      { name: 'b.png', bytes: body },
    ];
    const layers = mkdtempSync(join(folder, 'table-'));
    for (const { name, bytes } of files) writeFileSync(join(layers, name), bytes);
    const { parts } = JSON.parse(must(service.importLayers(files)).scene ?? '') as { parts: { id: string }[] };
    expect(parts.map((part) => part.id)).toEqual(['body', 'head']);
    expectSameModel(files, layers);
    const refused = [files.slice(0, 2), files.map((file) => (file.name === 'layers.tsv' ? { ...file, bytes: strToU8(table.replace('170.0', '0x10')) as Uint8Array<ArrayBuffer> } : file))];
    const wheres = refused.map((some) => service.importLayers(some)).map((answer) => (isFailure(answer) ? `${answer.error.code} ${answer.error.where}` : 'accepted'));
    expect(wheres).toEqual(['file b.png', 'bad_input layers.tsv: line 2']);
  });

  it('blend and clip as in the command line', () => {
    const blended = stack.replace('<layer ', '<layer composite-op="svg:multiply" ');
    const files = ora.map((file) => (file.name === 'stack.xml' ? { ...file, bytes: strToU8(blended) as Uint8Array<ArrayBuffer> } : file));
    const file = join(folder, 'blended.ora');
    writeFileSync(file, zipSync(Object.fromEntries(files.map(({ name, bytes }) => [name, bytes])), { level: 0 }));
    const { drawing } = must(service.importLayers(files));
    expect(Buffer.from(drawing).equals(Buffer.from(must(service.importLayers(ora)).drawing))).toBe(false);
    relievo('check', file, '-q', '-o', join(folder, 'blended.json'));
    expect(Buffer.from(drawing).equals(readFileSync(join(folder, 'blended.png')))).toBe(true);
  });

  it('that are damaged, missing or too large are refused by name', () => {
    const damaged = ora.map((file) => (file.name === 'data/1.png' ? { ...file, bytes: file.bytes.slice(0, 90) } : file));
    const refused = [damaged, ora.slice(0, 3), ora.map((file) => ({ ...file, bytes: file.name === 'stack.xml' ? strToU8(stack.replace('w="320"', 'w="32000"').replace('h="240"', 'h="32000"')) : file.bytes }))];
    const answers = refused.map((files) => service.importLayers(files));
    const wheres = answers.map((answer) => (isFailure(answer) ? `${answer.error.code} ${answer.error.where}` : 'accepted'));
    expect(wheres).toEqual(['bad_input data/1.png', 'bad_input stack.xml', 'limit stack.xml']);
  });
});
