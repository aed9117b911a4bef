/** A file and where it lies below what was dropped or chosen. */
export interface PlacedFile {
  /** With slashes; of a folder's content without the folder. */
  readonly path: string;
  readonly file: File;
}

/** What a person gave at once. `name`: of the folder, or of the first file. */
export interface GivenFiles {
  readonly name: string;
  readonly files: readonly PlacedFile[];
}

const mostFiles = 2000;

function childrenOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  return new Promise((resolve, reject) => {
    // A reader hands out its entries in portions, an empty one at the end.
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

export function givenFiles(files: readonly File[]): GivenFiles {
  return { name: files[0]?.name ?? '', files: files.map((file) => ({ path: file.name, file })) };
}

/** The files of a drop or a paste; of a folder all that lie in it. The event must not be over yet. */
export async function filesOf(data: DataTransfer): Promise<GivenFiles> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = givenFiles([...data.files]);
  const folder = entries.find((entry) => entry?.isDirectory);
  return folder ? { name: folder.name, files: await filesBelow(folder, '') } : plain;
}
