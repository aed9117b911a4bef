/** The messages between the page and the engine: plain values, and arrays that are transferred. */

export type Visibility = 'relief' | 'orbit' | 'all';
/** The height field h = f + g of the relief, its inflation f or its shift g. */
export type Field = 'relief' | 'inflation' | 'shift';
export type ExportFormat = 'glb' | 'obj' | 'ply' | 'stl' | 'usdz' | 'html';
export type SolidFormat = '3mf' | 'stl' | 'glb' | 'usdz';
export type MapKind = 'normal' | 'depth' | 'part';

export interface BuildOptions {
  method: 'approximate' | 'nonlinear';
  /** Approximate number of nodes of the joined mesh. */
  vertices: number;
  /** Spacing of points on outlines, px; 0 derives it from `vertices`. */
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
  /** The place, for a person: the path of a key of the scene, the id of a part, or empty. */
  where: string;
  /** The item at fault, if there is one: an element of a list of the scene or of the strokes. */
  culprit?: { list: 'parts' | 'joins' | 'relations' | 'robin' | 'cues' | 'strokes'; index: number };
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
  /** Energy of the non-linear method, scene units; 0 for the other method. */
  energy: number;
  times: Record<string, number>;
  warnings: string[];
}

export interface PartRun {
  id: string;
  firstTriangle: number;
  triangleCount: number;
  /** Number of triangles at the end that lie behind other parts and have vertex colours. */
  hiddenCount: number;
}

/** A surface in px of the canvas: X to the right, Y up, Z towards the viewer. */
export interface Surface {
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  uvs: Float32Array<ArrayBuffer>;
  triangles: Uint32Array<ArrayBuffer>;
  /** Colours of hidden triangles: sRGB, three bytes per vertex. */
  colors: Uint8Array<ArrayBuffer>;
  parts: PartRun[];
  /** Whether the drawing keeps its pixels. */
  pixelArt: boolean;
  /** The contours, without light and seen from one side alone. */
  ink?: Lines;
}

/** Triangles of lines, with the surface's picture on them. */
export interface Lines {
  positions: Float32Array<ArrayBuffer>;
  uvs: Float32Array<ArrayBuffer>;
  triangles: Uint32Array<ArrayBuffer>;
}

/** Options of a closed solid; lengths in mm. See the command line's --profile. */
export interface SolidOptions {
  /** Longest side of the solid. */
  readonly size?: number;
  /** The back of the plate or of a figure. */
  readonly back?: 'flat' | 'plain' | 'mirror' | 'parts';
  readonly base?: 'none' | 'outline' | 'plate' | 'round';
  /** Largest depth of the solid; 0: as deep as the relief is. */
  readonly height?: number;
  /** Whether small forms keep their depth when `height` limits the solid. */
  readonly detail?: boolean;
  readonly thickness?: number;
  readonly margin?: number;
  readonly corner?: number;
  /** Diameters of a hole in the plate and of the hole in a loop above it; 0: none. */
  readonly hole?: number;
  readonly ring?: number;
  /** Height of a wall around the plate, above it; 0: none. */
  readonly cutter?: number;
}

/** Settings of exported files. */
export interface FileSettings {
  /** Longest side of the model. */
  readonly sizeMm: number;
  /** Factor for the width of contours; 0: none are drawn. */
  readonly inkWidth: number;
}

/** A weak spot of a part that the print check found. */
export interface PrintFinding {
  trouble: 'loose' | 'thin' | 'neck' | 'overhang';
  part: string;
  /** Thickness of the thinnest wall or the neck, mm, or area of the overhang, mm²; else 0. */
  measure: number;
  /** Longest side of the model with which the part is thick enough, mm; 0 if no size helps. */
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

/** A surface with its texture. */
export interface Dressed {
  surface: Surface;
  picture: ImageBitmap;
}

/** A solid to show, in mm. It starts at x = y = 0 and lies around z = 0. */
export interface Solid extends SolidFacts, Dressed {}

/** Edges to draw, in canvas px: four numbers each, x and y of both ends. Ramps have alpha at both ends as well. */
export interface Overlays {
  joins: Float32Array<ArrayBuffer>;
  equal: Float32Array<ArrayBuffer>;
  above: Float32Array<ArrayBuffer>;
  /** Edges where a part lies behind another against their order. */
  below: Float32Array<ArrayBuffer>;
  ramps: Float32Array<ArrayBuffer>;
}

export interface SvgImport {
  /** Text of a scene file. */
  scene: string;
  /** The safe version of the drawing, which the page may show. */
  paintable: string;
  proposed: boolean;
  /** The drawing has no filled shapes, or is a picture: its parts are found as in a flat drawing. */
  lineArt: boolean;
  warnings: string[];
}

/** Returns the kind of a file that Relievo does not read, and the remedy. In English. */
export interface UnreadFile {
  readonly name: string;
  readonly remedy: string;
}

/** An imported drawing of painted layers. */
export interface LayersImport {
  /** Text of a scene file whose canvas is the picture; absent if there is only one layer. */
  scene?: string;
  /** Whether the parts were guessed. */
  proposed: boolean;
  warnings: string[];
  /** The picture that the layers make together, a PNG file. */
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

/** Strokes and corrections, with the segmentation before them. */
export interface SegmentationRequest {
  /** Text of a project.json. */
  project: string;
  /** Its labels.png; empty before the first segmentation. */
  labels: Uint8Array;
}

export interface UnderstandingRequest extends SegmentationRequest {
  /** Text of a scene file with the user's edits; empty if there are no parts. */
  edited: string;
}

export interface Labelled {
  /** The label of every pixel; 0 is background. */
  labels: Uint16Array<ArrayBuffer>;
  parts: { label: number; id: string }[];
  /** Closed gaps in the lines: alternating x and y, and the labels on both sides. */
  bridges: { points: Float32Array<ArrayBuffer>; left: number; right: number }[];
  notes: string[];
}

/** The labels as a picture. */
export interface TintedLabels {
  tint: ImageBitmap;
  bridges: Labelled['bridges'];
}

/** The engine's interpretation of strokes, corrections and edits. */
export interface Understanding {
  /** Text of a project.json. */
  project: string;
  /** Text of a scene file whose canvas is the drawing; empty if there are no parts. */
  scene: string;
  /** A PNG file. */
  labels: Uint8Array<ArrayBuffer>;
  warnings: string[];
}
/**
 * Receives the current stage, the share of it that is done, in [0, 1], and the energy of the non-linear method
 * once it is known.
 */
export type Progress = (stage: string, done: number, energy?: number) => void;

/** Formats an error as its cause and message. */
export function errorText({ where, message }: EngineError): string {
  return where ? `${where}: ${message}` : message;
}

export function isFailure(value: object): value is Failure {
  return 'error' in value;
}
