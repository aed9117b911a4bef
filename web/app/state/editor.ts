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
  /** What is going on. */
  phase: 'idle' | 'draft' | 'full';
  /** In [0, 1]. */
  progress: number;
  error: EngineError | null;
  /** Of the non-linear method, step by step. */
  energies?: readonly number[];
}

/** A relief as its files hold it, and the look that its picture was made of. */
export interface DressedRelief extends Dressed {
  relief: BuiltRelief;
  look: readonly unknown[];
}

export interface ShelfPlace {
  readonly id: string;
  readonly keep: 'all' | 'changes';
}

export interface EditorState {
  history: History;
  /** Whether the workspace is shown; the first screen otherwise. */
  open: boolean;
  /** Where on the shelf the document is kept; what is only looked at is kept when it changes. */
  shelf: ShelfPlace | null;
  /** How many files are being read. */
  reading: number;
  /** What stays said until it is over. */
  standing: 'none' | 'unkept' | 'lost';
  /** A document that was asked for and that another tab has open. */
  elsewhere: string | null;
  tool: ToolName;
  selected: string | null;
  hovered: string | null;
  /** The part that is drawn in red because it cannot be built. */
  culprit: string | null;
  shading: ModelShading;
  /** The height that the relief shows. */
  field: Field;
  depthTint: boolean;
  showMarks: boolean;
  peeking: boolean;
  /** Whether dragging on the relief moves the light. */
  lighting: boolean;
  /** On a narrow screen: what is large, and whether the lists lie over it. */
  pane: 'paper' | 'model';
  sideOpen: boolean;
  build: BuildState;
  relief: BuiltRelief | null;
  /** The last full relief that was dressed, shown in its place as long as it is the present one. */
  dressed: DressedRelief | null;
  /** What is being drawn would make this. */
  preview: Document | null;
  /** The relief or solid that can be seen. */
  shown: BuiltRelief | Solid | null;
  /** Whether the browser has no graphics, so that the relief is drawn more slowly and plainly. */
  plainGraphics: boolean;
  /** Counts the documents that were opened. */
  opened: number;
  /** The picture of the drawing, premultiplied; null on an empty page. */
  picture: ImageBitmap | null;
  saved: 'yes' | 'no' | 'failed';
  /** One line for a person, read out by screen readers. */
  notice: string;
  panel: 'none' | 'keys' | 'export' | 'print' | 'settings' | 'versions';
  print: PrintChoice;
  /** What is shown in place of the relief while it is prepared for printing, or why there is none. */
  solid: Solid | Failure | null;
  tourStep: number | null;
  /** How far a hand has turned the relief since the document was opened, radians. */
  turned: number;
  brush: Brush;
  /** What the next line of the profile tool says. */
  cue: Pick<Cue, 'kind' | 'value'>;
  /** What the painting tool paints, px of the page; whether it rubs out. */
  paint: { color: string; width: number; rubs: boolean };
  /** Whether the drawing tool puts eyes. */
  eyes: boolean;
  /** Whether strokes of the drawing tool go behind all parts. */
  behind: boolean;
  /** The labels of the strokes that are shown, the gaps that are closed, and how long they took. */
  tint: { tint: ImageBitmap; gaps: readonly Gap[]; ms: number } | null;
  /** What is uncertain and looked at. */
  doubt: Doubt | null;
  /** With strokes that wait to be understood. */
  pending: Document | null;
}

/** Whether the present relief is dressed, with a drawing of this look. */
export function isDressed({ relief, dressed }: EditorState, look: readonly unknown[]): boolean {
  return dressed !== null && dressed.relief === relief && isSameLook(dressed.look, look);
}

function firstState(): EditorState {
  return {
    history: startHistory(emptyDocument()),
    open: false,
    shelf: null,
    reading: 0,
    standing: 'none',
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

/** Everything that the page shows, and the few ways to change it. */
export class Editor extends Store<EditorState> {
  constructor() {
    super(firstState());
  }

  get document(): Document {
    return this.state.history.document;
  }

  /** Goes on to a document; steps of one gesture become one change. What it changes is kept as corrections. */
  edit(label: string, next: Document, gesture: string | null = null): void {
    this.set({ notice: '' });
    this.show(record(this.state.history, label, noteCorrections(this.document, next), gesture));
  }

  /** Goes on to what follows from the last change, as a part of it. */
  complete(next: Document): void {
    this.show(amend(this.state.history, next));
  }

  undo(): void {
    this.show(undo(this.state.history));
  }

  redo(): void {
    this.show(redo(this.state.history));
  }

  /** Goes over to another document. */
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

  /** Chooses a part; a solid's plate is none. */
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
