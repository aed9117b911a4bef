/** A file with its path relative to the dropped or chosen folder. */
export interface PlacedFile {
  /** Separated by slashes, without the name of the dropped folder itself. */
  readonly path: string;
  readonly file: File;
}

/** Files that were dropped, pasted or chosen together. `name` is that of the folder or of the first file. */
export interface GivenFiles {
  readonly name: string;
  readonly files: readonly PlacedFile[];
}

const mostFiles = 2000;

function childrenOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  return new Promise((resolve, reject) => {
    // A reader returns its entries in portions and ends with an empty one.
    const next = (): void =>
      reader.readEntries((portion) => {
        all.push(...portion);
        if (portion.length === 0 || all.length > mostFiles) resolve(all);
        else next();
      }, reject);
    next();
  });
}

async function filesBelow(entry: FileSystemEntry, path: string): Promise<PlacedFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ path, file }];
  }
  const children = await childrenOf(entry as FileSystemDirectoryEntry);
  const below = await Promise.all(children.map((child) => filesBelow(child, path ? `${path}/${child.name}` : child.name)));
  return below.flat();
}

/** Returns files as one gift, each with its name as its path. */
export function givenFiles(files: readonly File[]): GivenFiles {
  return { name: files[0]?.name ?? '', files: files.map((file) => ({ path: file.name, file })) };
}

/**
 * Returns the files of a drop or a paste. If it holds a folder, these are all files below it. Call it
 * while the event is being handled: the browser empties `data` afterwards.
 */
export async function filesOf(data: DataTransfer): Promise<GivenFiles> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = givenFiles([...data.files]);
  const folder = entries.find((entry) => entry?.isDirectory);
  return folder ? { name: folder.name, files: await filesBelow(folder, '') } : plain;
}
