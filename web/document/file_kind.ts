/** The kind of a file, found from its first bytes, not from its name. */
type FileKind = 'picture' | 'svg' | 'scene' | 'project' | 'openraster' | 'photoshop' | 'unknown';

const pictures: readonly [string, string][] = [
  ['\x89PNG', 'image/png'], ['\xff\xd8\xff', 'image/jpeg'], ['GIF8', 'image/gif'], ['BM', 'image/bmp'],
];

/** Returns the MIME type of a picture, or null for other files. */
export function pictureType(bytes: Uint8Array): string | null {
  const text = headOf(bytes);
  if (text.startsWith('RIFF') && text.slice(8, 12) === 'WEBP') return 'image/webp';
  // Some browsers read HEIC.
  if (text.startsWith('ftypavi', 4)) return 'image/avif';
  if (['ftyphe', 'ftypmif1', 'ftypmsf1'].some((brand) => text.startsWith(brand, 4))) return 'image/heic';
  return pictures.find(([head]) => text.startsWith(head))?.[1] ?? null;
}

/** Returns the name of a file without its extension. */
export function baseName(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'untitled';
}

function headOf(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes.subarray(0, 120));
}

/** Returns the kind of a file. */
export function fileKind(bytes: Uint8Array): FileKind {
  const text = headOf(bytes);
  if (pictureType(bytes)) return 'picture';
  if (text.startsWith('PK')) return text.includes('image/openraster') ? 'openraster' : 'project';
  if (text.startsWith('8BPS')) return 'photoshop';
  const [first] = text.replace(/^\xef\xbb\xbf/, '').trimStart();
  if (first === '<') return 'svg';
  return first === '{' ? 'scene' : 'unknown';
}
