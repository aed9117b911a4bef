import { unzipSync } from 'fflate';

/** Most bytes of the entries of an archive together, unpacked. */
export const maxArchiveBytes = 256 * 1024 * 1024;

/** An archive that asks for more than a page can bear. */
export class ArchiveTooLarge extends Error {}

/** Unpacks the entries that are wanted and nothing else; sizes are checked before memory is spent. */
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
