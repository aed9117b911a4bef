import type { History } from '../../document/history';
import type { Entry, Shelf } from '../../document/shelf';
import { pngFile } from '../files/archives';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { smallPicture } from '../files/pictures';
import { TabLock } from './tab_lock';

/** Steps within this time are saved together, ms. */
const gathering = 60;
/** A failed save is tried again after this time, ms. */
const retry = 3000;
/** A thumbnail is made once nothing was saved for this long, ms. */
const thumbnailRest = 600;
/** px */
const thumbnailSide = 240;

/** Saves every step of every document to the shelf. */
export class Keeper {
  private readonly lock = new TabLock((id) => this.lose(id));
  private readonly waiting = new Map<string, History>();
  private seen: History | null = null;
  private id: string | null = null;
  private running: Promise<void> = Promise.resolve();
  private isRunning = false;
  private lost: string | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private thumbnailTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly editor: Editor, private readonly shelf: Shelf | null) {
    editor.subscribe(() => this.follow());
    window.addEventListener('pagehide', () => void this.flush());
    document.addEventListener('visibilitychange', () => document.hidden && void this.flush());
    window.addEventListener('beforeunload', (event) => this.waiting.size > 0 && event.preventDefault());
  }

  /** Lists all documents on the shelf after saving the current one. */
  async list(): Promise<Entry[]> {
    await this.flush();
    return (await this.shelf?.list()) ?? [];
  }

  /**
   * Opens a document with its undo history. Returns 'elsewhere' if another tab has it open, unless `over`
   * takes it over.
   */
  async open(id: string, over: boolean): Promise<History | 'elsewhere'> {
    await this.flush();
    if (!(await this.lock.take(id, over))) return 'elsewhere';
    return this.read(id);
  }

  /** Reads the last saved history of a document, even if another tab has it open. */
  async read(id: string): Promise<History> {
    const history = await this.shelf?.load(id);
    if (!history) throw new Error(t('damagedFile'));
    return history;
  }

  entry(id: string): Promise<Entry | undefined> {
    return this.shelf?.entry(id) ?? Promise.resolve(undefined);
  }

  async version(id: string, number: number): Promise<History['document'] | null> {
    return (await this.shelf?.version(id, number)) ?? null;
  }

  async remove(id: string): Promise<void> {
    await this.shelf?.remove(id);
  }

  async bringBack(id: string): Promise<void> {
    await this.shelf?.bringBack(id);
  }

  /** Resolves when all waiting steps are saved or have failed. */
  async flush(): Promise<void> {
    clearTimeout(this.timer);
    if (!this.isRunning) this.running = this.run();
    await this.running;
  }

  /** The id of the document that another tab has taken over, or null. */
  get takenOver(): string | null {
    return this.lost;
  }

  private follow(): void {
    const { history, shelf, open } = this.editor.state;
    if (!open || !shelf || history === this.seen) return;
    const isNew = shelf.id !== this.id;
    this.seen = history;
    if (isNew) this.begin(shelf.id);
    if (isNew && shelf.keep === 'changes') return;
    if (this.lost === shelf.id) {
      this.goOnAsCopy();
      return;
    }
    this.waiting.set(shelf.id, history);
    this.editor.set({ saved: 'no' });
    this.keepSoon(gathering);
  }

  private begin(id: string): void {
    this.id = id;
    this.lost = null;
    this.editor.set({ saved: 'yes', alert: this.editor.state.alert === 'takenOver' ? 'none' : this.editor.state.alert });
    void this.lock.take(id, false);
  }

  private lose(id: string): void {
    if (id !== this.id) return;
    this.lost = id;
    this.editor.set({ alert: 'takenOver' });
    if (this.waiting.has(id)) this.goOnAsCopy();
  }

  /** Continues as a new document after another tab took over the old one. */
  private goOnAsCopy(): void {
    const { document } = this.editor;
    if (this.lost) this.waiting.delete(this.lost);
    this.lost = null;
    this.id = crypto.randomUUID();
    void this.lock.take(this.id, false);
    this.editor.set({ shelf: { id: this.id, keep: 'all' }, alert: 'none', notice: t('wentOnAsCopy') });
    this.editor.complete({ ...document, name: t('copyOf', { name: document.name }) });
    // Saves the copy even if there was no step to complete.
    this.seen = null;
    this.follow();
  }

  private keepSoon(after: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.flush(), after);
  }

  private async run(): Promise<void> {
    this.isRunning = true;
    for (let next = this.next(); next; next = this.next()) {
      const [id, history] = next;
      try {
        if (!this.shelf) throw new Error('no storage');
        await this.shelf.save(id, history);
        if (this.waiting.get(id) === history) this.waiting.delete(id);
        this.report(true);
      } catch {
        this.report(false);
        this.keepSoon(retry);
        break;
      }
    }
    this.isRunning = false;
  }

  private next(): [string, History] | undefined {
    return this.waiting.entries().next().value;
  }

  private report(kept: boolean): void {
    const { alert } = this.editor.state;
    if (!kept) this.editor.set({ saved: 'failed', alert: 'unsaved' });
    else if (this.waiting.size === 0) {
      this.editor.set({ saved: 'yes', alert: alert === 'unsaved' ? 'none' : alert });
      clearTimeout(this.thumbnailTimer);
      this.thumbnailTimer = setTimeout(() => void this.keepThumbnail(), thumbnailRest);
    }
  }

  private async keepThumbnail(): Promise<void> {
    const { id } = this;
    const { document, state } = this.editor;
    if (!id || !this.shelf || !state.open) return;
    const bytes = await thumbnailOf(document, state.picture);
    // The document is saved even if its thumbnail is not.
    await this.shelf.setThumbnail(id, bytes).catch(() => undefined);
  }
}

/** Returns a small picture of a document as a PNG file. */
async function thumbnailOf(document: History['document'], picture: ImageBitmap | null): Promise<Uint8Array> {
  const small = await smallPicture(document, picture, thumbnailSide);
  const bytes = await pngFile(small);
  small.close();
  return bytes;
}
