import { useMemo, useRef } from 'preact/hooks';
import type { Document } from '../../document/document';
import { openQuestions } from '../../document/gaps';
import { isFailure } from '../../engine/messages';
import { CueTool } from '../../tools/cue_tool';
import { DrawTool } from '../../tools/draw_tool';
import { JoinTool } from '../../tools/join_tool';
import { OutlineTool } from '../../tools/outline_tool';
import { OrderTool } from '../../tools/order_tool';
import { type PaintBrush, PaintTool } from '../../tools/paint_tool';
import { RangeTool } from '../../tools/range_tool';
import { type ScribbleHost, ScribbleTool } from '../../tools/scribble_tool';
import { SelectTool } from '../../tools/select_tool';
import type { Tool, ToolHost } from '../../tools/tool';
import { swayingGif } from '../../view/animation';
import type { ModelView } from '../../view/model_view';
import { t } from '../../words/catalogue';
import { CueBar } from '../bars/cue_bar';
import { DoubtBar } from '../bars/doubt_bar';
import { DrawBar } from '../bars/draw_bar';
import type { Editor, EditorState, ToolName } from '../state/editor';
import { ExportPanel } from '../panels/export_panel';
import type { FileControl } from '../control/file_control';
import { Icon } from '../widgets/icons';
import type { Keeper } from '../control/keeper';
import { KeysPanel } from '../panels/keys_panel';
import { ModelPane } from '../panes/model_pane';
import { type PaperControl, PaperPane } from '../panes/paper_pane';
import { PaperPixels } from '../panes/paper_pixels';
import { NameField } from '../widgets/name_field';
import { PaintBar } from '../bars/paint_bar';
import { PartCount } from '../panels/part_count';
import { PartList } from '../panels/part_list';
import { PartPanel } from '../panels/part_panel';
import { PrintPanel } from '../panels/print_panel';
import { SettingsPanel } from '../panels/settings_panel';
import { ScribbleBar, StrokeList } from '../bars/scribble_bar';
import type { SegmentControl } from '../control/segment_control';
import type { HeldKeys } from './shortcuts';
import { useStore } from '../state/store';
import { Toolbar, tools } from '../bars/toolbar';
import { Tour } from './tour';
import { VersionsPanel } from '../panels/versions_panel';

function makeTools(editor: Editor, host: ToolHost, scribbles: ScribbleHost): Record<ToolName, Tool> {
  const paint = (): PaintBrush => {
    const { color, width, rubs } = editor.state.paint;
    return { color: rubs ? null : color, width };
  };
  const select = new SelectTool(host);
  return {
    select,
    hand: select,
    draw: new DrawTool(host, () => t('part'), () => editor.state.behind, () => editor.state.eyes),
    join: new JoinTool(host),
    order: new OrderTool(host),
    range: new RangeTool(host),
    scribble: new ScribbleTool(host, scribbles),
    outline: new OutlineTool(host),
    cue: new CueTool(host, () => editor.state.cue),
    paint: new PaintTool(host, paint),
  };
}

const relationWords = { usual: 'relationDefault', equal: 'relationEqual', joined: 'relationJoined', above: 'relationAbove', free: 'relationFree', below: 'farther' } as const;

function hostOf(editor: Editor, reach: () => number): ToolHost {
  return {
    get document() {
      return editor.document;
    },
    get selected() {
      return editor.state.selected;
    },
    get reach() {
      return reach();
    },
    edit: (label: string, next: Document, gesture?: string) => editor.edit(label, next, gesture ?? null),
    preview: (document) => editor.set({ preview: document }),
    select: (id) => editor.select(id),
    hover: (id) => editor.set({ hovered: id }),
    tellRelation: (pair, kind) => editor.set({ notice: t('relationNow', { ...pair, relation: t(relationWords[kind ?? 'usual']) }) }),
    refuse: (reason) => editor.set({ notice: t(reason) }),
  };
}

function scribbleHostOf(editor: Editor, segments: SegmentControl): ScribbleHost {
  const pixels = new PaperPixels();
  return {
    get brush() {
      return editor.state.brush;
    },
    get pending() {
      return segments.pending;
    },
    get tint() {
      return editor.state.tint?.tint ?? null;
    },
    get gaps() {
      return openQuestions(segments.pending, editor.state.tint?.gaps ?? []);
    },
    get gap() {
      const { doubt } = editor.state;
      return doubt?.kind === 'gap' ? doubt.gap : null;
    },
    chooseGap: (gap) => editor.set({ doubt: { kind: 'gap', gap } }),
    show: (document) => segments.show(document),
    drop: () => segments.show(segments.pending),
    wish: (label, change) => segments.wish(label, change),
    refuse: (reason) => editor.set({ notice: t(reason) }),
    isPaper: (point) => pixels.isPaper(editor.state.picture, [editor.document.width, editor.document.height], point),
  };
}

function TopBar({ editor, files, segments, choose }: Pick<WorkspaceProps, 'editor' | 'files' | 'segments' | 'choose'>) {
  const { history, panel, saved, shelf, sideOpen } = useStore(editor);
  const toggle = (name: EditorState['panel']): void => editor.set({ panel: panel === name ? 'none' : name });
  const rename = (wanted: string): void => {
    const { document } = editor;
    const name = wanted.trim();
    if (name !== '' && name !== document.name) editor.edit('rename', { ...document, name });
  };
  const savedText = { yes: t('saved'), no: t('notSaved'), failed: t('saveFailed') }[saved];
  return (
    <header class="top">
      <button type="button" class="bare brand" title={t('new')} onClick={() => editor.set({ open: false })}>{t('title')}</button>
      <NameField key={shelf?.id ?? ''} kind="document-name" label={t('documentName')} name={history.document.name} most={80} rename={rename} />
      <span class={`saved ${saved}`} title={savedText}><span class="hidden">{savedText}</span></span>
      <span class="gap" />
      <button type="button" class="bare" id="undo" disabled={history.done.length === 0} title={`${t('undo')} (Ctrl Z)`} aria-label={t('undo')} onClick={() => segments.forgetWishes() || editor.undo()}><Icon name="undo" /></button>
      <button type="button" class="bare" id="redo" disabled={history.undone.length === 0} title={`${t('redo')} (Ctrl ⇧ Z)`} aria-label={t('redo')} onClick={() => editor.redo()}><Icon name="redo" /></button>
      <span class="gap" />
      <button type="button" id="side" class="narrow-only" aria-expanded={sideOpen} onClick={() => editor.set({ sideOpen: !sideOpen })}>{t('parts')}</button>
      <button type="button" id="versions" aria-expanded={panel === 'versions'} onClick={() => toggle('versions')}>{t('versions')}</button>
      <button type="button" id="tour" onClick={() => void files.openTour()}>{t('tour')}</button>
      <button type="button" id="keys" aria-expanded={panel === 'keys'} onClick={() => toggle('keys')}>{t('keys')}</button>
      <button type="button" aria-expanded={panel === 'settings'} id="settings" onClick={() => toggle('settings')}>{t('settings')}</button>
      <button type="button" onClick={choose}>{t('open')}</button>
      <button type="button" id="save" onClick={() => void files.saveProject()}>{t('save')}</button>
      <button type="button" class="primary" id="export" aria-expanded={panel === 'export'} onClick={() => toggle('export')}>{t('export')}</button>
    </header>
  );
}

function StatusBar({ editor }: { editor: Editor }) {
  const { tool, notice, relief, solid, shown, build, depthTint, showMarks } = useStore(editor);
  const isSeen = relief && shown === (solid && !isFailure(solid) ? solid : relief);
  const hint = tools.find((entry) => entry.name === tool)?.hint ?? 'hintSelect';
  const ms = relief ? Object.values(relief.report.times).reduce((sum, time) => sum + time, 0) : 0;
  return (
    <footer class="status">
      {notice === '' && <span class="hint">{t(hint)}</span>}
      <span class="notice" role="status" aria-live="polite">{notice}</span>
      <label class="check"><input type="checkbox" checked={depthTint} onChange={() => editor.set({ depthTint: !depthTint })} /> {t('depthTint')}</label>
      <label class="check"><input type="checkbox" checked={showMarks} onChange={() => editor.set({ showMarks: !showMarks })} /> {t('marks')}</label>
      <span class="numbers" data-nodes={relief?.report.nodes ?? 0} data-phase={build.phase}>
        {isSeen && t('ready', { nodes: relief.report.nodes.toLocaleString(), ms: Math.round(ms) })}
      </span>
    </footer>
  );
}

interface WorkspaceProps {
  editor: Editor;
  files: FileControl;
  keeper: Keeper;
  segments: SegmentControl;
  held: HeldKeys;
  attachPaper(paper: PaperControl): void;
  choose(): void;
  stop(): void;
}

export function Workspace({ editor, files, keeper, segments, held, attachPaper, choose, stop }: WorkspaceProps) {
  const { panel, pane, sideOpen, reading } = useStore(editor);
  const paper = useRef<PaperControl | null>(null);
  const model = useRef<ModelView | null>(null);
  const hands = useMemo(
    () => makeTools(editor, hostOf(editor, () => paper.current?.reach ?? 12), scribbleHostOf(editor, segments)),
    [],
  );
  const picture = (): Promise<Blob> => model.current?.picture() ?? Promise.reject(new Error('no view'));
  const turntable = async (): Promise<Uint8Array<ArrayBuffer>> => {
    if (!model.current) throw new Error('no view');
    const ground = getComputedStyle(document.documentElement).getPropertyValue('--paper');
    return swayingGif(model.current, ground);
  };
  const attach = (control: PaperControl): void => {
    paper.current = control;
    attachPaper(control);
  };
  return (
    <main class="workspace" data-pane={pane} data-side={sideOpen} aria-busy={reading > 0}>
      <h1 class="hidden">{t('title')}</h1>
      <TopBar editor={editor} files={files} segments={segments} choose={choose} />
      <Toolbar editor={editor} />
      <PaperPane editor={editor} tool={() => hands[editor.state.tool]} attach={attach} />
      <ScribbleBar editor={editor} files={files} />
      <DrawBar editor={editor} />
      <CueBar editor={editor} />
      <PaintBar editor={editor} />
      <DoubtBar editor={editor} segments={segments} />
      <ModelPane editor={editor} tool={() => hands[editor.state.tool]} attach={(view) => (model.current = view)} lightHeld={() => held.light || editor.state.lighting} stop={stop} />
      <aside class="side" aria-label={t('parts')}>
        <h2>{t('parts')}</h2>
        <PartCount editor={editor} segments={segments} />
        <PartList editor={editor} />
        <StrokeList editor={editor} segments={segments} />
        <PartPanel editor={editor} />
      </aside>
      {panel === 'export' && <ExportPanel editor={editor} exports={files.exports} picture={picture} turntable={turntable} />}
      {panel === 'print' && <PrintPanel editor={editor} exports={files.exports} />}
      {panel === 'versions' && <VersionsPanel editor={editor} keeper={keeper} />}
      {panel === 'settings' && <SettingsPanel editor={editor} />}
      {panel === 'keys' && <KeysPanel />}
      <Tour editor={editor} />
      <StatusBar editor={editor} />
    </main>
  );
}
