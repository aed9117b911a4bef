/** Parts and their relations as in scene files (docs/scene.md). Coordinates are canvas px, y down. */

export type Point = readonly [number, number];
export type Ring = readonly Point[];
/** `below` only occurs with a range. */
export type RelationKind = 'equal' | 'above' | 'free' | 'below' | 'joined';

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
  /** Tilt: how much nearer the part comes per px to the right and downwards. */
  readonly lean?: Point;
  /** CSS colour where there is no drawing. */
  readonly color?: string;
}

/** Two parts by their ids; `upper` is the nearer one. */
export interface Pair {
  readonly upper: string;
  readonly lower: string;
}

export interface Join extends Pair {
  readonly line: Ring;
}

export interface Relation extends Pair {
  readonly relation: RelationKind;
  readonly range?: readonly [Point, Point];
}

export interface RobinRange extends Pair {
  readonly from: Point;
  readonly to: Point;
  readonly alpha0?: number;
  readonly rho?: number;
}

/** Changes the profile of a part along a line on it. */
export interface Cue {
  readonly part: string;
  readonly kind: 'bulge' | 'slope' | 'crease';
  readonly line: Ring;
  /** A factor for a bulge, degrees for the others. */
  readonly value: number;
}
