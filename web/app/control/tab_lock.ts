/** Sees to it that one tab alone changes a document. */
export class TabLock {
  private held: { id: string; release(): void } | null = null;

  /** `lost`: another tab has taken the document over. */
  constructor(private readonly lost: (id: string) => void) {}

  /** Takes a document; false where another tab has it, unless it is to be taken over. */
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
