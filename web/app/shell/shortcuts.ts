import { partIndex } from '../../document/document';
import { changePart, movePart, neighbours, removePart, toggleJoin } from '../../document/editing';
import { t } from '../../words/catalogue';
import type { ModelShading } from '../../view/model_renderer';
import type { Editor } from '../state/editor';
import { nextField } from '../panes/field_switch';
import type { FileControl } from '../control/file_control';
import type { PaperControl } from '../panes/paper_pane';
import { brushWidths } from '../bars/scribble_bar';
import type { SegmentControl } from '../control/segment_control';
import { tools } from '../bars/toolbar';

/** The keys that are held down now. */
export interface HeldKeys {
  light: boolean;
}

interface Scope {
  editor: Editor;
  files: FileControl;
  segments: SegmentControl;
  paper(): PaperControl | null;
  choose(): void;
}

const nextShading: Record<ModelShading, ModelShading> = { drawing: 'clay', clay: 'normals', normals: 'drawing' };

/**
 * Separates a part from the part behind that it is joined to or, if it has no join, joins it to the nearest
 * part behind.
 */
function toggleOwnJoin(editor: Editor, id: string): void {
  const { document } = editor;
  const index = partIndex(document, id);
  const own = document.joins.find((join) => join.upper === id);
  const behind = neighbours(document, id).find((part) => partIndex(document, part.id) < index);
  const other = own?.lower ?? behind?.id;
  const next = other === undefined ? document : toggleJoin(document, id, other);
  if (next === document) editor.set({ notice: t('nothingToJoin') });
  else editor.edit('join', next);
}

function resizeBrush(editor: Editor, factor: number): void {
  const { brush } = editor.state;
  const width = Math.min(brushWidths.most, Math.max(brushWidths.least, Math.round(factor * brush.width)));
  editor.set({ brush: { ...brush, width } });
}

/** Returns the actions of keys on the selected part. */
function partKeys(editor: Editor, id: string): Record<string, () => void> {
  const { document } = editor;
  const at = partIndex(document, id);
  const part = document.parts[at];
  const moveTo = (to: number) => (): void => editor.edit('order', movePart(document, id, to));
  const remove = (): void => editor.edit('remove', removePart(document, id));
  return {
    PageUp: moveTo(at + 1),
    PageDown: moveTo(at - 1),
    Home: moveTo(document.parts.length - 1),
    End: moveTo(0),
    Delete: remove,
    Backspace: remove,
    j: () => toggleOwnJoin(editor, id),
    h: () => part && editor.edit('reverse', changePart(document, id, { d: -part.d })),
  };
}

function pageKeys({ editor, paper }: Scope): Record<string, () => void> {
  const { state } = editor;
  return {
    '0': () => paper()?.fit(),
    '+': () => paper()?.zoom(1.25),
    '=': () => paper()?.zoom(1.25),
    '-': () => paper()?.zoom(0.8),
    '[': () => resizeBrush(editor, 1 / 1.3),
    ']': () => resizeBrush(editor, 1.3),
    n: () => editor.set({ shading: nextShading[state.shading] }),
    f: () => editor.set({ field: nextField(state.field) }),
    d: () => editor.set({ depthTint: !state.depthTint }),
    '?': () => editor.set({ panel: state.panel === 'keys' ? 'none' : 'keys' }),
    Escape: () => {
      paper()?.cancelGesture();
      if (state.panel !== 'none' || state.tourStep !== null) editor.set({ panel: 'none', tourStep: null });
      else editor.select(null);
    },
  };
}

function commandKeys({ editor, files, segments, choose }: Scope, shift: boolean): Record<string, () => void> {
  return {
    z: () => (shift ? editor.redo() : segments.forgetWishes() || editor.undo()),
    y: () => editor.redo(),
    s: () => void files.saveProject(),
    o: choose,
    e: () => editor.set({ panel: editor.state.panel === 'export' ? 'none' : 'export' }),
  };
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

/** Handles a key. Returns whether it means something here. */
function press(event: KeyboardEvent, scope: Scope, held: HeldKeys): boolean {
  const { editor } = scope;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.metaKey) return run(commandKeys(scope, event.shiftKey)[key]);
  if (isTyping(event.target) && key !== 'Escape') return false;
  if (!editor.state.open) return false;
  if (key === 'v' || key === 'l') {
    if (key === 'v') editor.set({ peeking: true });
    else held.light = true;
    return true;
  }
  const paper = scope.paper();
  if (key === ' ' && paper && !(event.target instanceof HTMLButtonElement)) {
    paper.spaceHeld = true;
    return true;
  }
  const onPage = event.target === document.body || event.target instanceof HTMLCanvasElement;
  if (onPage && paper?.toolKey(key, event.shiftKey, event.altKey)) return true;
  const tool = tools.find((entry) => entry.key === key);
  if (tool) return run(() => editor.set({ tool: tool.name, notice: '' }));
  const { selected } = editor.state;
  return run((selected === null ? undefined : partKeys(editor, selected)[key]) ?? pageKeys(scope)[key]);
}

function run(action: (() => void) | undefined): boolean {
  action?.();
  return action !== undefined;
}

/** Listens to the keyboard. Keys without a meaning here are left to the browser. */
export function listenToKeys(scope: Scope): HeldKeys {
  const held: HeldKeys = { light: false };
  window.addEventListener('keydown', (event) => {
    if (press(event, scope, held)) event.preventDefault();
  });
  const release = (key: string): void => {
    if (key === 'v') scope.editor.set({ peeking: false });
    if (key === 'l') held.light = false;
    const paper = scope.paper();
    if (key === ' ' && paper) paper.spaceHeld = false;
  };
  window.addEventListener('keyup', (event) => release(event.key.toLowerCase()));
  window.addEventListener('blur', () => ['v', 'l', ' '].forEach(release));
  return held;
}
