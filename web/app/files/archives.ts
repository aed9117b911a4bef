import * as Comlink from 'comlink';
import type { Document } from '../../document/document';
import type { OutputFile } from '../../engine/messages';
import type { ArchiveEndpoint } from './archive_worker';
import { t } from '../../words/catalogue';

let started: Comlink.Remote<ArchiveEndpoint> | undefined;

/** The worker that packs and unpacks, started when it is needed first. */
function worker(): Comlink.Remote<ArchiveEndpoint> {
  started ??= Comlink.wrap<ArchiveEndpoint>(new Worker(new URL('./archive_worker.ts', import.meta.url), { type: 'module' }));
  return started;
}

/** A project file; see writeProject. */
export function packProject(document: Document, picture: Uint8Array | null): Promise<Uint8Array<ArrayBuffer>> {
  return worker().writeProject(document, picture) as Promise<Uint8Array<ArrayBuffer>>;
}

/** Throws, in words, where it is none that can be read. */
export async function unpackProject(bytes: Uint8Array): Promise<Document> {
  const read = await worker().readProject(bytes);
  if (typeof read === 'string') throw new Error(read);
  return read;
}

/** The entries of an OpenRaster file. Throws, in words. */
export async function unpackOra(bytes: Uint8Array): Promise<OutputFile[]> {
  const entries = await worker().unpackOra(bytes);
  if (typeof entries === 'string') throw new Error(t(entries));
  return entries;
}

/** Several files as one. */
export function zipped(files: readonly OutputFile[]): Promise<Uint8Array<ArrayBuffer>> {
  return worker().zip(files) as Promise<Uint8Array<ArrayBuffer>>;
}

/** A picture as a PNG file. The page's own thread would wait for an idle moment, for seconds where there is none. */
export function pngFile(picture: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
  return worker().png(picture) as Promise<Uint8Array<ArrayBuffer>>;
}
