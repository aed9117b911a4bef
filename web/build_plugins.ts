import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** Allows scripts and data from the page's own folder only, and compiling WebAssembly for the core. */
const policy = [
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

/** Adds the content security policy to the page. */
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

/** Modules with the words of a language. A visit needs at most one of them. */
const languages: Readonly<Record<string, string>> = { de: 'german', fr: 'french', es: 'spanish', ja: 'japanese' };

const worker = (version: string, files: string[], words: Record<string, string>): string => `
const cacheName = 'relievo-${version}';
const words = ${JSON.stringify(words)};
const spoken = navigator.languages.map((tag) => tag.slice(0, 2).toLowerCase()).find((tag) => tag === 'en' || tag in words);
const files = ${JSON.stringify(files)}.concat(words[spoken] ?? []);
self.addEventListener('install', (event) => {
  // Assets have a hash of their content in their names, so a cached copy is always current.
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
  // A newly chosen language is kept for use without a network too.
  const file = Object.values(words).find((name) => event.request.url.endsWith(name.slice(1)));
  if (file) event.waitUntil(caches.open(cacheName).then((cache) => cache.add(file)));
});
`;

/**
 * Adds a service worker that keeps one complete version of the page for use without a network. A new
 * version waits until all tabs with the old one are closed, so files of two versions never mix.
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
        const words = Object.fromEntries(
          Object.entries(languages).flatMap(([tag, name]) => {
            const file = files.find((path) => path.startsWith(`assets/${name}-`));
            return file ? [[tag, `./${file}`]] : [];
          }),
        );
        const rest = files.filter((name) => !Object.values(words).includes(`./${name}`));
        const all = ['./', ...rest.map((name) => `./${name}`), './icon.svg', './icon-180.png', './icon-512.png', './manifest.webmanifest'];
        const source = worker(hash.digest('hex').slice(0, 16), all, words);
        this.emitFile({ type: 'asset', fileName: 'service_worker.js', source });
      },
    },
  };
}
