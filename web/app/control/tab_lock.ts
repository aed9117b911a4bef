/** Ensures that only one tab edits a document. */
export class TabLock {
  private held: { id: string; release(): void } | null = null;

  /** `lost` is called when another tab takes the document over. */
  constructor(private readonly lost: (id: string) => void) {}

  /** Locks a document and releases the one before. Returns false if another tab has it, unless `over` takes it over. */
  take(id: string, over: boolean): Promise<boolean> {
    if (this.held?.id === id) return Promise.resolve(true);
    this.letGo();
    if (!('locks' in navigator)) return Promise.resolve(true);
    return new Promise((resolve) => {
      const own = { id, release: (): void => undefined };
      const whileHeld = (lock: Lock | null): Promise<void> | undefined => {
        resolve(lock !== null);
        if (!lock) return undefined;
        this.held = own;
        return new Promise((release) => {
          own.release = release;
        });
      };
      const options = over ? { steal: true } : { ifAvailable: true };
      navigator.locks.request(`relievo ${id}`, options, whileHeld).catch(() => {
        if (this.held !== own) return;
        this.held = null;
        this.lost(id);
      });
    });
  }

  private letGo(): void {
    const { held } = this;
    this.held = null;
    held?.release();
  }
}
