import { render } from 'preact';
import coreUrl from '#core.wasm?url';
import { Autosave } from '../document/autosave';
import type { Document } from '../document/document';
import { compileCore, Engine } from '../engine/engine';
import { BuildControl } from './build_control';
import { language } from './catalogue';
import { filesOf, givenFiles } from './dropped_files';
import { Editor } from './editor';
import { Files } from './files';
import type { PaperControl } from './paper_pane';
import { SegmentControl } from './segment_control';
import { type HeldKeys, listenToKeys } from './shortcuts';
import { StartScreen } from './start_screen';
import { useStore } from './store';
import './styles.css';
import { Workspace } from './workspace';

interface PageProps {
  editor: Editor;
  files: Files;
  segments: SegmentControl;
  held: HeldKeys;
  kept: Document | null;
  attachPaper(paper: PaperControl): void;
  choose(): void;
  stop(): void;
}

function Page({ editor, files, segments, held, kept, attachPaper, choose, stop }: PageProps) {
  const { open, notice } = useStore(editor);
  if (open) return <Workspace editor={editor} files={files} segments={segments} held={held} attachPaper={attachPaper} choose={choose} stop={stop} />;
  return (
    <>
      <StartScreen files={files} kept={kept} choose={choose} />
      <p class="start-notice" role="status">{notice}</p>
    </>
  );
}

/** Asks for a file. */
function chooser(files: Files): () => void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.svg,.ora,.png,.jpg,.jpeg,.webp,.relievo,.tsv';
  input.multiple = true;
  input.hidden = true;
  input.addEventListener('change', () => {
    void files.openAll(givenFiles([...(input.files ?? [])]));
    input.value = '';
  });
  document.body.append(input);
  return () => input.click();
}

/** Files and folders may be dropped or pasted anywhere. */
function listenToDrops(files: Files): void {
  const open = (data: DataTransfer | null): void => {
    if (data) void filesOf(data).then((given) => files.openAll(given));
  };
  window.addEventListener('dragover', (event) => event.preventDefault());
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    open(event.dataTransfer);
  });
  window.addEventListener('paste', (event) => open(event.clipboardData));
}

async function openStorage(): Promise<{ autosave: Autosave | null; kept: Document | null }> {
  try {
    const autosave = await Autosave.open();
    void navigator.storage?.persist?.();
    return { autosave, kept: await autosave.restore() };
  } catch {
    return { autosave: null, kept: null };
  }
}

async function main(): Promise<void> {
  document.documentElement.lang = language;
  const compiled = compileCore(coreUrl);
  const editor = new Editor();
  const full = new Engine(compiled);
  const control = new BuildControl(editor, new Engine(compiled), full);
  const { autosave, kept } = await openStorage();
  const segments = new SegmentControl(editor, () => new Engine(compiled));
  const files = new Files(editor, full, { control, segments }, autosave);
  const choose = chooser(files);
  let paper: PaperControl | null = null;
  const held = listenToKeys({ editor, files, segments, paper: () => paper, choose });
  listenToDrops(files);
  const attachPaper = (control_: PaperControl): void => {
    paper = control_;
  };
  render(
    <Page editor={editor} files={files} segments={segments} held={held} kept={kept} attachPaper={attachPaper} choose={choose} stop={() => control.stop()} />,
    document.getElementById('page') as HTMLElement,
  );
  if (import.meta.env.PROD && 'serviceWorker' in navigator) void navigator.serviceWorker.register('./service_worker.js');
}

void main();
