import { strFromU8, strToU8, zipSync } from 'fflate';
import { ArchiveTooLarge, unpackArchive } from './archive';
import { defaultSettings, type Document, type DrawingSource, type PaintStroke, type Settings } from './document';
import { soundPaint } from './paint';
import { sceneContent, sceneText } from './scene_text';
import { isOwnPicture, recordOf, type Segmentation, type SegmentationRecord } from './segmentation';

/** A project that cannot be opened, in words for a person. */
export class ProjectError extends Error {}

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
 * The project as a zip: scene.json is a scene file whose drawing is the picture beside it, the
 * artist's own file lies in `drawing`, untouched. The same document gives the same bytes. `picture`
 * is not there where the drawing itself is the picture.
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
  if (!bytes) throw new ProjectError('This is no Relievo project: it has no project.json.');
  const head = JSON.parse(strFromU8(bytes)) as Partial<ProjectHead>;
  if (head.format !== 'relievo-project' || typeof head.version !== 'number')
    throw new ProjectError('This is no Relievo project.');
  if (head.version > version) throw new ProjectError('The project was made by a newer version.');
  return head as ProjectHead;
}

/** The settings that are numbers and words of the kinds that they must be. */
function soundSettings(settings: Partial<Settings> | undefined): Settings {
  const sound: Record<string, unknown> = { ...defaultSettings };
  for (const [key, usual] of Object.entries(defaultSettings)) {
    const value = settings?.[key as keyof Settings];
    if (typeof value === typeof usual && (typeof value !== 'number' || Number.isFinite(value))) sound[key] = value;
  }
  if (!/^#[0-9a-f]{6}$/i.test(String(sound['inkColor']))) sound['inkColor'] = defaultSettings.inkColor;
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
 * Reads what writeProject or the command line wrote. Throws ProjectError. The engine still has to
 * accept the scene and the segmentation.
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
    if (error instanceof ArchiveTooLarge) throw new ProjectError('The project is larger than 256 MB.');
    throw new ProjectError('The project file is damaged.');
  }
}
