import * as Comlink from 'comlink';
import type { Document } from '../../document/document';
import type { OutputFile } from '../../engine/messages';
import type { ArchiveEndpoint } from './archive_worker';
import { t } from '../../words/catalogue';

let started: Comlink.Remote<ArchiveEndpoint> | undefined;

/** Returns the worker that packs and unpacks. It starts on first use. */
function worker(): Comlink.Remote<ArchiveEndpoint> {
  started ??= Comlink.wrap<ArchiveEndpoint>(new Worker(new URL('./archive_worker.ts', import.meta.url), { type: 'module' }));
  return started;
}

/** Returns a project file; see writeProject. */
export function packProject(document: Document, picture: Uint8Array | null): Promise<Uint8Array<ArrayBuffer>> {
  return worker().writeProject(document, picture) as Promise<Uint8Array<ArrayBuffer>>;
}

/** Reads a project file. Throws an error with a message for the user if it cannot be read. */
export async function unpackProject(bytes: Uint8Array): Promise<Document> {
  const read = await worker().readProject(bytes);
  if (typeof read === 'string') throw new Error(t(read));
  return read;
}

/** Returns the entries of an OpenRaster file. Throws an error with a message for the user. */
export async function unpackOra(bytes: Uint8Array): Promise<OutputFile[]> {
  const entries = await worker().unpackOra(bytes);
  if (typeof entries === 'string') throw new Error(t(entries));
  return entries;
}

/** Packs several files into one zip archive. */
export function zipped(files: readonly OutputFile[]): Promise<Uint8Array<ArrayBuffer>> {
  return worker().zip(files) as Promise<Uint8Array<ArrayBuffer>>;
}

/** Encodes a picture as a PNG file. On the page's own thread this could wait seconds for an idle moment. */
export function pngFile(picture: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
  return worker().png(picture) as Promise<Uint8Array<ArrayBuffer>>;
}
