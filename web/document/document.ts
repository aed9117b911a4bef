import type { Segmentation } from './segmentation';

/** What a person makes: plain data, never changed in place. Coordinates are canvas px, y down. */

export type Point = readonly [number, number];
export type Ring = readonly Point[];
/** `below` has a range. */
export type RelationKind = 'equal' | 'above' | 'free' | 'below';

export interface Part {
  /** Unique name. */
  readonly id: string;
  /** Rings filled by the non-zero rule; the first ones are outer. */
  readonly outline: readonly Ring[];
  /** Amount of inflation: 4 makes a hemisphere of a disc. */
  readonly c: number;
  /** Depth scale, not 0; negative inflates away from the viewer. */
  readonly d: number;
  /** Profile from 0, the usual semi-ellipse, to 1, a flat top with round edges. */
  readonly flat?: number;
  /** How much nearer it comes per px to the right and downwards. */
  readonly lean?: Point;
  /** CSS colour where there is no drawing. */
  readonly color?: string;
}

export interface Join {
  readonly upper: string;
  readonly lower: string;
  readonly line: Ring;
}

export interface Relation {
  readonly upper: string;
  readonly lower: string;
  readonly relation: RelationKind;
  readonly range?: readonly [Point, Point];
}

export interface RobinRange {
  readonly upper: string;
  readonly lower: string;
  readonly from: Point;
  readonly to: Point;
  readonly alpha0?: number;
  readonly rho?: number;
}

/** What the profile of a part is like along a line on it. */
export interface Cue {
  readonly part: string;
  readonly kind: 'bulge' | 'slope' | 'crease';
  readonly line: Ring;
  /** Of a bulge a factor, of the others degrees. */
  readonly value: number;
}

/** The drawing as its file came; `paintable` is what may be shown of an SVG, as the engine says. */
export interface DrawingSource {
  readonly name: string;
  readonly kind: 'svg' | 'image';
  readonly mime: string;
  readonly bytes: Uint8Array;
  readonly paintable?: string;
}

export interface Settings {
  readonly method: 'approximate' | 'nonlinear';
  readonly vertices: number;
  readonly rho: number;
  readonly lambdaBnd: number;
  readonly lambdaShift: number;
  readonly sizeMm: number;
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
  /** How a flat drawing was understood; null of all others. */
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
    segmentation: null,
    settings: defaultSettings,
  };
}

export function partIndex(document: Document, id: string): number {
  return document.parts.findIndex((part) => part.id === id);
}

/** `wanted`, or with the first number behind it that makes it unique. */
export function freshId(document: Document, wanted: string): string {
  const taken = new Set(document.parts.map((part) => part.id));
  if (!taken.has(wanted)) return wanted;
  let number = 2;
  while (taken.has(`${wanted} ${number}`)) number++;
  return `${wanted} ${number}`;
}
