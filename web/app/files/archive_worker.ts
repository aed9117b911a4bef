import * as Comlink from 'comlink';
import { zipSync } from 'fflate';
import { ArchiveTooLarge, unpackArchive } from '../../document/archive';
import type { Document } from '../../document/document';
import { ProjectError, type ProjectTrouble, readProject, writeProject } from '../../document/project_file';
import type { OutputFile } from '../../engine/messages';

/** Returns the entries of an OpenRaster archive, without its previews. */
function entriesOfOra(bytes: Uint8Array): OutputFile[] {
  const wanted = (name: string): boolean => name === 'mimetype' || name === 'stack.xml' || /^data\/.*\.png$/i.test(name);
  const entries = unpackArchive(bytes, wanted) as Record<string, Uint8Array<ArrayBuffer>>;
  return Object.entries(entries).map(([name, content]) => ({ name, bytes: content }));
}

/** Packs and unpacks files off the page's own thread, since that can take longer than a user waits. */
const endpoint = {
  writeProject(document: Document, picture: Uint8Array | null): Uint8Array<ArrayBuffer> {
    const bytes = writeProject(document, picture);
    return Comlink.transfer(bytes, [bytes.buffer]);
  },
/** Returns the document or, if the file cannot be read, the reason. */
  readProject(bytes: Uint8Array): Document | ProjectTrouble {
    try {
      return readProject(bytes);
    } catch (error) {
      if (error instanceof ProjectError) return error.trouble;
      throw error;
    }
  },
  unpackOra(bytes: Uint8Array): OutputFile[] | 'tooLarge' | 'damagedFile' {
    try {
      const entries = entriesOfOra(bytes);
      return Comlink.transfer(entries, entries.map((entry) => entry.bytes.buffer));
    } catch (error) {
      return error instanceof ArchiveTooLarge ? 'tooLarge' : 'damagedFile';
    }
  },
  async png(picture: ImageBitmap): Promise<Uint8Array<ArrayBuffer>> {
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    canvas.getContext('2d', { willReadFrequently: true })?.drawImage(picture, 0, 0);
    picture.close();
    const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer());
    return Comlink.transfer(bytes, [bytes.buffer]);
  },
  zip(files: readonly OutputFile[]): Uint8Array<ArrayBuffer> {
    const bytes = zipSync(Object.fromEntries(files.map((file) => [file.name, file.bytes])));
    return Comlink.transfer(bytes, [bytes.buffer]);
  },
};

export type ArchiveEndpoint = typeof endpoint;

Comlink.expose(endpoint);
