import { type Document, type DrawingSource, emptyDocument } from '../../document/document';
import { baseName, fileKind, pictureType } from '../../document/file_kind';
import { sceneContent } from '../../document/scene_text';
import { t } from '../../words/catalogue';
import type { PlacedFile } from './dropped_files';

/** Parses what the page needs of a scene file before the engine checks it. */
function contentOf(text: string): ReturnType<typeof sceneContent> & { drawing?: unknown } {
  try {
    const head = JSON.parse(text) as { format?: unknown; drawing?: unknown };
    if (head.format !== 'relievo-scene') throw new Error('another format');
    return { ...sceneContent(text), drawing: head.drawing };
  } catch {
    throw new Error(t('brokenScene'));
  }
}

async function sourceOf({ file }: PlacedFile): Promise<DrawingSource> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isSvg = fileKind(bytes) === 'svg';
  return { name: file.name, kind: isSvg ? 'svg' : 'image', mime: isSvg ? 'image/svg+xml' : (pictureType(bytes) ?? file.type), bytes };
}

/** Makes a document of a scene file and of the drawing given beside it, with a notice for the user. */
export async function documentOfScene(scene: PlacedFile, files: readonly PlacedFile[]): Promise<{ document: Document; notice: string }> {
  const { drawing: path, ...content } = contentOf(await scene.file.text());
  const given = typeof path === 'string' ? files.find((one) => one.path === path || one.path.endsWith(`/${path}`)) : undefined;
  const name = baseName(scene.file.name);
  const missing = typeof path === 'string' && !given;
  return {
    document: { ...emptyDocument(), ...content, name, drawing: given ? await sourceOf(given) : null },
    notice: missing ? t('drawingMissing', { name: path }) : '',
  };
}
