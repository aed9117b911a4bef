import type { BuiltRelief, EngineError } from '../engine/messages';
import { type Document, emptyDocument } from '../document/document';
import { type History, record, redo, startHistory, undo } from '../document/history';
import { Store } from './store';

export type ToolName = 'select' | 'draw' | 'join' | 'order' | 'range' | 'hand' | 'outline';
export type Field = 'relief' | 'inflation' | 'shift';
export type Shading = 'drawing' | 'clay' | 'normals';

export interface BuildState {
  /** What is going on. */
  phase: 'idle' | 'draft' | 'full';
  /** In [0, 1]. */
  progress: number;
  error: EngineError | null;
  /** Of the non-linear method, step by step. */
  energies?: readonly number[];
}

export interface EditorState {
  history: History;
  /** Whether there is work to go on with; the first screen otherwise. */
  open: boolean;
  tool: ToolName;
  selected: string | null;
  hovered: string | null;
  /** The part that is drawn in red because it cannot be built. */
  culprit: string | null;
  shading: Shading;
  /** The height that the relief shows. */
  field: Field;
  depthTint: boolean;
  showMarks: boolean;
  peeking: boolean;
  build: BuildState;
  relief: BuiltRelief | null;
  /** The picture of the drawing, premultiplied; null on an empty page. */
  picture: ImageBitmap | null;
  saved: 'yes' | 'no' | 'failed';
  /** One line for a person, read out by screen readers. */
  notice: string;
  panel: 'none' | 'keys' | 'export' | 'settings';
  tourStep: number | null;
}

function firstState(): EditorState {
  return {
    history: startHistory(emptyDocument()),
    open: false,
    tool: 'select',
    selected: null,
    hovered: null,
    culprit: null,
    shading: 'drawing',
    field: 'relief',
    depthTint: false,
    showMarks: true,
    peeking: false,
    build: { phase: 'idle', progress: 0, error: null },
    relief: null,
    picture: null,
    saved: 'yes',
    notice: '',
    panel: 'none',
    tourStep: null,
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

  /** Goes on to a document; steps of one gesture become one change. */
  edit(label: string, next: Document, gesture: string | null = null): void {
    this.set({ notice: '' });
    this.show(record(this.state.history, label, next, gesture));
  }

  undo(): void {
    this.show(undo(this.state.history));
  }

  redo(): void {
    this.show(redo(this.state.history));
  }

  /** Begins anew with a document of its own history. */
  openDocument(document: Document, picture: ImageBitmap | null): void {
    this.set({
      history: startHistory(document),
      open: true,
      selected: null,
      hovered: null,
      culprit: null,
      relief: null,
      picture,
      build: { phase: 'idle', progress: 0, error: null },
    });
  }

  select(id: string | null): void {
    this.set({ selected: id });
  }

  private show(history: History): void {
    if (history === this.state.history) return;
    const { selected } = this.state;
    const stays = history.document.parts.some((part) => part.id === selected);
    this.set({ history, selected: stays ? selected : null });
  }
}
