import { ArchiveTooLarge, unpackArchive } from '../document/archive';
import { type Document, emptyDocument } from '../document/document';
import { sceneContent } from '../document/scene_text';
import type { Engine } from '../engine/engine';
import { isFailure, type OutputFile, told } from '../engine/messages';
import { t } from './catalogue';

const maxBytes = 256 * 1024 * 1024;

/** What an OpenRaster archive holds besides previews of itself. */
export function entriesOfOra(bytes: Uint8Array): OutputFile[] {
  const wanted = (name: string): boolean => name === 'mimetype' || name === 'stack.xml' || /^data\/.*\.png$/i.test(name);
  try {
    const entries = unpackArchive(bytes, wanted, maxBytes) as Record<string, Uint8Array<ArrayBuffer>>;
    return Object.entries(entries).map(([name, content]) => ({ name, bytes: content }));
  } catch (error) {
    throw new Error(t(error instanceof ArchiveTooLarge ? 'tooLarge' : 'damagedFile'));
  }
}

/** A document of painted layers, and what is to be said of it. Its drawing is the picture that they make. */
export async function documentOfLayers(
  engine: Engine,
  name: string,
  files: OutputFile[],
): Promise<{ document: Document; notice: string }> {
  const imported = await engine.importLayers(files);
  if (isFailure(imported)) throw new Error(told(imported.error));
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
