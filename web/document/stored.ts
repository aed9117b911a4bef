import { type Document, emptyDocument } from './document';

/** A document as text, field by field, so that states that share a field still share it when they are read back. */
export type StoredFields = Readonly<Record<string, string>>;

export interface Packed {
  readonly fields: StoredFields;
  /** Hash of the fields, which contain the hashes of the pictures. */
  readonly hash: string;
  /** The pictures that the fields refer to, by hash. */
  readonly pictures: ReadonlyMap<string, Uint8Array>;
}

/** The key that stands for bytes in the text of a field. */
const reference = '$bytes';

async function hashOfBytes(bytes: Uint8Array): Promise<string> {
  const digest = await crypto.subtle.digest('SHA-256', bytes as Uint8Array<ArrayBuffer>);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Hashes computed so far; the bytes of documents never change. */
const hashes = new WeakMap<Uint8Array, string>();

export async function hashOfPicture(bytes: Uint8Array): Promise<string> {
  const hash = hashes.get(bytes) ?? (await hashOfBytes(bytes));
  hashes.set(bytes, hash);
  return hash;
}

export function hashOfFields(fields: StoredFields): Promise<string> {
  return hashOfBytes(new TextEncoder().encode(JSON.stringify(fields)));
}

/** Packs a document as text. The paintable version of an SVG is left out, since it is derived again on opening. */
export async function packDocument(document: Document): Promise<Packed> {
  const pictures = new Map<string, Uint8Array>();
  for (const bytes of [document.drawing?.bytes, document.segmentation?.labels])
    if (bytes) pictures.set(await hashOfPicture(bytes), bytes);
  const short = (key: string, value: unknown): unknown => {
    if (value instanceof Uint8Array) return { [reference]: hashes.get(value) };
    return key === 'paintable' ? undefined : value;
  };
  const fields = Object.fromEntries(Object.entries(document).map(([key, value]) => [key, JSON.stringify(value, short)]));
  return { fields, hash: await hashOfFields(fields), pictures };
}

function isReference(value: unknown): value is Record<typeof reference, string> {
  return typeof value === 'object' && value !== null && reference in value;
}

/** Reads states of one document, one after the other. */
export class Unpacker {
  private before: { fields: StoredFields; document: Document } | null = null;

  constructor(private readonly pictures: ReadonlyMap<string, Uint8Array>) {}

  /**
   * Reads a state. Fields that an older editor did not know get the values of an empty document. Throws if a
   * picture is missing.
   */
  unpack(fields: StoredFields): Document {
    const { before } = this;
    const long = (_key: string, value: unknown): unknown => {
      if (!isReference(value)) return value;
      const bytes = this.pictures.get(value[reference]);
      if (!bytes) throw new Error('a picture is missing');
      return bytes;
    };
    const read = ([key, text]: [string, string]): [string, unknown] =>
      before?.fields[key] === text ? [key, before.document[key as keyof Document]] : [key, JSON.parse(text, long)];
    const document: Document = { ...emptyDocument(), ...Object.fromEntries(Object.entries(fields).map(read)) };
    this.before = { fields, document };
    return document;
  }
}
