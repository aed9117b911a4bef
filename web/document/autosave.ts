import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import { type Document, emptyDocument } from './document';

interface Generation {
  number: number;
  time: number;
  hash: string;
  document: Document;
}

interface Schema extends DBSchema {
  generations: { key: number; value: Generation };
}

const kept = 10;

/** Identifies the content of a document; pictures count by their length. */
export async function hashOf(document: Document): Promise<string> {
  const short = (_key: string, value: unknown): unknown => (value instanceof Uint8Array ? value.length : value);
  const text = new TextEncoder().encode(JSON.stringify(document, short));
  const digest = await crypto.subtle.digest('SHA-256', text);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/**
 * Keeps the last ten states of the document in the browser. A state counts as saved only when its
 * transaction is complete and it has been read back; nothing is deleted before that.
 */
export class Autosave {
  private constructor(private readonly database: IDBPDatabase<Schema>) {}

  static async open(name = 'relievo'): Promise<Autosave> {
    const database = await openDB<Schema>(name, 1, {
      upgrade(fresh) {
        fresh.createObjectStore('generations', { keyPath: 'number' });
      },
    });
    return new Autosave(database);
  }

  async save(document: Document): Promise<void> {
    const hash = await hashOf(document);
    const newest = (await this.numbers()).at(-1) ?? 0;
    const number = newest + 1;
    const transaction = this.database.transaction('generations', 'readwrite', { durability: 'strict' });
    await transaction.store.put({ number, time: Date.now(), hash, document });
    await transaction.done;
    const back = await this.database.get('generations', number);
    if (!back || (await hashOf(back.document)) !== hash) throw new Error('what was saved reads back differently');
    await this.forget((await this.numbers()).slice(0, -kept));
  }

  /** The newest state that is whole, or null. */
  async restore(): Promise<Document | null> {
    for (const number of (await this.numbers()).reverse()) {
      const generation = await this.database.get('generations', number);
      if (generation && (await hashOf(generation.document)) === generation.hash)
        // An older editor may have saved less.
        return { ...emptyDocument(), ...generation.document };
    }
    return null;
  }

  private numbers(): Promise<number[]> {
    return this.database.getAllKeys('generations');
  }

  private async forget(numbers: number[]): Promise<void> {
    const transaction = this.database.transaction('generations', 'readwrite');
    for (const number of numbers) await transaction.store.delete(number);
    await transaction.done;
  }
}
