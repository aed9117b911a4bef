import { strFromU8, strToU8, zipSync } from 'fflate';
import { ArchiveTooLarge, unpackArchive } from './archive';
import { defaultSettings, type Document, type DrawingSource, type PaintStroke, type Settings } from './document';
import { soundPaint } from './paint';
import { sceneContent, sceneText } from './scene_text';
import { isOwnPicture, recordOf, type Segmentation, type SegmentationRecord } from './segmentation';

/** The reasons why a project cannot be opened. */
export type ProjectTrouble = 'notProject' | 'newerProject' | 'tooLarge' | 'damagedFile';

export class ProjectError extends Error {
  constructor(readonly trouble: ProjectTrouble) {
    super(trouble);
  }
}

const mimetype = 'application/vnd.relievo';
const version = 1;
const entries = ['mimetype', 'project.json', 'scene.json', 'drawing', 'drawing.png', 'labels.png'];

interface ProjectHead {
  format: 'relievo-project';
  version: number;
  name: string;
  settings: Settings;
  drawing: Omit<DrawingSource, 'bytes' | 'paintable'> | null;
  colors: Record<string, string>;
  paint?: readonly PaintStroke[];
  segmentation?: SegmentationRecord;
}

/**
 * Returns a project file, a zip archive (docs/project.md). Its scene.json is a scene file whose drawing
 * is the picture beside it; `drawing` is the artist's unchanged file. `picture` is a PNG file, or null
 * if the drawing itself is the picture. The same document gives the same bytes.
 */
export function writeProject(document: Document, picture: Uint8Array | null): Uint8Array<ArrayBuffer> {
  const labels = isOwnPicture(document.segmentation) ? document.segmentation?.labels : undefined;
  const head: ProjectHead = {
    format: 'relievo-project',
    version,
    name: document.name,
    settings: document.settings,
    drawing: document.drawing && {
      name: document.drawing.name,
      kind: document.drawing.kind,
      mime: document.drawing.mime,
    },
    colors: Object.fromEntries(
      document.parts.filter((part) => part.color).map((part) => [part.id, part.color as string]),
    ),
    ...(document.paint.length > 0 ? { paint: document.paint } : {}),
    ...(labels ? { segmentation: recordOf(document.segmentation as Segmentation) } : {}),
  };
  const stored = { level: 0 as const, mtime: '1980-01-01T00:00:00' };
  const packed = { level: 6 as const, mtime: '1980-01-01T00:00:00' };
  return zipSync({
    mimetype: [strToU8(mimetype), stored],
    'project.json': [strToU8(JSON.stringify(head)), packed],
    'scene.json': [strToU8(sceneText(document, picture ? 'drawing.png' : labels ? 'drawing' : undefined)), packed],
    ...(document.drawing ? { drawing: [document.drawing.bytes, packed] } : {}),
    ...(picture ? { 'drawing.png': [picture, stored] } : {}),
    ...(labels ? { 'labels.png': [labels, stored] } : {}),
  });
}

function parseHead(bytes: Uint8Array | undefined): ProjectHead {
  if (!bytes) throw new ProjectError('notProject');
  const head = JSON.parse(strFromU8(bytes)) as Partial<ProjectHead>;
  if (head.format !== 'relievo-project' || typeof head.version !== 'number') throw new ProjectError('notProject');
  if (head.version > version) throw new ProjectError('newerProject');
  return head as ProjectHead;
}

/** Returns the valid settings of a file, with defaults in place of the others. */
function soundSettings(settings: Partial<Settings> | undefined): Settings {
  const sound: Record<string, unknown> = { ...defaultSettings };
  for (const [key, usual] of Object.entries(defaultSettings)) {
    const value = settings?.[key as keyof Settings];
    if (typeof value === typeof usual && (typeof value !== 'number' || Number.isFinite(value))) sound[key] = value;
  }
  if (!/^#[0-9a-f]{6}$/i.test(String(sound['inkColor']))) sound['inkColor'] = defaultSettings.inkColor;
  if (Number(sound['contourWidth']) < 0.25 || Number(sound['contourWidth']) > 3) sound['contourWidth'] = defaultSettings.contourWidth;
  if (sound['method'] !== 'nonlinear') sound['method'] = 'approximate';
  return sound as unknown as Settings;
}

function drawingOf(head: ProjectHead, files: Record<string, Uint8Array>): DrawingSource | null {
  const bytes = files['drawing'];
  if (!head.drawing || !bytes) return null;
  const { name, kind, mime } = head.drawing;
  return {
    name: String(name),
    kind: kind === 'svg' ? 'svg' : 'image',
    mime: String(mime),
    bytes,
  };
}

function segmentationOf(head: ProjectHead, files: Record<string, Uint8Array>): Segmentation | null {
  const labels = files['labels.png'];
  return head.segmentation && labels ? { ...head.segmentation, labels } : null;
}

/**
 * Reads a project file of writeProject or of the command line. Throws ProjectError. The engine still
 * has to check the scene and the segmentation.
 */
export function readProject(bytes: Uint8Array): Document {
  try {
    const files = unpackArchive(bytes, (name) => entries.includes(name));
    const head = parseHead(files['project.json']);
    const scene = sceneContent(strFromU8(files['scene.json'] ?? new Uint8Array()));
    return {
      name: String(head.name),
      drawing: drawingOf(head, files),
      segmentation: segmentationOf(head, files),
      settings: soundSettings(head.settings),
      paint: soundPaint(head.paint),
      ...scene,
      parts: scene.parts.map((part) => {
        const color = head.colors?.[part.id];
        return color && /^#[0-9a-f]{6}$/i.test(color) ? { ...part, color } : part;
      }),
    };
  } catch (error) {
    if (error instanceof ProjectError) throw error;
    if (error instanceof ArchiveTooLarge) throw new ProjectError('tooLarge');
    throw new ProjectError('damagedFile');
  }
}
