import { type Document, emptyDocument } from '../document/document';
import { fileKind, pictureType } from '../document/file_kind';
import { type History, startHistory } from '../document/history';
import { isOwnPicture } from '../document/segmentation';
import { sceneContent } from '../document/scene_text';
import { adopt } from '../document/scribbling';
import { tourAnimal } from '../document/tour_animal';
import type { Engine } from '../engine/engine';
import { type ExportFormat, isFailure, type MapKind, type OutputFile, type SolidFormat, told } from '../engine/messages';
import { isOverpainted } from '../view/painted_drawing';
import { packProject, unpackOra, unpackProject, zipped } from './archives';
import type { BuildControl } from './build_control';
import { t } from './catalogue';
import type { GivenFiles, PlacedFile } from './dropped_files';
import type { Editor, ShelfPlace } from './editor';
import type { Keeper } from './keeper';
import { documentOfLayers, layersAmong, readLayers } from './layered_drawing';
import { cutOut, flatDrawing, flatOfSvg, imageDataOf, pictureOf, pngOf, smallPicture, textureOf } from './pictures';
import { solidOptions } from './print_choice';
import { documentOfScene } from './scene_files';
import type { SegmentControl } from './segment_control';

function whyOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function baseName(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'untitled';
}

/** Hands a file to the person. */
export function download(file: OutputFile): void {
  const url = URL.createObjectURL(new Blob([file.bytes]));
  const link = document.createElement('a');
  link.href = url;
  link.download = file.name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Opening, keeping, saving and exporting. */
export class Files {
  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly controls: { control: BuildControl; segments: SegmentControl },
    private readonly keeper: Keeper,
  ) {}

  /** Opens a file, or pictures that are the layers of one drawing. */
  async openAll({ name, files }: GivenFiles): Promise<void> {
    const [first] = files;
    const layers = layersAmong(files);
    const scene = files.find(({ path }) => path.endsWith('.json'));
    if (scene) await this.opening(scene.path, async () => this.openScene(scene, files));
    else if (layers) await this.opening(name, async () => this.openLayers(name, await readLayers(layers)));
    else if (first) await this.open(first.file);
  }

  /** Opens whatever a file is; tells why where it cannot be. */
  async open(file: File): Promise<void> {
    await this.opening(file.name, async () => {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const kind = fileKind(bytes);
      if (kind === 'project') await this.openProject(bytes);
      else if (kind === 'svg') await this.openSvg(file.name, bytes);
      else if (kind === 'openraster') await this.openLayers(file.name, await unpackOra(bytes));
      else if (kind === 'photoshop') await this.openLayers(file.name, [{ name: file.name, bytes }]);
      else if (kind === 'picture') await this.openImage(file.name, bytes, pictureType(bytes) ?? '');
      else if (kind === 'scene') await this.openScene({ path: file.name, file }, []);
      else throw new Error(t(kind === 'model' ? 'finishedModel' : kind === 'packed' ? 'packedFile' : 'unknownFile'));
    });
  }

  /** Goes on with what a mask says is the figure of the flat drawing that is open. */
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

  /** A scene file, with its drawing where that was given with it. */
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

  /** Begins anew with an empty page. */
  openEmpty(): Promise<void> {
    return this.show({ ...emptyDocument(), name: t('untitled') }, 'changes');
  }

  /** Begins the tour, on a drawing of its own. */
  async openTour(): Promise<void> {
    await this.show(tourAnimal(t('tour')), 'changes');
    this.editor.set({ tool: 'draw', tourStep: 0, pane: 'paper' });
  }

  /** Goes on with a document of the shelf; asks where another tab has it, unless it is to be taken over. */
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

  /** A document of the shelf once more, with all its undo; the other stays as it is. */
  async openCopy(id: string): Promise<void> {
    await this.opening((await this.keeper.entry(id))?.name ?? '', async () => {
      const history = await this.keeper.read(id);
      const name = t('copyOf', { name: history.document.name });
      await this.showHistory({ ...history, document: { ...history.document, name } }, { id: crypto.randomUUID(), keep: 'all' });
    });
  }

  /** Shows a document that comes from a file; nothing that was open is lost. */
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

  exportModel = async (format: ExportFormat): Promise<void> => {
    await this.exporting(async () => {
      const { document: doc, state } = this.editor;
      const texture = format === 'stl' ? null : textureOf(doc, state.picture);
      const files = await this.engine.encode(format, doc.name, doc.settings.sizeMm, texture);
      if (isFailure(files)) throw new Error(files.error.message);
      const [only, ...others] = files.files;
      if (only && others.length === 0) download(only);
      else download({ name: `${doc.name}-${format}.zip`, bytes: await zipped(files.files) });
    });
  };

  exportSolid = async (format: SolidFormat): Promise<void> => {
    await this.exporting(async () => {
      const { document: doc, state } = this.editor;
      const options = solidOptions(state.print, doc.settings.sizeMm);
      const files = await this.engine.encodeSolid(format, doc.name, options, textureOf(doc, state.picture));
      if (isFailure(files)) throw new Error(told(files.error));
      const [only] = files.files;
      if (format === '3mf') download({ name: `${doc.name}.3mf`, bytes: await zipped(files.files) });
      else if (only) download(only);
    });
  };

  exportMap = async (kind: MapKind, greenDown: boolean): Promise<void> => {
    await this.exporting(async () => {
      const map = await this.engine.map(kind, 2048, greenDown);
      if (isFailure(map)) throw new Error(map.error.message);
      download({ name: `${this.editor.document.name}-${kind}.png`, bytes: map.bytes as Uint8Array<ArrayBuffer> });
    });
  };

  /** The drawing and its normal map at the same size, `side` px at most; null, and the reason told, where there is none. */
  mapPixels = async (side: number): Promise<{ drawing: ImageData; normals: ImageData } | null> => {
    let found: { drawing: ImageData; normals: ImageData } | null = null;
    await this.exporting(async () => {
      const map = await this.engine.map('normal', side, false);
      if (isFailure(map)) throw new Error(map.error.message);
      const normals = await createImageBitmap(new Blob([map.bytes as Uint8Array<ArrayBuffer>], { type: 'image/png' }), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
      const { document: doc, state } = this.editor;
      const picture = await smallPicture(doc, state.picture, side);
      found = { drawing: imageDataOf(picture, normals), normals: imageDataOf(normals, normals) };
    });
    return found;
  };

  exportPicture = async (picture: Promise<Blob>): Promise<void> => {
    const bytes = new Uint8Array(await (await picture).arrayBuffer());
    download({ name: `${this.editor.document.name}-view.png`, bytes });
  };

  exportTurntable = async (record: () => Promise<Uint8Array<ArrayBuffer>>): Promise<void> => {
    await this.exporting(async () => {
      this.editor.set({ notice: t('recording') });
      const bytes = await record();
      download({ name: `${this.editor.document.name}-turntable.gif`, bytes });
      this.editor.set({ notice: '' });
    });
  };

  private async openLayers(name: string, entries: OutputFile[]): Promise<void> {
    const opened = await documentOfLayers(this.engine, baseName(name), entries);
    if ('flat' in opened) return this.openImage(`${baseName(name)}.png`, opened.flat, 'image/png');
    await this.show(opened.document, 'all');
    this.editor.set({ notice: opened.notice });
  }

  private async opening(name: string, work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.editor.set({ notice: t('notReadable', { name, why: whyOf(error) }) });
    }
  }

  private async exporting(work: () => Promise<void>): Promise<void> {
    try {
      await this.controls.segments.settle();
      await this.controls.control.settle();
      await work();
    } catch (error) {
      this.editor.set({ notice: `${t('failed')}: ${whyOf(error)}` });
    }
  }

  private async openSvg(name: string, bytes: Uint8Array, keep: ShelfPlace['keep'] = 'all'): Promise<void> {
    const imported = await this.engine.importSvg(bytes);
    if (isFailure(imported)) throw new Error(imported.error.message);
    const content = sceneContent(imported.scene);
    if (imported.lineArt || (imported.proposed && content.parts.length < 2)) {
      // Lines, or one shape: its parts are found as those of a flat picture.
      const flat = await flatOfSvg(imported.paintable, content.width, content.height);
      await this.openImage(`${baseName(name)}.png`, flat, 'image/png');
      return;
    }
    await this.show({
      ...emptyDocument(),
      ...content,
      name: baseName(name),
      drawing: { name, kind: 'svg', mime: 'image/svg+xml', bytes, paintable: imported.paintable },
    }, keep);
    const words = imported.proposed ? [t('proposedParts')] : [];
    this.editor.set({ notice: [...words, ...imported.warnings].join(' ') });
  }

  /** A project holds the artist's file as it came: what may be painted of it is found anew. */
  private async withPaintable(next: Document): Promise<Document> {
    const { drawing } = next;
    if (drawing?.kind !== 'svg' || drawing.paintable !== undefined) return next;
    const imported = await this.engine.importSvg(drawing.bytes);
    if (isFailure(imported)) throw new Error(imported.error.message);
    return { ...next, drawing: { ...drawing, paintable: imported.paintable } };
  }

  /** The canvas of a flat drawing is its pixels. */
  private async openImage(name: string, bytes: Uint8Array, mime: string): Promise<void> {
    const { drawing, picture } = await flatDrawing({ name, kind: 'image', mime, bytes });
    const { width, height } = picture;
    const next: Document = { ...emptyDocument(), name: baseName(name), width, height, drawing };
    this.editor.openDocument(startHistory(next), picture, { id: crypto.randomUUID(), keep: 'all' });
    this.editor.set({ tool: 'draw', notice: t('guessing') });
    await this.guessParts(next);
  }

  /** Lets the engine find the parts of a flat drawing; strokes tell them where it cannot. */
  private async guessParts(next: Document): Promise<void> {
    const found = await this.controls.segments.guess(next);
    if (this.editor.document !== next) return;
    if (isFailure(found)) {
      this.editor.set({ tool: 'scribble', notice: `${found.error.message}. ${t('imageHint')}` });
      return;
    }
    this.editor.edit('guess', adopt(next, found));
    this.editor.set({ tool: 'scribble', notice: [t('guessed'), ...found.warnings].join(' ') });
  }
}
