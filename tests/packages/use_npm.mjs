// Builds a drawing by the package: use_npm.mjs DRAWING; writes what the program is compared with.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { RelievoError, load } from 'relievo';

const relievo = await load();
const { scene, proposed } = relievo.readSvg(await readFile(process.argv[2]));
assert.equal(proposed, false);
const relief = relievo.build(scene, { vertices: 1000 });
const few = relief.report.nodes;
assert.ok(relief.rebuild(scene, { vertices: 4000 }).nodes > 2 * few);
relief.free();

const fresh = relievo.build(scene, { vertices: 4000 });
await writeFile('scene.json', scene);
for (const format of ['glb', 'stl'])
  for (const { name, bytes } of fresh.encode(format, 'wolf')) await writeFile(name, bytes);
await writeFile('normal.png', fresh.map('normal'));
assert.equal(fresh.solid({ base: 'plate' }).pieces, 1);
const refused = (work, code, where) =>
  assert.throws(work, (error) => error instanceof RelievoError && error.code === code && error.where === where);
refused(() => fresh.rebuild(scene, { rho: -1 }), 'usage', 'rho');
refused(() => relievo.build(scene, { vertexes: 5 }), 'usage', 'vertexes');
refused(() => relievo.build('{}'), 'bad_input', 'format');
fresh.free();
