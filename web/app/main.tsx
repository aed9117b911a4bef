import { render } from 'preact';
import coreUrl from '#core.wasm?url';
import networkUrl from '#network.bin?url';
import { Shelf } from '../document/shelf';
import { compileCore, Engine, loadOnce } from '../engine/engine';
import { BuildControl } from './control/build_control';
import { DressControl } from './control/dress_control';
import { speak, visitorsLanguage } from '../words/catalogue';
import { filesOf, givenFiles } from './files/dropped_files';
import { Editor } from './state/editor';
import { FileControl } from './control/file_control';
import { Keeper } from './control/keeper';
import type { PaperControl } from './panes/paper_pane';
import { PrintControl } from './control/print_control';
import { SegmentControl } from './control/segment_control';
import { type HeldKeys, listenToKeys } from './shell/shortcuts';
import { Alerts } from './shell/alerts';
import { StartScreen } from './shell/start_screen';
import { useStore } from './state/store';
import './styles.css';
import { Workspace } from './shell/workspace';

interface PageProps {
  editor: Editor;
  files: FileControl;
  segments: SegmentControl;
  held: HeldKeys;
  keeper: Keeper;
  attachPaper(paper: PaperControl): void;
  choose(): void;
  stop(): void;
}

function Page({ editor, files, segments, held, keeper, attachPaper, choose, stop }: PageProps) {
  const { open, notice } = useStore(editor);
  return (
    <>
      {open ? (
        <Workspace editor={editor} files={files} keeper={keeper} segments={segments} held={held} attachPaper={attachPaper} choose={choose} stop={stop} />
      ) : (
        <>
          <StartScreen files={files} keeper={keeper} choose={choose} />
          <p class="start-notice" role="status">{notice}</p>
        </>
      )}
      <Alerts editor={editor} files={files} keeper={keeper} />
    </>
  );
}

/** Returns a function that asks the user for files and opens them. */
function chooser(files: FileControl): () => void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.svg,.ora,.psd,.png,.jpg,.jpeg,.gif,.bmp,.webp,.avif,.heic,.heif,.relievo,.json,.tsv';
  input.multiple = true;
  input.hidden = true;
  input.addEventListener('change', () => {
    void files.openAll(givenFiles([...(input.files ?? [])]));
    input.value = '';
  });
  document.body.append(input);
  return () => input.click();
}

/** Opens files and folders that are dropped or pasted anywhere on the page. */
function listenToDrops(files: FileControl): void {
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

/** Opens the shelf. Returns null if the browser refuses storage. */
async function openShelf(): Promise<Shelf | null> {
  try {
    const shelf = await Shelf.open();
    void navigator.storage?.persist?.();
    return shelf;
  } catch {
    return null;
  }
}

async function main(): Promise<void> {
  const compiled = compileCore(coreUrl);
  await speak(visitorsLanguage());
  const editor = new Editor();
  const full = new Engine(compiled);
  const control = new BuildControl(editor, new Engine(compiled), full);
  new DressControl(editor, full, control);
  new PrintControl(editor, full, control);
  const keeper = new Keeper(editor, await openShelf());
  const segments = new SegmentControl(editor, () => new Engine(compiled), loadOnce(networkUrl));
  const files = new FileControl(editor, full, { control, segments }, keeper);
  const choose = chooser(files);
  let paper: PaperControl | null = null;
  const held = listenToKeys({ editor, files, segments, paper: () => paper, choose });
  listenToDrops(files);
  const attachPaper = (control_: PaperControl): void => {
    paper = control_;
  };
  render(
    <Page editor={editor} files={files} segments={segments} held={held} keeper={keeper} attachPaper={attachPaper} choose={choose} stop={() => control.stop()} />,
    document.getElementById('page') as HTMLElement,
  );
  if (import.meta.env.PROD && 'serviceWorker' in navigator) void navigator.serviceWorker.register('./service_worker.js');
}

void main();
