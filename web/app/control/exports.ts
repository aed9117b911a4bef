import { type Settings, shownContourWidth } from '../../document/document';
import { sceneText } from '../../document/scene_text';
import type { Engine } from '../../engine/engine';
import { type ExportFormat, type FileSettings, isFailure, type MapKind, type OutputFile, type SolidFormat, errorText } from '../../engine/messages';
import { zipped } from '../files/archives';
import type { BuildControl } from './build_control';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { imageDataOf, smallPicture, textureOf } from '../files/pictures';
import { solidOptions } from '../state/print_choice';
import type { SegmentControl } from './segment_control';

/** Returns the message of whatever was thrown. */
export function whyOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Lets the browser download a file. */
export function download(file: OutputFile): void {
  const url = URL.createObjectURL(new Blob([file.bytes]));
  const link = document.createElement('a');
  link.href = url;
  link.download = file.name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

function fileSettings(settings: Settings): FileSettings {
  return { sizeMm: settings.sizeMm, inkWidth: shownContourWidth(settings) };
}

/** Exports a document to files. Errors become notices. */
export class Exports {
  constructor(
    private readonly editor: Editor,
    private readonly engine: Engine,
    private readonly controls: { control: BuildControl; segments: SegmentControl },
  ) {}

  model = async (format: ExportFormat): Promise<void> => {
    await this.exporting(async () => {
      const { document: doc, state } = this.editor;
      const texture = format === 'stl' ? null : textureOf(doc, state.picture);
      const files = await this.engine.encode(format, doc.name, fileSettings(doc.settings), texture);
      if (isFailure(files)) throw new Error(files.error.message);
      const [only, ...others] = files.files;
      if (only && others.length === 0) download(only);
      else download({ name: `${doc.name}-${format}.zip`, bytes: await zipped(files.files) });
    });
  };

  solid = async (format: SolidFormat): Promise<void> => {
    await this.exporting(async () => {
      const { document: doc, state } = this.editor;
      const options = { ...solidOptions(state.print, doc.settings.sizeMm), inkWidth: shownContourWidth(doc.settings) };
      const files = await this.engine.encodeSolid(format, doc.name, options, textureOf(doc, state.picture));
      if (isFailure(files)) throw new Error(errorText(files.error));
      const [only] = files.files;
      if (format === '3mf') download({ name: `${doc.name}.3mf`, bytes: await zipped(files.files) });
      else if (only) download(only);
    });
  };

  map = async (kind: MapKind, greenDown: boolean): Promise<void> => {
    await this.exporting(async () => {
      const map = await this.engine.map(kind, 2048, greenDown);
      if (isFailure(map)) throw new Error(map.error.message);
      download({ name: `${this.editor.document.name}-${kind}.png`, bytes: map.bytes as Uint8Array<ArrayBuffer> });
    });
  };

  /**
   * Returns the drawing and its normal map at the same size, at most `side` px. Returns null after a notice if
   * there is no relief.
   */
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

  /** Exports the parts as layers. This needs no relief, so it works for drawings that cannot be built. */
  layers = async (): Promise<void> => {
    await this.failing(async () => {
      await this.controls.segments.settle();
      const { document: doc, state } = this.editor;
      const file = await this.engine.encodeLayers(sceneText(doc), textureOf(doc, state.picture));
      if (isFailure(file)) throw new Error(errorText(file.error));
      download({ name: `${doc.name}.psd`, bytes: file.bytes as Uint8Array<ArrayBuffer> });
    });
  };

  picture = async (picture: Promise<Blob>): Promise<void> => {
    const bytes = new Uint8Array(await (await picture).arrayBuffer());
    download({ name: `${this.editor.document.name}-view.png`, bytes });
  };

  turntable = async (record: () => Promise<Uint8Array<ArrayBuffer>>): Promise<void> => {
    await this.exporting(async () => {
      this.editor.set({ notice: t('recording') });
      const bytes = await record();
      download({ name: `${this.editor.document.name}-turntable.gif`, bytes });
      this.editor.set({ notice: '' });
    });
  };

  /** Runs an export once the relief is up to date. */
  private exporting(work: () => Promise<void>): Promise<void> {
    return this.failing(async () => {
      await this.controls.segments.settle();
      await this.controls.control.settle();
      await work();
    });
  }

  /** Runs an export and shows the reason if it fails. */
  private async failing(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.editor.set({ notice: `${t('failed')}: ${whyOf(error)}` });
    }
  }
}
