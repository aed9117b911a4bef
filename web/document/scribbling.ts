import type { Document, Point, Ring } from './document';
import { distanceTo, rounded } from './outline';
import { partAt } from './picking';
import { sceneContent, sceneText } from './scene_text';
import { emptySegmentation, freshLabel, labelOf, recordFrom, recordText, type Scribbles, type Segmentation, type Stroke } from './segmentation';

/** Every verb of scribbling: a document in, a document out. Strokes stay editable for ever. */

/** Whether strokes can say what the parts are: on a flat drawing, unless others were given to it. */
export function canScribble(document: Document): boolean {
  return document.drawing?.kind === 'image' && (document.segmentation !== null || document.parts.length === 0);
}

export function segmentationOf(document: Document): Segmentation {
  return document.segmentation ?? emptySegmentation();
}

export function scribblesOf(document: Document): Scribbles {
  return segmentationOf(document).scribbles;
}

/** The label of a stroke's part; undefined where it is for the background. */
export function labelOfStroke(document: Document, { part }: Pick<Stroke, 'part'>): number | undefined {
  return part === undefined ? undefined : labelOf(segmentationOf(document), part);
}

/** The strokes at a point, the last one first. */
export function strokesNear(scribbles: Scribbles, point: Point, reach: number): Stroke[] {
  return scribbles.strokes.filter((stroke) => distanceTo(stroke.points, point) < reach + stroke.width / 2).reverse();
}

export function strokeAt(scribbles: Scribbles, point: Point, reach: number): Stroke | undefined {
  return strokesNear(scribbles, point, reach)[0];
}

/** The part of the drawing that is seen at a point; undefined where it is none or drawn by hand. */
export function foundPartAt(document: Document, point: Point): string | undefined {
  const id = partAt(document, point)?.id;
  return id !== undefined && labelOf(segmentationOf(document), id) !== undefined ? id : undefined;
}

/** The part without strokes of which a line covers most, or null. */
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
 * The part that a stroke is for where the person does not say: that of the stroke at which it
 * begins, or the guessed one that it covers, or a new one.
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

/** With another number of parts that the drawing is taken to have. */
export function withCount(document: Document, count: number): Document {
  const segmentation = segmentationOf(document);
  return { ...document, segmentation: { ...segmentation, scribbles: { ...segmentation.scribbles, count } } };
}

/** With another stroke; its part is known by its name from now on. */
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

/** Without one stroke. */
export function clearStroke(document: Document, stroke: Stroke): Document {
  const { strokes } = scribblesOf(document);
  const kept = strokes.filter((other) => !isSameStroke(other, stroke));
  return kept.length === strokes.length ? document : withScribbles(document, kept);
}

/** With a stroke at another place; the same document where it is not there. */
export function moveStroke(document: Document, moved: Stroke, [dx, dy]: Point): Document {
  const { strokes } = scribblesOf(document);
  const at = strokes.findIndex((stroke) => isSameStroke(stroke, moved));
  if (at < 0 || (dx === 0 && dy === 0)) return document;
  const points = moved.points.map(([x, y]) => rounded([x + dx, y + dy], 10));
  return withScribbles(document, strokes.map((stroke, i) => (i === at ? { ...stroke, points } : stroke)));
}

/** Without the strokes that a line touches; the same document where there are none. */
export function eraseStrokes(document: Document, line: Ring, reach: number): Document {
  const { strokes } = scribblesOf(document);
  const kept = strokes.filter((stroke) => !line.some((point) => distanceTo(stroke.points, point) < reach + stroke.width / 2));
  return kept.length === strokes.length ? document : withScribbles(document, kept);
}

/** Without all strokes of a part, or without those of a kind for the background. */
export function clearStrokes(document: Document, of: { part: string } | { kind: 'outside' | 'hole' }): Document {
  const { strokes } = scribblesOf(document);
  const goes = (stroke: Stroke): boolean => ('part' in of ? stroke.part === of.part : stroke.kind === of.kind);
  return strokes.some(goes) ? withScribbles(document, strokes.filter((stroke) => !goes(stroke))) : document;
}

/** What the engine makes of strokes and corrections. */
export interface Understood {
  /** Text of a project.json with the record. */
  readonly project: string;
  /** Text of a scene file. */
  readonly scene: string;
  /** A PNG file. */
  readonly labels: Uint8Array;
}

/** `old` where it says the same, so that nothing is built anew. */
function unlessSame<T>(found: T, old: T): T {
  return JSON.stringify(found) === JSON.stringify(old) ? old : found;
}

/** What the engine is asked to understand: the drawing's record and the scene as it was edited. */
export function questionOf(document: Document): { project: string; labels: Uint8Array; edited: string } {
  const segmentation = segmentationOf(document);
  const edited = document.parts.length === 0 ? '' : sceneText(document);
  return { project: recordText(segmentation), labels: segmentation.labels, edited };
}

const nothing = { parts: [], joins: [], relations: [], robin: [], cues: [] };

/** The document as the engine understands it now; see questionOf. */
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
