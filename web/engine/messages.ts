/** What the page and the engine say to each other. Plain values and arrays that are handed over. */

export type Visibility = 'relief' | 'orbit' | 'all';
/** The heights, or one of the two that they are the sum of. */
export type Field = 'relief' | 'inflation' | 'shift';
export type ExportFormat = 'glb' | 'obj' | 'ply' | 'stl' | 'usdz' | 'html';
export type SolidFormat = '3mf' | 'stl' | 'glb' | 'usdz';
export type MapKind = 'normal' | 'depth' | 'part';

export interface BuildOptions {
  method: 'approximate' | 'nonlinear';
  /** About so many nodes of the joined mesh. */
  vertices: number;
  /** Spacing of the outlines in px; 0: from `vertices`. */
  edge: number;
  rho: number;
  alpha0: number;
  lambdaBnd: number;
  lambdaShift: number;
  glue: boolean;
}

export interface EngineError {
  code: 'internal' | 'usage' | 'bad_input' | 'contradiction' | 'limit' | 'file' | 'interrupted';
  message: string;
  /** Culprit: path of a key of the scene, id of a part, or empty. */
  where: string;
}

export interface Failure {
  error: EngineError;
}

export interface Report {
  nodes: number;
  faces: number;
  equalities: number;
  inequalities: number;
  active: number;
  maxViolation: number;
  overlapWorst: number;
  converged: boolean;
  /** Of the non-linear method, scene units; else 0. */
  energy: number;
  times: Record<string, number>;
  warnings: string[];
}

interface PartRun {
  id: string;
  firstTriangle: number;
  triangleCount: number;
  /** The last so many of them lie behind other parts and have colours of their own. */
  hiddenCount: number;
}

/** A surface in px of the canvas: X right, Y up, Z to the viewer. */
export interface Surface {
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  uvs: Float32Array<ArrayBuffer>;
  triangles: Uint32Array<ArrayBuffer>;
  /** sRGB, three bytes a vertex, of what is hidden. */
  colors: Uint8Array<ArrayBuffer>;
  parts: PartRun[];
}

/** What a closed solid is like; lengths in mm, see the command line's --profile. */
export interface SolidOptions {
  /** Longest side of the whole. */
  readonly size?: number;
  /** The plate's side, or a figure's. */
  readonly back?: 'flat' | 'drawing' | 'parts';
  readonly base?: 'none' | 'outline' | 'plate' | 'round';
  /** Of the whole at most; 0: as deep as it is. */
  readonly height?: number;
  /** Whether small forms keep their depth then. */
  readonly detail?: boolean;
  readonly thickness?: number;
  readonly margin?: number;
  readonly corner?: number;
  /** Diameters of a hole in the plate and of one in a loop above it; 0: none. */
  readonly hole?: number;
  readonly ring?: number;
  /** Of a wall around the plate, above it; 0: none. */
  readonly cutter?: number;
}

/** What a printer, or a hand, makes of a part. */
export interface PrintFinding {
  trouble: 'loose' | 'thin' | 'neck' | 'overhang';
  part: string;
  /** mm of the thinnest wall or of the neck, mm^2 that hang over; or 0. */
  measure: number;
  /** Longest side with which it is wide enough, mm; 0 where none helps. */
  enough: number;
}

export interface SolidFacts {
  /** mm */
  size: [number, number, number];
  /** mm^3 */
  volume: number;
  pieces: number;
  findings: PrintFinding[];
}

/** A surface with the picture that its texture coordinates are on. */
export interface Dressed {
  surface: Surface;
  picture: ImageBitmap;
}

/** A solid as it is shown, in mm from x = y = 0 on, around z = 0. */
export interface Solid extends SolidFacts, Dressed {}

/** Segments of edges in canvas px, four numbers each; ramps have alpha at both ends besides. */
export interface Overlays {
  joins: Float32Array<ArrayBuffer>;
  equal: Float32Array<ArrayBuffer>;
  above: Float32Array<ArrayBuffer>;
  /** Held apart against the order of parts. */
  below: Float32Array<ArrayBuffer>;
  ramps: Float32Array<ArrayBuffer>;
}

export interface SvgImport {
  /** Text of a scene file. */
  scene: string;
  /** The drawing as the page may paint it. */
  paintable: string;
  proposed: boolean;
  /** Nothing is filled: lines enclose the parts. */
  lineArt: boolean;
  warnings: string[];
}

/** A drawing of painted layers. */
export interface LayersImport {
  /** Text of a scene file; its canvas is the picture. None where all is in one layer. */
  scene?: string;
  /** The parts were guessed. */
  proposed: boolean;
  warnings: string[];
  /** The picture that the layers make, a PNG file. */
  drawing: Uint8Array<ArrayBuffer>;
}

export interface OutputFile {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

export interface Files {
  files: OutputFile[];
}

export interface Texture {
  rgba: Uint8Array<ArrayBuffer>;
  width: number;
  height: number;
}

export interface BuiltRelief {
  report: Report;
  surface: Surface;
  overlays: Overlays;
}

/** A flat drawing: a PNG file, which the core decodes as the command line does, or its pixels. */
export type FlatDrawing = { png: Uint8Array } | { pixels: Texture };

/** Strokes and corrections with what was known before them. */
export interface SegmentationRequest {
  /** Text of a project.json. */
  project: string;
  /** Its labels.png; empty where nothing was known. */
  labels: Uint8Array;
}

export interface UnderstandingRequest extends SegmentationRequest {
  /** Text of a scene file: what was made of it before and edited since; empty where no part is. */
  edited: string;
}

export interface Labelled {
  /** The label of every pixel, 0 where there is no part. */
  labels: Uint16Array<ArrayBuffer>;
  parts: { label: number; id: string }[];
  /** Gaps in the lines that were closed: x and y by turns, and the labels on both sides. */
  bridges: { points: Float32Array<ArrayBuffer>; left: number; right: number }[];
  notes: string[];
}

/** The labels as the page shows them. */
export interface TintedLabels {
  tint: ImageBitmap;
  bridges: Labelled['bridges'];
}

/** All that follows from strokes, corrections and edits. */
export interface Understanding {
  /** Text of a project.json. */
  project: string;
  /** Text of a scene file; its canvas is the drawing. Empty where there is no part. */
  scene: string;
  /** A PNG file. */
  labels: Uint8Array<ArrayBuffer>;
  warnings: string[];
}
/** A stage and how much of it is done, in [0, 1]; the non-linear method's energy once it has one. */
export type Progress = (stage: string, done: number, energy?: number) => void;

/** An error in words: where it is, and what. */
export function told({ where, message }: EngineError): string {
  return where ? `${where}: ${message}` : message;
}

export function isFailure(value: object): value is Failure {
  return 'error' in value;
}
