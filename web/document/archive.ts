import { unzipSync } from 'fflate';

/** Largest total size of unpacked entries, bytes. */
export const maxArchiveBytes = 256 * 1024 * 1024;

/** An archive whose entries are larger than `maxArchiveBytes`. */
export class ArchiveTooLarge extends Error {}

/** Unpacks only the wanted entries. Checks their sizes before allocating memory; throws ArchiveTooLarge. */
export function unpackArchive(bytes: Uint8Array, wanted: (name: string) => boolean): Record<string, Uint8Array> {
  let total = 0;
  return unzipSync(bytes, {
    filter(file) {
      if (!wanted(file.name)) return false;
      total += file.originalSize;
      if (total > maxArchiveBytes) throw new ArchiveTooLarge();
      return true;
    },
  });
}
