import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** Scripts and data from this folder only; the core needs leave to compile WebAssembly. */
export const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob: data:",
  "connect-src 'self' blob:",
  "worker-src 'self'",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

export function contentPolicy(): Plugin {
  return {
    name: 'content-policy',
    apply: 'build',
    transformIndexHtml: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: policy },
        injectTo: 'head-prepend',
      },
    ],
  };
}

const worker = (version: string, files: string[]): string => `
const cacheName = 'relievo-${version}';
const files = ${JSON.stringify(files)};
self.addEventListener('install', (event) => {
  // What has its content in its name was loaded a moment ago, and is not loaded again.
  const request = (file) => new Request(file, { cache: file.startsWith('./assets/') ? 'force-cache' : 'no-cache' });
  event.waitUntil(caches.open(cacheName).then((cache) => cache.addAll(files.map(request))));
});
self.addEventListener('activate', (event) => {
  const old = (name) => name.startsWith('relievo-') && name !== cacheName;
  event.waitUntil(
    caches.keys().then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name)))),
  );
});
self.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  event.respondWith(
    caches.open(cacheName)
      .then((cache) => cache.match(event.request, { ignoreSearch: true, ignoreVary: true }))
      .then((found) => found ?? fetch(event.request)),
  );
});
`;

/**
 * A service worker that keeps one whole version of the page for use without a network. A new
 * version waits until every tab of the old one is closed: files of two are never mixed.
 */
export function offlineCopy(): Plugin {
  return {
    name: 'offline-copy',
    apply: 'build',
    generateBundle: {
      order: 'post',
      handler(_options, bundle) {
        const files = Object.keys(bundle).filter((name) => !name.endsWith('.map')).sort();
        const hash = createHash('sha256');
        for (const name of files) {
          const file = bundle[name];
          hash.update(name).update(file?.type === 'chunk' ? file.code : (file?.source ?? ''));
        }
        const all = ['./', ...files.map((name) => `./${name}`), './icon.svg', './icon-180.png', './icon-512.png', './manifest.webmanifest'];
        const source = worker(hash.digest('hex').slice(0, 16), all);
        this.emitFile({ type: 'asset', fileName: 'service_worker.js', source });
      },
    },
  };
}
