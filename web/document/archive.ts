import { unzipSync } from 'fflate';

/** An archive that asks for more than a page can bear. */
export class ArchiveTooLarge extends Error {}

/** Unpacks the entries that are wanted and nothing else; sizes are checked before memory is spent. */
export function unpackArchive(bytes: Uint8Array, wanted: (name: string) => boolean, maxBytes: number): Record<string, Uint8Array> {
  let total = 0;
  return unzipSync(bytes, {
    filter(file) {
      if (!wanted(file.name)) return false;
      total += file.originalSize;
      if (total > maxBytes) throw new ArchiveTooLarge();
      return true;
    },
  });
}
