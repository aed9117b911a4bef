import type { BuiltRelief, Dressed, EngineError, Failure, Field, Solid } from '../../engine/messages';
import { noteCorrections } from '../../document/corrections';
import { cueRanges } from '../../document/cues';
import { type Cue, type Document, emptyDocument } from '../../document/document';
import type { Doubt } from '../../document/doubts';
import type { Gap } from '../../document/gaps';
import { amend, type History, record, redo, startHistory, undo } from '../../document/history';
import type { Brush } from '../../tools/scribble_tool';
import type { ModelShading } from '../../view/model_renderer';
import { isSameLook } from '../../view/painted_drawing';
import { type PrintChoice, usualPrint } from './print_choice';
import { Store } from './store';

export type ToolName = 'select' | 'draw' | 'join' | 'order' | 'range' | 'hand' | 'scribble' | 'outline' | 'cue' | 'paint';

interface BuildState {
  /** The build that is running. */
  phase: 'idle' | 'draft' | 'full';
  /** In [0, 1]. */
  progress: number;
  error: EngineError | null;
  /** Energy after each step of the non-linear method. */
  energies?: readonly number[];
}

/** A relief as exported files contain it, with the look of the document that its picture shows. */
export interface DressedRelief extends Dressed {
  relief: BuiltRelief;
  look: readonly unknown[];
  /** Factor for the width of its contours; 0: it has none. */
  contourWidth: number;
}

/** The place of a document on the shelf. `keep: 'changes'` saves it only once it is changed. */
export interface ShelfPlace {
  readonly id: string;
  readonly keep: 'all' | 'changes';
}

export interface EditorState {
  history: History;
  /** Whether the workspace is shown instead of the first screen. */
  open: boolean;
  /** The place of the document on the shelf. */
  shelf: ShelfPlace | null;
  /** How many files are being read. */
  reading: number;
  /** A lasting problem: nothing can be saved, or another tab took the document over. */
  alert: 'none' | 'unsaved' | 'takenOver';
  /** The id of a document that the user wants to open but another tab has open. */
  elsewhere: string | null;
  tool: ToolName;
  selected: string | null;
  hovered: string | null;
  /** The part that caused the last error, drawn in red. */
  culprit: string | null;
  shading: ModelShading;
  /** The height field that the relief shows. */
  field: Field;
  depthTint: boolean;
  showMarks: boolean;
  peeking: boolean;
  /** Whether dragging on the relief moves the light. */
  lighting: boolean;
  /** On narrow screens: the large pane, and whether the lists cover it. */
  pane: 'paper' | 'model';
  sideOpen: boolean;
  build: BuildState;
  relief: BuiltRelief | null;
  /** The last dressed relief. It is shown in place of `relief` if it belongs to it. */
  dressed: DressedRelief | null;
  /** The document that the stroke in progress would make. */
  preview: Document | null;
  /** The relief or solid that is on the screen now. */
  shown: BuiltRelief | Solid | null;
  /** Whether the browser has no 3D graphics, so that the processor draws the relief. */
  plainGraphics: boolean;
  /** Number of documents opened so far. */
  opened: number;
  /** The picture of the drawing, with premultiplied alpha; null on an empty page. */
  picture: ImageBitmap | null;
  saved: 'yes' | 'no' | 'failed';
  /** One line for the user, which screen readers read out. */
  notice: string;
  panel: 'none' | 'keys' | 'export' | 'print' | 'settings' | 'versions';
  print: PrintChoice;
  /** The solid shown in place of the relief while the print panel is open, or the reason why there is none. */
  solid: Solid | Failure | null;
  tourStep: number | null;
  /** Total angle by which the user has turned the relief since the document was opened, radians. */
  turned: number;
  brush: Brush;
  /** The cue that the next line of the profile tool makes. */
  cue: Pick<Cue, 'kind' | 'value'>;
  /** The brush of the painting tool; its width in px of the page. `rubs` removes paint. */
  paint: { color: string; width: number; rubs: boolean };
  /** Whether the drawing tool adds eyes. */
  eyes: boolean;
  /** Whether new parts go behind all others. */
  behind: boolean;
  /** The labels as a picture, the gaps that were closed, and the time that the labels took. */
  tint: { tint: ImageBitmap; gaps: readonly Gap[]; ms: number } | null;
  /** The uncertain guess that the user is asked about. */
  doubt: Doubt | null;
  /** The document with all queued strokes, or null if there are none. */
  pending: Document | null;
}

/** Returns the current relief dressed in this look of the document, with contours of any width, or null. */
export function dressedIn({ relief, dressed }: EditorState, look: readonly unknown[]): DressedRelief | null {
  return dressed?.relief === relief && dressed && isSameLook(dressed.look, look) ? dressed : null;
}

function firstState(): EditorState {
  return {
    history: startHistory(emptyDocument()),
    open: false,
    shelf: null,
    reading: 0,
    alert: 'none',
    elsewhere: null,
    tool: 'select',
    selected: null,
    hovered: null,
    culprit: null,
    shading: 'drawing',
    field: 'relief',
    depthTint: false,
    showMarks: true,
    peeking: false,
    lighting: false,
    pane: 'paper',
    sideOpen: false,
    build: { phase: 'idle', progress: 0, error: null },
    relief: null,
    dressed: null,
    preview: null,
    shown: null,
    plainGraphics: false,
    opened: 0,
    picture: null,
    saved: 'yes',
    notice: '',
    panel: 'none',
    print: usualPrint,
    solid: null,
    tourStep: null,
    turned: 0,
    brush: { kind: 'auto', part: null, width: 12, soft: false },
    cue: { kind: 'crease', value: cueRanges.crease.usual },
    paint: { color: '#e27d8a', width: 18, rubs: false },
    eyes: false,
    behind: false,
    tint: null,
    doubt: null,
    pending: null,
  };
}

/** Holds the state of the page and the few ways to change it. */
export class Editor extends Store<EditorState> {
  constructor() {
    super(firstState());
  }

  get document(): Document {
    return this.state.history.document;
  }

  /** Makes a step. Steps with the same gesture merge into one. Changes of guesses become corrections. */
  edit(label: string, next: Document, gesture: string | null = null): void {
    this.set({ notice: '' });
    this.show(record(this.state.history, label, noteCorrections(this.document, next), gesture));
  }

  /** Extends the last step to `next`. */
  complete(next: Document): void {
    this.show(amend(this.state.history, next));
  }

  undo(): void {
    this.show(undo(this.state.history));
  }

  redo(): void {
    this.show(redo(this.state.history));
  }

  /** Switches to another document. */
  openDocument(history: History, picture: ImageBitmap | null, shelf: ShelfPlace): void {
    this.set({
      history,
      shelf,
      open: true,
      elsewhere: null,
      panel: 'none',
      opened: this.state.opened + 1,
      tourStep: null,
      turned: 0,
      selected: null,
      hovered: null,
      culprit: null,
      relief: null,
      solid: null,
      picture,
      tint: null,
      doubt: null,
      pending: null,
      preview: null,
      build: { phase: 'idle', progress: 0, error: null },
    });
  }

  /** Selects a part. Other ids, such as that of a solid's plate, deselect. */
  select(id: string | null): void {
    const known = this.document.parts.some((part) => part.id === id);
    this.set({ selected: known ? id : null });
  }

  private show(history: History): void {
    if (history === this.state.history) return;
    const { selected } = this.state;
    const stays = history.document.parts.some((part) => part.id === selected);
    this.set({ history, selected: stays ? selected : null });
  }
}
