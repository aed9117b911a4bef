import { type Document, emptyDocument } from '../../document/document';
import { baseName, fileKind, pictureType } from '../../document/file_kind';
import { type History, startHistory } from '../../document/history';
import { isOwnPicture } from '../../document/segmentation';
import { sceneContent } from '../../document/scene_text';
import { adopt } from '../../document/scribbling';
import { tourAnimal } from '../../document/tour_animal';
import type { Engine } from '../../engine/engine';
import { isFailure, type OutputFile } from '../../engine/messages';
import { isOverpainted } from '../../view/painted_drawing';
import { packProject, unpackOra, unpackProject } from '../files/archives';
import type { BuildControl } from './build_control';
import { t } from '../../words/catalogue';
import type { GivenFiles, PlacedFile } from '../files/dropped_files';
import type { Editor, ShelfPlace } from '../state/editor';
import { download, Exports, whyOf } from './exports';
import type { Keeper } from './keeper';
import { documentOfLayers, layersAmong, readLayers } from '../files/layered_drawing';
import { cutOut, flatDrawing, flatOfSvg, paintingOfSvg, pictureOf, pngOf } from '../files/pictures';
import { documentOfScene } from '../files/scene_files';
import type { SegmentControl } from './segment_control';

/** Opens documents from files, samples and the shelf, and saves projects. */
export class FileControl {
  readonly exports: Exports;

  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly controls: { control: BuildControl; segments: SegmentControl },
    private readonly keeper: Keeper,
  ) {
    this.exports = new Exports(editor, engine, controls);
  }

  /** Opens files that were given together: a scene with its drawing, the layers of one drawing, or the first file. */
  async openAll({ name, files }: GivenFiles): Promise<void> {
    const [first] = files;
    const layers = layersAmong(files);
    const scene = files.find(({ path }) => path.endsWith('.json'));
    if (scene && files.length > 1) await this.opening(scene.path, async () => this.openScene(scene, files));
    else if (layers) await this.opening(name, async () => this.openLayers(name, await readLayers(layers)));
    else if (first) await this.open(first.file);
  }

  /** Opens a file of any kind, by its content. If it cannot be opened, a notice says why. */
  async open(file: File): Promise<void> {
    await this.opening(file.name, async () => {
      const bytes = new Uint8Array(await file.arrayBuffer());
      try {
        await this.openBytes(file, bytes);
      } catch (error) {
        const unread = await this.engine.unreadFile(bytes);
        throw unread ? new Error(t('unreadFile', { ...unread })) : error;
      }
    });
  }

  private async openBytes(file: File, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
    const kind = fileKind(bytes);
    if (kind === 'project') await this.openProject(bytes);
    else if (kind === 'svg') await this.openSvg(file.name, bytes);
    else if (kind === 'openraster') await this.openLayers(file.name, await unpackOra(bytes));
    else if (kind === 'photoshop') await this.openLayers(file.name, [{ name: file.name, bytes }]);
    else if (kind === 'picture') await this.openImage(file.name, bytes, pictureType(bytes) ?? '');
    else if (kind === 'scene') await this.openScene({ path: file.name, file }, []);
    else throw new Error(t('unknownFile'));
  }

  /** Continues with only that area of the open flat drawing that a mask shows as the figure. */
  async cutFigure(file: File): Promise<void> {
    await this.opening(file.name, async () => {
      const { document: doc, state } = this.editor;
      const bytes = new Uint8Array(await file.arrayBuffer());
      const mask = await createImageBitmap(new Blob([bytes], { type: pictureType(bytes) ?? '' }));
      if (!state.picture || mask.width !== doc.width || mask.height !== doc.height)
        throw new Error(t('maskSize', { width: `${doc.width}`, height: `${doc.height}` }));
      await this.openImage(`${doc.name}.png`, await cutOut(state.picture, mask), 'image/png');
    });
  }

  /** Opens a scene file with its drawing, if that was given too. */
  private async openScene(scene: PlacedFile, files: readonly PlacedFile[]): Promise<void> {
    const { document: next, notice } = await documentOfScene(scene, files);
    await this.controls.control.check(next);
    await this.show(next, 'all');
    this.editor.set({ notice });
  }

  private async openProject(bytes: Uint8Array): Promise<void> {
    const project = await unpackProject(bytes);
    await this.controls.segments.check(project);
    await this.show(project, 'all');
  }

  async openSample(name: string, url: string): Promise<void> {
    const answer = await fetch(url);
    await this.openSvg(`${name}.svg`, new Uint8Array(await answer.arrayBuffer()), 'changes');
  }

  /** Starts a new document with an empty page. */
  openEmpty(): Promise<void> {
    return this.show({ ...emptyDocument(), name: t('untitled') }, 'changes');
  }

  /** Starts the tour on its own drawing. */
  async openTour(): Promise<void> {
    await this.show(tourAnimal(t('tour')), 'changes');
    this.editor.set({ tool: 'draw', tourStep: 0, pane: 'paper' });
  }

  /** Opens a document of the shelf. If another tab has it open, the user is asked, unless `over` takes it over. */
  async openKept(id: string, over = false): Promise<void> {
    const { shelf } = this.editor.state;
    if (shelf?.id === id && this.keeper.takenOver !== id) this.editor.set({ open: true, elsewhere: null });
    else
      await this.opening((await this.keeper.entry(id))?.name ?? '', async () => {
        const history = await this.keeper.open(id, over);
        if (history === 'elsewhere') this.editor.set({ elsewhere: id });
        else await this.showHistory(history, { id, keep: 'changes' });
      });
  }

  /** Opens a copy of a document of the shelf, with its undo history. */
  async openCopy(id: string): Promise<void> {
    await this.opening((await this.keeper.entry(id))?.name ?? '', async () => {
      const history = await this.keeper.read(id);
      const name = t('copyOf', { name: history.document.name });
      await this.showHistory({ ...history, document: { ...history.document, name } }, { id: crypto.randomUUID(), keep: 'all' });
    });
  }

  /** Shows a document as a new entry of the shelf. The document that was open stays there. */
  private show(document_: Document, keep: ShelfPlace['keep']): Promise<void> {
    return this.showHistory(startHistory({ ...emptyDocument(), ...document_ }), { id: crypto.randomUUID(), keep });
  }

  private async showHistory(history: History, place: ShelfPlace): Promise<void> {
    const next = await this.withPaintable(history.document);
    const picture = next.drawing && (await pictureOf(next.drawing, next.width, next.height));
    this.editor.openDocument({ ...history, document: next }, picture, place);
    this.editor.set({ tool: next.parts.length === 0 ? 'draw' : 'select', notice: '' });
  }

  saveProject = async (): Promise<void> => {
    await this.controls.segments.settle();
    const { document: doc, state } = this.editor;
    const bytes = await packProject(doc, isOwnPicture(doc.segmentation) && !isOverpainted(doc) ? null : await pngOf(doc, state.picture));
    download({ name: `${doc.name}.relievo`, bytes });
  };

  private async openLayers(name: string, entries: OutputFile[]): Promise<void> {
    const opened = await documentOfLayers(this.engine, baseName(name), entries);
    if ('flat' in opened) return this.openImage(`${baseName(name)}.png`, opened.flat, 'image/png', opened.warnings);
    await this.show(opened.document, 'all');
    this.editor.set({ notice: opened.notice });
  }

  /** Runs the opening of a file, which counts as being read meanwhile. If it fails, a notice says why. */
  private async opening(name: string, work: () => Promise<void>): Promise<void> {
    const read = (files: number): void => this.editor.set({ reading: this.editor.state.reading + files });
    read(1);
    try {
      await work();
    } catch (error) {
      this.editor.set({ notice: t('notReadable', { name, why: whyOf(error) }) });
    } finally {
      read(-1);
    }
  }

  private async openSvg(name: string, bytes: Uint8Array, keep: ShelfPlace['keep'] = 'all'): Promise<void> {
    const imported = await this.engine.importSvg(bytes);
    if (isFailure(imported)) throw new Error(imported.error.message);
    const content = sceneContent(imported.scene);
    const { paintable, lineArt, proposed } = imported;
    const departs = !lineArt && (await this.departsFromPaint(bytes, paintable, content));
    if (lineArt || (proposed && (content.parts.length < 2 || departs))) {
      // A drawing of lines or of a single shape is treated as a flat picture.
      const flat = await flatOfSvg(paintable, content.width, content.height);
      await this.openImage(`${baseName(name)}.png`, flat, 'image/png', departs ? [t('paintedOtherwise')] : []);
      return;
    }
    await this.show({
      ...emptyDocument(),
      ...content,
      name: baseName(name),
      drawing: { name, kind: 'svg', mime: 'image/svg+xml', bytes, paintable },
    }, keep);
    const words = [...(proposed ? [t('proposedParts')] : []), ...(departs ? [t('readOtherwise')] : [])];
    this.editor.set({ notice: [...words, ...imported.warnings].join(' ') });
  }

  /** Tells whether the shapes that were read of an SVG are not those that the browser paints. */
  private async departsFromPaint(bytes: Uint8Array, paintable: string, canvas: { width: number; height: number }): Promise<boolean> {
    const painting = await paintingOfSvg(paintable, canvas.width, canvas.height);
    const compared = await this.engine.departsFromPaint(bytes, painting);
    return !isFailure(compared) && compared.departs;
  }

  /**
   * Adds the paintable version of an SVG drawing, which is never saved: saved files hold the artist's file as
   * it came.
   */
  private async withPaintable(next: Document): Promise<Document> {
    const { drawing } = next;
    if (drawing?.kind !== 'svg' || drawing.paintable !== undefined) return next;
    const imported = await this.engine.importSvg(drawing.bytes);
    if (isFailure(imported)) throw new Error(imported.error.message);
    return { ...next, drawing: { ...drawing, paintable: imported.paintable } };
  }

  /** Opens a flat picture and guesses its parts. The canvas has the size of the picture. `warnings`: of its reader. */
  private async openImage(name: string, bytes: Uint8Array, mime: string, warnings: readonly string[] = []): Promise<void> {
    const { drawing, picture } = await flatDrawing({ name, kind: 'image', mime, bytes });
    const { width, height } = picture;
    const next: Document = { ...emptyDocument(), name: baseName(name), width, height, drawing };
    this.editor.openDocument(startHistory(next), picture, { id: crypto.randomUUID(), keep: 'all' });
    this.editor.set({ tool: 'draw', notice: t('guessing') });
    await this.guessParts(next, warnings);
  }

  /** Lets the engine guess the parts of a flat drawing. If it cannot, the user is asked to scribble. */
  private async guessParts(next: Document, warnings: readonly string[]): Promise<void> {
    const found = await this.controls.segments.guess(next);
    if (this.editor.document !== next) return;
    if (isFailure(found)) {
      this.editor.set({ tool: 'scribble', notice: `${found.error.message}. ${t('imageHint')}` });
      return;
    }
    this.editor.edit('guess', adopt(next, found));
    this.editor.set({ tool: 'scribble', notice: [t('guessed'), ...warnings, ...found.warnings].join(' ') });
  }
}
