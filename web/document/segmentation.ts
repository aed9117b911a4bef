import type { Cue, Point, RelationKind, Ring } from './scene';

/** How a flat drawing was divided into parts (docs/project.md). Parts are identified by their labels. */

export type StrokeKind = 'soft' | 'hard' | 'outside' | 'hole';

/** A stroke of a round brush. */
export interface Stroke {
  readonly kind: StrokeKind;
  /** The id of its part, one of Scribbles.parts; only for soft and hard strokes. */
  readonly part?: string;
  /** px, positive. */
  readonly width: number;
  /** A single point is a dot. */
  readonly points: Ring;
}

export interface Scribbles {
  readonly parts: readonly string[];
  readonly strokes: readonly Stroke[];
  /** Whether there are no other parts: areas without strokes then join these parts, else they stay as proposed. */
  readonly complete?: boolean;
  /** Number of parts to propose; if absent, the engine decides. */
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

/** Decisions of the user, which the engine never overrules. */
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

/** The segmentation as project.json holds it. */
export interface SegmentationRecord {
  /** Back to front. */
  readonly parts: readonly LabelledPart[];
  readonly order: readonly (LabelPair & { readonly confidence: number; readonly user: boolean; readonly kept: boolean })[];
  readonly joins: readonly (LabelPair & { readonly confidence: number })[];
  readonly scribbles: Scribbles;
  readonly corrections: Corrections;
}

export interface Segmentation extends SegmentationRecord {
  /** A PNG file with the label of every pixel of the drawing; empty before the first segmentation. */
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

/** Returns whether the drawing's own file is the picture that covers the canvas, as for segmented drawings. */
export function isOwnPicture(segmentation: Segmentation | null): boolean {
  return segmentation !== null && segmentation.labels.length > 0;
}

/** Returns only the record, with its keys in the order of the file. */
export function recordOf({ parts, order, joins, scribbles, corrections }: SegmentationRecord): SegmentationRecord {
  return { parts, order, joins, scribbles, corrections };
}

/** Returns the text of a project.json with nothing but the record, which the engine reads and writes. */
export function recordText(record: SegmentationRecord): string {
  return JSON.stringify({
    format: 'relievo-project',
    version: 1,
    name: '',
    drawing: null,
    segmentation: recordOf(record),
  });
}

/** Reads the record of a project.json. Precondition: the engine wrote or accepted the text. */
export function recordFrom(text: string): SegmentationRecord {
  const { segmentation } = JSON.parse(text) as { segmentation: SegmentationRecord };
  return recordOf(segmentation);
}

export function labelOf(record: SegmentationRecord, id: string): number | undefined {
  return record.parts.find((part) => part.id === id)?.label;
}

/** Renames a part everywhere in the segmentation. */
export function renameLabelled(segmentation: Segmentation, id: string, name: string): Segmentation {
  const label = labelOf(segmentation, id);
  if (label === undefined) return segmentation;
  const { scribbles, corrections } = segmentation;
  const before = corrections.parts.find((part) => part.label === label);
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
      parts: [...others, { ...before, label, id: name }].sort((a, b) => a.label - b.label),
    },
  };
}

/** Returns a label that no part has. */
export function freshLabel(record: SegmentationRecord): number {
  return 1 + Math.max(0, ...record.parts.map((part) => part.label));
}
