import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import type { Change } from './change';
import type { Document } from './document';
import { type History, historyThrough, positionsOf, startHistory } from './history';
import { hashOfFields, hashOfPicture, packDocument, type Packed, type StoredFields, Unpacker } from './stored';

/** The summary of a saved state. */
export interface VersionNote {
  readonly number: number;
  /** ms since 1970. */
  readonly time: number;
  /** Name of the step that led to it. */
  readonly label: string;
}

/** A document on the shelf. */
export interface Entry {
  readonly id: string;
  readonly name: string;
  /** Time of the last change, ms since 1970. */
  readonly time: number;
  /** Oldest first. */
  readonly versions: readonly VersionNote[];
  /** Numbers of the states that undo goes back through, the current one last. */
  readonly done: readonly number[];
  /** Numbers of the states that redo goes forward through, the next one first. */
  readonly undone: readonly number[];
  /** A small PNG file. */
  readonly thumbnail?: Uint8Array;
  /** When it was thrown away, ms since 1970. */
  readonly removed?: number;
}

interface Version {
  readonly id: string;
  readonly number: number;
  readonly hash: string;
  readonly fields: StoredFields;
  /** Keys of its pictures. */
  readonly pictures: readonly string[];
}

interface Schema extends DBSchema {
  /** From early editors, which kept the last ten states of whatever was open. */
  generations: { key: number; value: { number: number; document: Document } };
  entries: { key: string; value: Entry };
  versions: { key: [string, number]; value: Version; indexes: { pictures: string } };
  pictures: { key: string; value: Uint8Array };
}

/** Number of steps that can be undone after a document is opened again. */
const keptSteps = 100;
/**
 * Beyond `mostVersions` every other version is deleted, except the newest `wholeVersions` and those that undo
 * needs.
 */
const mostVersions = 400;
const wholeVersions = 200;
/** Thrown away documents can be brought back for this time, ms. */
const removedFor = 7 * 24 * 3600 * 1000;

/** The numbers of the states of an open document that are saved already. */
interface Known {
  base: number | null;
  readonly after: WeakMap<Change, number>;
}

/** A state that is saved already, or one to save. */
type State = { readonly number: number } | { readonly label: string; readonly packed: Packed };

/** Stores all documents of this browser, with their versions and undo history, in IndexedDB. */
export class Shelf {
  private readonly known = new Map<string, Known>();

  private constructor(private readonly database: IDBPDatabase<Schema>) {}

  static async open(name = 'relievo'): Promise<Shelf> {
    const database = await openDB<Schema>(name, 2, {
      upgrade(fresh) {
        fresh.createObjectStore('entries', { keyPath: 'id' });
        fresh.createObjectStore('versions', { keyPath: ['id', 'number'] }).createIndex('pictures', 'pictures', { multiEntry: true });
        fresh.createObjectStore('pictures');
      },
    });
    const shelf = new Shelf(database);
    await shelf.takeGenerations();
    await shelf.forgetRemoved();
    return shelf;
  }

  /** Lists all documents, the last changed first. */
  async list(): Promise<Entry[]> {
    const entries = await this.database.getAll('entries');
    return entries.filter((entry) => entry.removed === undefined).sort((a, b) => b.time - a.time);
  }

  entry(id: string): Promise<Entry | undefined> {
    return this.database.get('entries', id);
  }

  /**
   * Saves every state of a history that is not saved yet. Resolves once the transaction is complete and
   * its result has been read back; rejects if nothing was written.
   */
  async save(id: string, history: History): Promise<void> {
    const known = this.known.get(id) ?? { base: null, after: new WeakMap<Change, number>() };
    const { positions, at } = positionsOf(history, keptSteps);
    const numberOf = (change: Change | null): number | null => (change ? (known.after.get(change) ?? null) : known.base);
    const states = await Promise.all(
      positions.map(async ({ document, change }): Promise<State> => {
        const number = numberOf(change);
        return number === null ? { label: change?.label ?? '', packed: await packDocument(document) } : { number };
      }),
    );
    const { numbers, written } = await this.write(id, history.document.name, states, at);
    for (const version of written) await this.checkWritten(version);
    positions.forEach(({ change }, i) => {
      if (change) known.after.set(change, numbers[i] as number);
      else known.base = numbers[i] as number;
    });
    this.known.set(id, known);
    await this.thin(id);
  }

  /**
   * Loads a document with its undo history. If its newest state is damaged, loads the newest intact one;
   * returns null if there is none.
   */
  async load(id: string): Promise<History | null> {
    const entry = await this.entry(id);
    if (!entry) return null;
    const unpacker = new Unpacker(await this.picturesOf(id));
    const read = (number: number): Promise<Document | null> => this.read(id, number, unpacker);
    const present = await read(entry.done.at(-1) ?? 0);
    if (!present) return this.newestWhole(entry, read);
    const past = await takeWhile([...entry.done].slice(0, -1).reverse(), read);
    const future = await takeWhile(entry.undone, read);
    const at = past.length;
    const states = [...past.reverse(), present, ...future];
    const numbers = [...entry.done.slice(entry.done.length - 1 - at), ...entry.undone.slice(0, future.length)];
    const labels = numbers.map((number) => entry.versions.find((version) => version.number === number)?.label ?? '');
    const history = historyThrough(states, labels, at);
    this.remember(id, history, numbers);
    return history;
  }

  /** Loads one state. Returns null if it is damaged. */
  async version(id: string, number: number): Promise<Document | null> {
    return this.read(id, number, new Unpacker(await this.picturesOf(id)));
  }

  async setThumbnail(id: string, thumbnail: Uint8Array): Promise<void> {
    await this.change(id, (entry) => ({ ...entry, thumbnail }));
  }

  /** Throws a document away. It can be brought back for a week. */
  async remove(id: string): Promise<void> {
    await this.change(id, (entry) => ({ ...entry, removed: Date.now() }));
  }

  async bringBack(id: string): Promise<void> {
    await this.change(id, ({ removed: _removed, ...entry }) => entry);
  }

  /** Writes states and the entry in one transaction: all of them or none. */
  private async write(id: string, name: string, states: readonly State[], at: number): Promise<{ numbers: number[]; written: Version[] }> {
    const transaction = this.database.transaction(['entries', 'versions', 'pictures'], 'readwrite', { durability: 'strict' });
    const work = async (): Promise<{ numbers: number[]; written: Version[] }> => {
      const [entries, pictures] = [transaction.objectStore('entries'), transaction.objectStore('pictures')];
      const { removed: _removed, ...former } = (await entries.get(id)) ?? { versions: [], time: 0 };
      const written: Version[] = [];
      const notes: VersionNote[] = [];
      let newest = former.versions.at(-1)?.number ?? 0;
      const numbers: number[] = [];
      for (const state of states) {
        if ('packed' in state) {
          const { fields, hash, pictures: shown } = state.packed;
          const version = { id, number: ++newest, hash, fields, pictures: [...shown.keys()].map((key) => `${id}/${key}`) };
          written.push(version);
          notes.push({ number: newest, time: Date.now(), label: state.label });
          await transaction.objectStore('versions').put(version);
          for (const [key, bytes] of shown)
            if ((await pictures.getKey(`${id}/${key}`)) === undefined) await pictures.put(bytes, `${id}/${key}`);
        }
        numbers.push('packed' in state ? newest : state.number);
      }
      const time = written.length > 0 ? Date.now() : former.time;
      const versions = [...former.versions, ...notes];
      await entries.put({ ...former, id, name, time, versions, done: numbers.slice(0, at + 1), undone: numbers.slice(at + 1) });
      return { numbers, written };
    };
    // If writing fails, the transaction fails too and gives the reason.
    const [result] = await Promise.all([work(), transaction.done]);
    return result;
  }

  private async change(id: string, how: (entry: Entry) => Entry): Promise<void> {
    const transaction = this.database.transaction('entries', 'readwrite');
    const entry = await transaction.store.get(id);
    if (entry) await transaction.store.put(how(entry));
    await transaction.done;
  }

  private async newestWhole(entry: Entry, read: (number: number) => Promise<Document | null>): Promise<History | null> {
    for (const { number } of [...entry.versions].reverse()) {
      const document = await read(number);
      if (!document) continue;
      this.known.set(entry.id, { base: number, after: new WeakMap() });
      return startHistory(document);
    }
    return null;
  }

  /** Remembers the numbers of the states of a history that was loaded. */
  private remember(id: string, history: History, numbers: readonly number[]): void {
    const { positions } = positionsOf(history, keptSteps);
    const after = new WeakMap<Change, number>();
    // Equal states have no change between them, so numbers and changes would not match.
    if (positions.length !== numbers.length) return;
    positions.forEach(({ change }, i) => change && after.set(change, numbers[i] as number));
    this.known.set(id, { base: numbers[0] ?? null, after });
  }

  private async read(id: string, number: number, unpacker: Unpacker): Promise<Document | null> {
    const version = await this.database.get('versions', [id, number]);
    if (!version || (await hashOfFields(version.fields)) !== version.hash) return null;
    try {
      return unpacker.unpack(version.fields);
    } catch {
      return null;
    }
  }

  /** Returns the pictures of a document by the hash of their content. */
  private async picturesOf(id: string): Promise<Map<string, Uint8Array>> {
    const range = IDBKeyRange.bound(`${id}/`, `${id}/\uffff`);
    const all = await this.database.getAll('pictures', range);
    const pairs = await Promise.all(all.map(async (bytes) => [await hashOfPicture(bytes), bytes] as const));
    return new Map(pairs);
  }

  private async checkWritten(version: Version): Promise<void> {
    const back = await this.database.get('versions', [version.id, version.number]);
    const whole = back !== undefined && (await hashOfFields(back.fields)) === version.hash;
    const keys = await Promise.all(version.pictures.map((key) => this.database.getKey('pictures', key)));
    if (!whole || keys.includes(undefined)) throw new Error('what was saved reads back differently');
  }

  private async thin(id: string): Promise<void> {
    const entry = await this.entry(id);
    if (!entry || entry.versions.length <= mostVersions) return;
    const needed = new Set([...entry.done, ...entry.undone]);
    const older = entry.versions.slice(0, -wholeVersions).filter(({ number }) => !needed.has(number));
    await this.forget(id, older.filter((_, i) => i % 2 === 1).map(({ number }) => number));
  }

  /** Deletes states, and pictures that no other state uses. */
  private async forget(id: string, numbers: readonly number[]): Promise<void> {
    const gone = new Set(numbers);
    const transaction = this.database.transaction(['entries', 'versions', 'pictures'], 'readwrite');
    const [entries, versions] = [transaction.objectStore('entries'), transaction.objectStore('versions')];
    const entry = await entries.get(id);
    if (entry) await entries.put({ ...entry, versions: entry.versions.filter(({ number }) => !gone.has(number)) });
    for (const number of numbers) {
      const pictures = (await versions.get([id, number]))?.pictures ?? [];
      await versions.delete([id, number]);
      for (const key of pictures)
        if ((await versions.index('pictures').count(key)) === 0) await transaction.objectStore('pictures').delete(key);
    }
    await transaction.done;
  }

  private async forgetRemoved(): Promise<void> {
    for (const { id, removed, versions } of await this.database.getAll('entries')) {
      if (removed === undefined || Date.now() - removed < removedFor) continue;
      await this.forget(id, versions.map(({ number }) => number));
      await this.database.delete('entries', id);
    }
  }

  /** Moves the documents of an early editor to the shelf, with the newest state of each name. */
  private async takeGenerations(): Promise<void> {
    if (!this.database.objectStoreNames.contains('generations')) return;
    const newest = new Map((await this.database.getAll('generations')).map(({ document }) => [document.name, document]));
    for (const document of newest.values()) await this.save(crypto.randomUUID(), startHistory(document));
    await this.database.clear('generations');
  }
}

/** Reads numbers in turn and returns the results up to the first null. */
async function takeWhile<T>(numbers: readonly number[], read: (number: number) => Promise<T | null>): Promise<T[]> {
  const taken: T[] = [];
  for (const number of numbers) {
    const value = await read(number);
    if (value === null) break;
    taken.push(value);
  }
  return taken;
}
