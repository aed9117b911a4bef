import { Engine, EngineStopped } from '../../engine/engine';
import { type BuiltRelief, type EngineError, type Field, isFailure, errorText } from '../../engine/messages';
import type { Document } from '../../document/document';
import { sceneText } from '../../document/scene_text';
import { isSameLook, lookOf } from '../../view/painted_drawing';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { smallPicture } from '../files/pictures';

/** Most vertices of a coarse relief. */
const draftVertices = 3000;
/** Longest side of the picture that gives hidden surfaces their colours, px. */
const hiddenSide = 512;
/** The full mesh is built once nothing has changed for this long, ms. */
const rest = 160;
/** An outdated build may run for this long, ms, since the next build can reuse its results. */
const patience = 1000;

/** Largest deviation of a full relief's surface, px. */
export const fullTolerance = 0.25;

function surfaceFor(field: Field, draft: boolean) {
  return { visibility: 'orbit' as const, tolerance: draft ? 1 : fullTolerance, field };
}

function requestFor(document: Document, field: Field, draft: boolean) {
  const { settings } = document;
  return {
    scene: sceneText(document),
    options: {
      method: draft ? ('approximate' as const) : settings.method,
      vertices: draft ? Math.min(draftVertices, settings.vertices) : settings.vertices,
      edge: 0,
      rho: settings.rho,
      alpha0: 0,
      lambdaBnd: settings.lambdaBnd,
      lambdaShift: settings.lambdaShift,
      glue: true,
    },
    ...surfaceFor(field, draft),
  };
}

/** Caches the small drawing that the engine needs for hidden surfaces, until the look of the document changes. */
class SmallDrawing {
  private look: readonly unknown[] = [];
  private small: Promise<ImageBitmap> | null = null;

  take(document: Document, picture: ImageBitmap | null): Promise<ImageBitmap> {
    const look = lookOf(document, picture);
    if (this.small && isSameLook(look, this.look)) return this.small;
    this.look = look;
    this.small = smallPicture(document, picture, hiddenSide);
    return this.small;
  }
}

/** Returns the values of a document on which its relief depends. */
function shapeOf(document: Document): readonly unknown[] {
  const { width, height, parts, joins, relations, robin, cues, settings } = document;
  const { method, vertices, rho, lambdaBnd, lambdaShift } = settings;
  return [width, height, parts, joins, relations, robin, cues, method, vertices, rho, lambdaBnd, lambdaShift];
}

/** Returns the id of the part that an error is about, or null. */
function culpritOf({ culprit }: EngineError, document: Document): string | null {
  if (!culprit || culprit.list === 'strokes') return null;
  const { list, index } = culprit;
  if (list === 'parts') return document.parts[index]?.id ?? null;
  if (list === 'cues') return document.cues[index]?.part ?? null;
  return document[list][index]?.upper ?? null;
}

/**
 * Keeps the relief up to date with the document: builds a coarse relief at once and the full one when
 * the hand rests. Each has its own worker, which keeps intermediate results for its next build, so an
 * outdated build is stopped only if it takes long.
 */
export class BuildControl {
  private shape: readonly unknown[] = [];
  private draftWanted: Document | null = null;
  private drafting = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private builtFull: Document | null = null;
  private previewed = false;
  private fullWanted: Document | null = null;
  private fullRun: Promise<void> | null = null;
  private fullBegun = 0;
  private readonly smallDrawing = new SmallDrawing();
  /** The field that was last requested from the full engine. */
  private asked: Field = 'relief';

  constructor(
    private readonly editor: Editor,
    private readonly draft: Engine,
    private readonly full: Engine,
  ) {
    editor.subscribe(() => this.follow());
    editor.subscribe(() => void this.followField());
  }

  /** Throws an error with a message for the user if the engine rejects a document. */
  async check(document: Document): Promise<void> {
    const drawing = await smallPicture(document, null, 16);
    const built = await this.draft.build(requestFor(document, 'relief', true), drawing, () => undefined);
    if (isFailure(built)) throw new Error(errorText(built.error));
  }

  /** Resolves when the full engine has built the current document. Throws if it cannot be built. */
  async settle(): Promise<void> {
    if (this.builtFull === this.editor.document) return;
    clearTimeout(this.timer);
    await this.wantFull(this.editor.document);
    if (this.builtFull !== this.editor.document) throw new Error(this.editor.state.build.error?.message ?? '');
  }

  /** Stops the full build. The coarse relief stays. */
  stop(): void {
    clearTimeout(this.timer);
    this.fullWanted = null;
    this.full.cancel();
    this.editor.set({ build: { ...this.editor.state.build, phase: 'idle', progress: 0 } });
  }

  /** Shows the field that the user has chosen, without building again. */
  private async followField(): Promise<void> {
    const { field } = this.editor.state;
    if (field === this.asked || !this.isUpToDate()) return;
    this.asked = field;
    try {
      const surface = await this.full.surface(surfaceFor(field, false));
      const { relief } = this.editor.state;
      if (relief && !isFailure(surface) && field === this.asked) this.editor.set({ relief: { ...relief, surface } });
    } catch (error) {
      if (!(error instanceof EngineStopped)) throw error;
    }
  }

  /** Returns whether the full engine has built the current document. */
  isUpToDate(): boolean {
    return this.builtFull !== null && !this.isStale(this.builtFull);
  }

  private isStale(document: Document): boolean {
    return shapeOf(document).some((value, i) => value !== this.shape[i]);
  }

  private follow(): void {
    const { state } = this.editor;
    const document = state.preview ?? this.editor.document;
    // A document that is opened again has no relief yet.
    const shape = [...shapeOf(document), state.opened];
    if (shape.length === this.shape.length && shape.every((value, i) => value === this.shape[i])) return;
    this.shape = shape;
    // The preview of a stroke that was dropped must disappear.
    if (this.previewed && !state.preview) this.builtFull = null;
    this.previewed = state.preview !== null;
    clearTimeout(this.timer);
    this.fullWanted = null;
    if (document.settings.method === 'nonlinear' || performance.now() - this.fullBegun > patience) this.full.cancel();
    if (document.parts.length === 0) {
      this.editor.set({ relief: null, culprit: null, build: { phase: 'idle', progress: 0, error: null } });
      return;
    }
    this.start(document);
  }

  /** Starts the builds. The phase becomes idle with the full relief, or with the coarse one while the pen is down. */
  private start(document: Document): void {
    this.draftWanted = document;
    this.editor.set({ build: { ...this.editor.state.build, phase: 'draft', progress: 0 } });
    if (!this.drafting) void this.runDrafts();
    if (!this.editor.state.preview) this.timer = setTimeout(() => void this.wantFull(document), rest);
  }

  /** Builds coarse reliefs until the newest document is built. */
  private async runDrafts(): Promise<void> {
    this.drafting = true;
    while (this.draftWanted) {
      const document = this.draftWanted;
      this.draftWanted = null;
      if (!this.isUpToDate()) await this.build(this.draft, document, 'draft');
    }
    this.drafting = false;
  }

  /** Asks for a full build. Resolves when the full engine is idle. */
  private wantFull(document: Document): Promise<void> {
    this.fullWanted = document;
    this.fullRun ??= this.runFull().finally(() => {
      this.fullRun = null;
    });
    return this.fullRun;
  }

  private async runFull(): Promise<void> {
    while (this.fullWanted) {
      const document = this.fullWanted;
      this.fullWanted = null;
      this.fullBegun = performance.now();
      if (await this.build(this.full, document, 'full')) await this.followField();
    }
  }

  private async build(engine: Engine, document: Document, phase: 'draft' | 'full'): Promise<boolean> {
    this.editor.set({ build: { phase, progress: 0, error: this.editor.state.build.error } });
    const { field } = this.editor.state;
    if (phase === 'full') this.asked = field;
    try {
      const drawing = await this.smallDrawing.take(document, this.editor.state.picture);
      if (phase === 'full' && this.isStale(document)) return false;
      const built = await engine.build(requestFor(document, field, phase === 'draft'), drawing, (_stage, done, energy) => {
        if (phase === 'full') this.advance(done, energy);
      });
      return isFailure(built) ? this.refuse(document, built.error) : this.accept(document, built, phase);
    } catch (error) {
      if (!(error instanceof EngineStopped) || error.crashed)
        this.refuse(document, { code: 'internal', message: t('crashed'), where: '' });
      return false;
    }
  }

  private advance(progress: number, energy?: number): void {
    const { build } = this.editor.state;
    const energies = energy === undefined ? build.energies ?? [] : [...(build.energies ?? []), energy];
    this.editor.set({ build: { ...build, progress, energies } });
  }

  private accept(document: Document, relief: BuiltRelief, phase: 'draft' | 'full'): boolean {
    if (phase === 'full' && this.isStale(document)) return false;
    const { build, preview } = this.editor.state;
    // The full build may have finished first if it had little to do.
    if (phase === 'draft' && this.isUpToDate()) {
      this.editor.set({ build: { ...build, phase: 'idle' } });
      return true;
    }
    const goesOn = phase === 'draft' && !preview;
    if (phase === 'full') this.builtFull = document;
    this.editor.set({ relief, culprit: null, build: goesOn ? { ...build, error: null } : { phase: 'idle', progress: 1, error: null } });
    return true;
  }

  /** Reports an error and marks the part that caused it. The last good relief stays. */
  private refuse(document: Document, error: EngineError): boolean {
    // A stroke in progress may fail; only the document itself is worth an error.
    if (document !== this.editor.document) {
      this.editor.set({ build: { ...this.editor.state.build, phase: 'idle' } });
      return false;
    }
    this.editor.set({
      culprit: culpritOf(error, document),
      build: { phase: 'idle', progress: 0, error },
      notice: errorText(error),
    });
    return false;
  }
}
