import type { Cue, Point, RelationKind, Ring } from './scene';

/** How a flat drawing was understood, as docs/project.md has it. Parts are named by their labels. */

export type StrokeKind = 'soft' | 'hard' | 'outside' | 'hole';

/** A stroke of a round brush. */
export interface Stroke {
  readonly kind: StrokeKind;
  /** Of soft and hard strokes: one of Scribbles.parts, the id of its part. */
  readonly part?: string;
  /** px, positive. */
  readonly width: number;
  /** A single point is a dot. */
  readonly points: Ring;
}

export interface Scribbles {
  readonly parts: readonly string[];
  readonly strokes: readonly Stroke[];
  /** Whether these parts are all: what no stroke touches goes to them, else it stays as proposed. */
  readonly complete?: boolean;
  /** So many parts are proposed; as many as are found where it is not there. */
  readonly count?: number;
}

interface LabelledPart {
  readonly label: number;
  readonly id: string;
  readonly completion: string;
}

export interface LabelPair {
  readonly upper: number;
  readonly lower: number;
}

/** Returns whether two pairs are of the same parts, whichever of them is nearer. */
export function samePair<Name extends string | number>(a: { upper: Name; lower: Name }, b: { upper: Name; lower: Name }): boolean {
  return (a.upper === b.upper && a.lower === b.lower) || (a.upper === b.lower && a.lower === b.upper);
}

export interface PartCorrection {
  readonly label: number;
  readonly id?: string;
  readonly outline?: readonly Ring[];
  readonly c?: number;
  readonly d?: number;
  readonly flat?: number;
  readonly lean?: Point;
}

/** What a person said, never overruled. */
export interface Corrections {
  readonly parts: readonly PartCorrection[];
  readonly order: readonly LabelPair[];
  readonly joins: readonly (LabelPair & { readonly line: Ring })[];
  readonly no_joins: readonly LabelPair[];
  readonly relations: readonly (LabelPair & { readonly relation: RelationKind; readonly range?: readonly [Point, Point] })[];
  readonly robin: readonly (LabelPair & {
    readonly from: Point;
    readonly to: Point;
    readonly alpha0?: number;
    readonly rho?: number;
  })[];
  readonly cues?: readonly (Omit<Cue, 'part'> & { readonly part: number })[];
}

/** What project.json says of it. */
export interface SegmentationRecord {
  /** Back to front. */
  readonly parts: readonly LabelledPart[];
  readonly order: readonly (LabelPair & { readonly confidence: number; readonly user: boolean; readonly kept: boolean })[];
  readonly joins: readonly (LabelPair & { readonly confidence: number })[];
  readonly scribbles: Scribbles;
  readonly corrections: Corrections;
}

export interface Segmentation extends SegmentationRecord {
  /** A PNG file: the label of every pixel of the drawing; empty before anything is known. */
  readonly labels: Uint8Array;
}

export function emptySegmentation(): Segmentation {
  return {
    parts: [],
    order: [],
    joins: [],
    scribbles: { parts: [], strokes: [] },
    corrections: { parts: [], order: [], joins: [], no_joins: [], relations: [], robin: [] },
    labels: new Uint8Array(),
  };
}

/** Whether the drawing itself is the picture that covers the canvas: what was segmented does. */
export function isOwnPicture(segmentation: Segmentation | null): boolean {
  return segmentation !== null && segmentation.labels.length > 0;
}

/** The record, keys in the order of the file. */
export function recordOf({ parts, order, joins, scribbles, corrections }: SegmentationRecord): SegmentationRecord {
  return { parts, order, joins, scribbles, corrections };
}

/** The text of a project.json with nothing but the record: what the engine reads and writes. */
export function recordText(record: SegmentationRecord): string {
  return JSON.stringify({
    format: 'relievo-project',
    version: 1,
    name: '',
    drawing: null,
    segmentation: recordOf(record),
  });
}

/** Reads a record back. Precondition: the engine wrote or accepted the text. */
export function recordFrom(text: string): SegmentationRecord {
  const { segmentation } = JSON.parse(text) as { segmentation: SegmentationRecord };
  return recordOf(segmentation);
}

export function labelOf(record: SegmentationRecord, id: string): number | undefined {
  return record.parts.find((part) => part.id === id)?.label;
}

/** A part under another name, wherever the segmentation speaks of it. */
export function renameLabelled(segmentation: Segmentation, id: string, name: string): Segmentation {
  const label = labelOf(segmentation, id);
  if (label === undefined) return segmentation;
  const { scribbles, corrections } = segmentation;
  const said = corrections.parts.find((part) => part.label === label);
  const others = corrections.parts.filter((part) => part.label !== label);
  return {
    ...segmentation,
    parts: segmentation.parts.map((part) => (part.label === label ? { ...part, id: name } : part)),
    scribbles: {
      ...scribbles,
      parts: scribbles.parts.map((part) => (part === id ? name : part)),
      strokes: scribbles.strokes.map((stroke) => (stroke.part === id ? { ...stroke, part: name } : stroke)),
    },
    corrections: {
      ...corrections,
      parts: [...others, { ...said, label, id: name }].sort((a, b) => a.label - b.label),
    },
  };
}

/** A label that no part has had. */
export function freshLabel(record: SegmentationRecord): number {
  return 1 + Math.max(0, ...record.parts.map((part) => part.label));
}
