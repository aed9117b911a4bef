import type { Cue, Join, Part, Relation, Ring, RobinRange } from './scene';
import type { Segmentation } from './segmentation';

export type { Cue, Join, Pair, Part, Point, Relation, RelationKind, Ring, RobinRange } from './scene';

/** The document is plain data that is never changed in place. */

/** The original file of a drawing. `paintable` is the safe version of an SVG that the page may show. */
export interface DrawingSource {
  readonly name: string;
  readonly kind: 'svg' | 'image';
  readonly mime: string;
  readonly bytes: Uint8Array;
  readonly paintable?: string;
}

/** A stroke of a round brush over the drawing. */
export interface PaintStroke {
  /** #rrggbb; null removes earlier paint. */
  readonly color: string | null;
  /** px of the page. */
  readonly width: number;
  /** A single point is a dot. */
  readonly points: Ring;
}

export interface Settings {
  readonly method: 'approximate' | 'nonlinear';
  readonly vertices: number;
  readonly rho: number;
  readonly lambdaBnd: number;
  readonly lambdaShift: number;
  readonly sizeMm: number;
  /**
   * Ink around parts that no drawing shows: its colour, #rrggbb, and its width as a multiple of the default;
   * 0: none.
   */
  readonly inkColor: string;
  readonly inkWidth: number;
  /** Whether models show the contours of the drawing, and a factor for their width. */
  readonly contours: boolean;
  readonly contourWidth: number;
}

/** Returns the factor for the width of contours; 0 if there are none. */
export function shownContourWidth({ contours, contourWidth }: Settings): number {
  return contours ? contourWidth : 0;
}

export interface Document {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly drawing: DrawingSource | null;
  /** Back to front. */
  readonly parts: readonly Part[];
  readonly joins: readonly Join[];
  readonly relations: readonly Relation[];
  readonly robin: readonly RobinRange[];
  readonly cues: readonly Cue[];
  readonly paint: readonly PaintStroke[];
  /** How a flat drawing was divided into parts; null for all other drawings. */
  readonly segmentation: Segmentation | null;
  readonly settings: Settings;
}

export const defaultSettings: Settings = {
  method: 'approximate',
  vertices: 20000,
  rho: 0.25,
  lambdaBnd: 0.01,
  lambdaShift: 1,
  sizeMm: 100,
  inkColor: '#2b2d33',
  inkWidth: 1,
  contours: true,
  contourWidth: 1,
};

export function emptyDocument(): Document {
  return {
    name: 'untitled',
    width: 1000,
    height: 800,
    drawing: null,
    parts: [],
    joins: [],
    relations: [],
    robin: [],
    cues: [],
    paint: [],
    segmentation: null,
    settings: defaultSettings,
  };
}

export function partIndex(document: Document, id: string): number {
  return document.parts.findIndex((part) => part.id === id);
}

/** Returns `wanted` or, if a part has that id, `wanted` with the first number that makes it unique. */
export function freshId(document: Document, wanted: string): string {
  const taken = new Set(document.parts.map((part) => part.id));
  if (!taken.has(wanted)) return wanted;
  let number = 2;
  while (taken.has(`${wanted} ${number}`)) number++;
  return `${wanted} ${number}`;
}
