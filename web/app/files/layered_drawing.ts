import { maxArchiveBytes } from '../../document/archive';
import { type Document, emptyDocument } from '../../document/document';
import { sceneContent } from '../../document/scene_text';
import type { Engine } from '../../engine/engine';
import { isFailure, type OutputFile, errorText } from '../../engine/messages';
import { t } from '../../words/catalogue';
import type { PlacedFile } from './dropped_files';

/**
 * Returns the files that are the layers of one drawing: its PNG pictures and, if given, their
 * `layers.tsv`. Returns null if the files are not layers.
 */
export function layersAmong(files: readonly PlacedFile[]): readonly PlacedFile[] | null {
  const table = files.find(({ path }) => path === 'layers.tsv');
  const pictures = files.filter(({ file }) => file.type === 'image/png');
  if (table && pictures.length > 0) return [table, ...pictures];
  return pictures.length > 1 ? pictures : null;
}

export async function readLayers(files: readonly PlacedFile[]): Promise<OutputFile[]> {
  if (files.reduce((sum, { file }) => sum + file.size, 0) > maxArchiveBytes) throw new Error(t('tooLarge'));
  return Promise.all(files.map(async ({ path, file }) => ({ name: path, bytes: new Uint8Array(await file.arrayBuffer()) })));
}

/**
 * Makes a document of painted layers, with a notice for the user. Its drawing is the picture that the
 * layers make together. If the layers are no parts, only that picture is returned, as `flat`.
 */
export async function documentOfLayers(
  engine: Engine,
  name: string,
  files: OutputFile[],
): Promise<{ document: Document; notice: string } | { flat: Uint8Array<ArrayBuffer>; warnings: readonly string[] }> {
  const imported = await engine.importLayers(files);
  if (isFailure(imported)) throw new Error(errorText(imported.error));
  if (imported.scene === undefined) return { flat: imported.drawing, warnings: imported.warnings };
  const words = imported.proposed ? [t('proposedParts')] : [];
  return {
    document: {
      ...emptyDocument(),
      ...sceneContent(imported.scene),
      name,
      drawing: { name: `${name}.png`, kind: 'image', mime: 'image/png', bytes: imported.drawing },
    },
    notice: [...words, ...imported.warnings].join(' '),
  };
}
