import type { Document, DrawingSource, Point } from '../../document/document';
import type { Gap } from '../../document/gaps';
import { inflatesPaper } from '../../document/paper';
import { type Corrections, recordText, type Scribbles } from '../../document/segmentation';
import { adopt, canScribble, questionOf, segmentationOf } from '../../document/scribbling';
import { type Engine, EngineStopped } from '../../engine/engine';
import {
  type Failure, type FlatDrawing, isFailure, type SegmentationRequest, type TintedLabels, errorText,
  type Understanding,
} from '../../engine/messages';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { pixelsOf } from '../files/pictures';

/** Hidden shapes are found again once a new order has stayed for this long, ms. */
const rest = 300;

/** A change of strokes that waits for the engine to interpret it. */
interface Wish {
  readonly drawing: DrawingSource | null;
  readonly label: string;
  change(document: Document): Document;
}

function requestOf(document: Document): SegmentationRequest {
  const segmentation = segmentationOf(document);
  return { project: recordText(segmentation), labels: segmentation.labels };
}

function gapsOf({ bridges }: TintedLabels): Gap[] {
  return bridges.map(({ points, left, right }) => ({
    points: Array.from({ length: points.length / 2 }, (_, i): Point => [points[2 * i] as number, points[2 * i + 1] as number]),
    left,
    right,
  }));
}

/** Asks a worker about drawings and sends it each drawing only once. */
class DrawingReader {
  private opened: DrawingSource | null = null;
  private opening: Promise<object | Failure> = Promise.resolve({});

  private made: Engine | null = null;

  constructor(
    private readonly editor: Editor,
    private readonly make: () => Engine,
    private readonly network: () => Promise<Uint8Array>,
  ) {}

  /** The worker. It starts on first use. */
  get engine(): Engine {
    this.made ??= this.make();
    return this.made;
  }

  async ask<T extends object>(document: Document, question: (engine: Engine) => Promise<T | Failure>): Promise<T | Failure> {
    const { drawing } = document;
    if (!drawing) throw new Error('no drawing');
    if (this.opened !== drawing) {
      this.opened = drawing;
      this.opening = this.open(this.flat(document, drawing));
    }
    try {
      const opened = await this.opening;
      return isFailure(opened) ? opened : await question(this.engine);
    } catch (error) {
      // The worker that had the drawing is gone.
      this.opened = null;
      throw error;
    }
  }

  private async open(drawing: FlatDrawing): Promise<object | Failure> {
    const network = await this.network().catch(() => null);
    if (network) return await this.engine.openDrawing(drawing, network);
    this.opened = null;
    return { error: { code: 'file', message: 'a part of the editor could not be loaded; check the connection and try again', where: '' } };
  }

  private flat({ width, height }: Document, drawing: DrawingSource): FlatDrawing {
    const { picture } = this.editor.state;
    if (drawing.mime === 'image/png') return { png: drawing.bytes };
    if (!picture) throw new Error('no picture');
    return { pixels: pixelsOf(picture, width, height) };
  }
}

/**
 * Interprets flat drawings in two workers. One only computes labels, so that they never wait: while
 * the pen is down, the labels appear as a tint at once. The other finds what follows from the strokes
 * (hidden shapes, order, joins). When it is known, it becomes one change of the document together
 * with the strokes.
 */
export class SegmentControl {
  private readonly labeller: DrawingReader;
  private readonly thinker: DrawingReader;
  private readonly wishes: Wish[] = [];
  private working = false;
  private wanted: Document | null = null;
  private tinting = false;
  private ordered: Document['parts'] | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private reordered: Document | null = null;
  private tinted: { drawing: DrawingSource; scribbles: Scribbles; corrections: Corrections } | null = null;

  /** `network` loads the weights that the core perceives flat drawings with. */
  constructor(private readonly editor: Editor, start: () => Engine, network: () => Promise<Uint8Array>) {
    this.labeller = new DrawingReader(editor, start, network);
    this.thinker = new DrawingReader(editor, start, network);
    editor.subscribe(() => {
      this.followOrder();
      this.followStrokes();
    });
  }

  /** Throws an error with a message for the user if the segmentation of a document from a file is not valid. */
  async check(document: Document): Promise<void> {
    if (!document.segmentation) return;
    const checked = await this.thinker.engine.checkSegmentation(requestOf(document));
    if (isFailure(checked)) throw new Error(errorText(checked.error));
  }

  /** Guesses the parts of a drawing that has none yet. */
  async guess(document: Document): Promise<Understanding | Failure> {
    return this.thinker.ask(document, (engine) => engine.understand(questionOf(document)));
  }

  /** Shows the labels of a document that is still changing. Requests that are overtaken by a newer one are skipped. */
  show(document: Document): void {
    this.wanted = document;
    if (!this.tinting) void this.tint();
  }

  /** Queues a change of strokes. The strokes and what follows from them become one step to undo. */
  wish(label: string, change: (document: Document) => Document): void {
    this.wishes.push({ drawing: this.editor.document.drawing, label, change });
    this.showPending();
    if (!this.working) void this.work();
  }

  /** Drops all queued changes. Returns whether there were any. */
  forgetWishes(): boolean {
    if (this.wishes.length === 0) return false;
    this.wishes.length = 0;
    this.showPending();
    return true;
  }

  /** Resolves when no change is queued any more. */
  async settle(): Promise<void> {
    if (this.reordered) await this.rethink(this.reordered);
    while (this.working) await new Promise((resolve) => setTimeout(resolve, 20));
  }

  /** The document with all queued changes. */
  get pending(): Document {
    return this.wishes.reduce((document, wish) => wish.change(document), this.editor.document);
  }

  private showPending(): void {
    this.editor.set({ pending: this.wishes.length > 0 ? this.pending : null });
  }

  /** Finds hidden shapes again after the order changed, since they depend on what lies in front. */
  private followOrder(): void {
    const { history } = this.editor.state;
    const { document } = history;
    if (document.parts === this.ordered) return;
    this.ordered = document.parts;
    clearTimeout(this.timer);
    const isNew = history.done.at(-1)?.label === 'order' && history.undone.length === 0;
    this.reordered = document.segmentation && isNew ? document : null;
    if (this.reordered) this.timer = setTimeout(() => void this.rethink(document), rest);
  }

  private async rethink(document: Document): Promise<void> {
    try {
      const understood = await this.thinker.ask(document, (engine) => engine.understand(questionOf(document)));
      if (this.reordered !== document || this.editor.document !== document) return;
      this.reordered = null;
      if (isFailure(understood)) this.editor.set({ notice: errorText(understood.error) });
      else {
        const next = adopt(document, understood);
        this.ordered = next.parts;
        this.editor.complete(next);
      }
    } catch (error) {
      if (!(error instanceof EngineStopped)) throw error;
    }
  }

  /** Keeps the tint up to date with the document while strokes are shown. */
  private followStrokes(): void {
    const { document, state } = this.editor;
    const { drawing } = document;
    if (state.tool !== 'scribble' || !state.open || !drawing || !canScribble(document) || this.wishes.length > 0) return;
    const { scribbles, corrections } = segmentationOf(document);
    if (this.tinted?.drawing === drawing && this.tinted.scribbles === scribbles && this.tinted.corrections === corrections) return;
    this.tinted = { drawing, scribbles, corrections };
    this.show(document);
  }

  private async tint(): Promise<void> {
    this.tinting = true;
    while (this.wanted) {
      const document = this.wanted;
      this.wanted = null;
      const begun = performance.now();
      try {
        const labelled = await this.labeller.ask(document, (engine) =>
          engine.label(requestOf(document), document.width, document.height),
        );
        if (document.drawing !== this.editor.document.drawing) continue;
        if (isFailure(labelled)) this.editor.set({ tint: null });
        else this.editor.set({ tint: { tint: labelled.tint, gaps: gapsOf(labelled), ms: performance.now() - begun } });
      } catch (error) {
        if (!(error instanceof EngineStopped)) throw error;
      }
    }
    this.tinting = false;
  }

  private async work(): Promise<void> {
    this.working = true;
    while (this.wishes.length > 0) await this.grant(this.wishes[0] as Wish);
    this.working = false;
  }

  /** Handles the first queued change. If the document changed meanwhile, the change stays queued for another try. */
  private async grant(wish: Wish): Promise<void> {
    const { document } = this.editor;
    if (document.drawing !== wish.drawing) {
      this.forgetWishes();
      return;
    }
    try {
      const changed = wish.change(document);
      const understood =
        changed === document ? null : await this.thinker.ask(changed, (engine) => engine.understand(questionOf(changed)));
      if (this.wishes[0] !== wish) return;
      if (understood && this.editor.document !== document) return;
      this.wishes.shift();
      if (understood) this.make(wish, changed, understood);
    } catch (error) {
      this.wishes.length = 0;
      this.editor.set({ notice: error instanceof EngineStopped ? t('crashed') : String(error) });
    }
    this.showPending();
  }

  private make(wish: Wish, changed: Document, understood: Understanding | Failure): void {
    if (isFailure(understood)) {
      this.tinted = null;
      this.editor.set({ notice: errorText(understood.error) });
      return;
    }
    const { selected } = this.editor.state;
    const next = adopt(changed, understood);
    if (wish.label === 'scribble' && inflatesPaper(this.editor.document, next)) {
      this.tinted = null;
      this.followStrokes();
      this.editor.set({ notice: t('paperStroke') });
      return;
    }
    this.editor.edit(wish.label, next);
    if (selected !== null) this.editor.select(selected);
    if (understood.warnings.length > 0) this.editor.set({ notice: understood.warnings.join(' ') });
  }
}
