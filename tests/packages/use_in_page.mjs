// Builds a drawing by the package in a page: use_in_page.mjs DRAWING; prints the sum of the .stl.
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { chromium } from './tools/playwright-core/index.mjs';

const types = { js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };
const server = createServer((request, response) => {
  if (request.url === '/') return void response.setHeader('Content-Type', types.html).end('<title>x</title>');
  readFile(`.${request.url}`).then(
    (bytes) => response.setHeader('Content-Type', types[request.url.split('.').pop()] ?? 'text/plain').end(bytes),
    () => response.writeHead(404).end(),
  );
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const stl = await page.evaluate(async (drawing) => {
    const { load } = await import('/node_modules/relievo/index.js');
    const relievo = await load();
    const svg = new Uint8Array(await (await fetch(drawing)).arrayBuffer());
    const relief = relievo.build(relievo.readSvg(svg).scene, { vertices: 4000 });
    return Array.from(relief.encode('stl', 'wolf')[0].bytes);
  }, `/${process.argv[2]}`);
  console.log(`${createHash('sha256').update(Uint8Array.from(stl)).digest('hex')}  -`);
} finally {
  await browser.close();
  server.close();
}
