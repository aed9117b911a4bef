import type { Document, Point, Ring } from './document';
import { distanceTo, rounded } from './outline';
import { partAt } from './picking';
import { sceneContent, sceneText } from './scene_text';
import { emptySegmentation, freshLabel, labelOf, recordFrom, recordText, type Scribbles, type Segmentation, type Stroke } from './segmentation';

/** The edits of strokes. Each takes a document and returns a new one. Strokes stay editable. */

/** Returns whether strokes can mark parts: the drawing is flat and its parts did not come from elsewhere. */
export function canScribble(document: Document): boolean {
  return document.drawing?.kind === 'image' && (document.segmentation !== null || document.parts.length === 0);
}

export function segmentationOf(document: Document): Segmentation {
  return document.segmentation ?? emptySegmentation();
}

export function scribblesOf(document: Document): Scribbles {
  return segmentationOf(document).scribbles;
}

/** Returns the label of a stroke's part, or undefined for strokes of the background. */
export function labelOfStroke(document: Document, { part }: Pick<Stroke, 'part'>): number | undefined {
  return part === undefined ? undefined : labelOf(segmentationOf(document), part);
}

/** Returns the strokes within `reach` px of a point, the last one first. */
export function strokesNear(scribbles: Scribbles, point: Point, reach: number): Stroke[] {
  return scribbles.strokes.filter((stroke) => distanceTo(stroke.points, point) < reach + stroke.width / 2).reverse();
}

export function strokeAt(scribbles: Scribbles, point: Point, reach: number): Stroke | undefined {
  return strokesNear(scribbles, point, reach)[0];
}

/** Returns the segmented part that is visible at a point, or undefined if there is none or it was drawn by hand. */
export function foundPartAt(document: Document, point: Point): string | undefined {
  const id = partAt(document, point)?.id;
  return id !== undefined && labelOf(segmentationOf(document), id) !== undefined ? id : undefined;
}

/** Returns the part without strokes that a line covers most, or null. */
function guessedPartUnder(document: Document, line: Ring): string | null {
  const { strokes } = scribblesOf(document);
  const counts = new Map<string, number>();
  for (const point of line) {
    const id = partAt(document, point)?.id;
    if (id !== undefined) counts.set(id, (counts.get(id) ?? 0) + 1);
  }
  const known = segmentationOf(document).parts;
  const free = [...counts].filter(
    ([id]) => known.some((part) => part.id === id) && !strokes.some((stroke) => stroke.part === id),
  );
  return free.sort((a, b) => b[1] - a[1])[0]?.[0] ?? null;
}

function freshName(document: Document): string {
  const taken = new Set([...document.parts, ...segmentationOf(document).parts].map((part) => part.id));
  let label = freshLabel(segmentationOf(document));
  while (taken.has(`part-${label}`)) label++;
  return `part-${label}`;
}

/**
 * Chooses the part of a stroke that was drawn without naming one: the part of the stroke on which it
 * starts, else the guessed part that it covers most, else a new part.
 */
export function partOfStroke(document: Document, line: Ring, reach: number): string {
  const begun = strokeAt(scribblesOf(document), line[0] as Point, reach);
  return begun?.part ?? guessedPartUnder(document, line) ?? freshName(document);
}

export function withScribbles(document: Document, strokes: readonly Stroke[]): Document {
  const segmentation = segmentationOf(document);
  const parts = [...new Set(strokes.flatMap((stroke) => stroke.part ?? []))];
  return { ...document, segmentation: { ...segmentation, scribbles: { ...segmentation.scribbles, parts, strokes } } };
}

/** Sets the number of parts that the drawing shall have. */
export function withCount(document: Document, count: number): Document {
  const segmentation = segmentationOf(document);
  return { ...document, segmentation: { ...segmentation, scribbles: { ...segmentation.scribbles, count } } };
}

/** Adds a stroke, and its part if that is new. */
export function addStroke(document: Document, stroke: Stroke): Document {
  const added = withScribbles(document, [...scribblesOf(document).strokes, stroke]);
  const segmentation = segmentationOf(added);
  const { part } = stroke;
  if (part === undefined || segmentation.parts.some(({ id }) => id === part)) return added;
  const record = { label: freshLabel(segmentation), id: part, completion: 'whole' };
  return { ...added, segmentation: { ...segmentation, parts: [...segmentation.parts, record] } };
}

function isSameStroke(a: Stroke, b: Stroke): boolean {
  return a.kind === b.kind && a.width === b.width && JSON.stringify(a.points) === JSON.stringify(b.points);
}

/** Removes a stroke. */
export function clearStroke(document: Document, stroke: Stroke): Document {
  const { strokes } = scribblesOf(document);
  const kept = strokes.filter((other) => !isSameStroke(other, stroke));
  return kept.length === strokes.length ? document : withScribbles(document, kept);
}

/** Moves a stroke. Returns the same document if there is no such stroke. */
export function moveStroke(document: Document, moved: Stroke, [dx, dy]: Point): Document {
  const { strokes } = scribblesOf(document);
  const at = strokes.findIndex((stroke) => isSameStroke(stroke, moved));
  if (at < 0 || (dx === 0 && dy === 0)) return document;
  const points = moved.points.map(([x, y]) => rounded([x + dx, y + dy], 10));
  return withScribbles(document, strokes.map((stroke, i) => (i === at ? { ...stroke, points } : stroke)));
}

/** Removes the strokes that a line touches. Returns the same document if there are none. */
export function eraseStrokes(document: Document, line: Ring, reach: number): Document {
  const { strokes } = scribblesOf(document);
  const kept = strokes.filter((stroke) => !line.some((point) => distanceTo(stroke.points, point) < reach + stroke.width / 2));
  return kept.length === strokes.length ? document : withScribbles(document, kept);
}

/** Removes all strokes of a part, or all background strokes of a kind. */
export function clearStrokes(document: Document, of: { part: string } | { kind: 'outside' | 'hole' }): Document {
  const { strokes } = scribblesOf(document);
  const goes = (stroke: Stroke): boolean => ('part' in of ? stroke.part === of.part : stroke.kind === of.kind);
  return strokes.some(goes) ? withScribbles(document, strokes.filter((stroke) => !goes(stroke))) : document;
}

/** The engine's interpretation of strokes and corrections. */
export interface Understood {
  /** Text of a project.json with the record. */
  readonly project: string;
  /** Text of a scene file. */
  readonly scene: string;
  /** A PNG file. */
  readonly labels: Uint8Array;
}

/** Returns `old` if both are equal, so that nothing is built again. */
function unlessSame<T>(found: T, old: T): T {
  return JSON.stringify(found) === JSON.stringify(old) ? old : found;
}

/** Returns what the engine needs to interpret a drawing: the record of its segmentation and the edited scene. */
export function questionOf(document: Document): { project: string; labels: Uint8Array; edited: string } {
  const segmentation = segmentationOf(document);
  const edited = document.parts.length === 0 ? '' : sceneText(document);
  return { project: recordText(segmentation), labels: segmentation.labels, edited };
}

const nothing = { parts: [], joins: [], relations: [], robin: [], cues: [] };

/** Updates a document with the engine's answer to questionOf. Parts drawn by hand stay as they are. */
export function adopt(document: Document, understood: Understood): Document {
  const found = understood.scene === '' ? nothing : sceneContent(understood.scene);
  const named = new Set(segmentationOf(document).parts.map((part) => part.id));
  const drawn = new Map(document.parts.filter(({ id }) => !named.has(id)).map((part) => [part.id, part]));
  return {
    ...document,
    parts: unlessSame(found.parts.map((part) => drawn.get(part.id) ?? part), document.parts),
    joins: unlessSame(found.joins, document.joins),
    relations: unlessSame(found.relations, document.relations),
    robin: unlessSame(found.robin, document.robin),
    cues: unlessSame(found.cues, document.cues),
    segmentation: { ...recordFrom(understood.project), labels: understood.labels },
  };
}
