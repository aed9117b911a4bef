import type { Document, Pair, Point, RelationKind } from '../document/document';
import type { Refusal } from '../document/reshape';
import type { StrokeRefusal } from '../document/strokes';

/** What a tool can see and do. Lengths are in canvas px. */
export interface ToolHost {
  readonly document: Document;
  readonly selected: string | null;
  /** How far a hand may miss, canvas px. */
  readonly reach: number;
  edit(label: string, next: Document, gesture?: string): void;
  /** Shows the relief of a document that is not a step yet; null ends this. */
  preview(document: Document | null): void;
  select(id: string | null): void;
  hover(id: string | null): void;
  /** Tells the user the current relation of two parts; null is the default. */
  tellRelation(pair: Pair, kind: RelationKind | null): void;
  /** Tells the user why nothing was changed. */
  refuse(reason: Refusal | StrokeRefusal | 'cueOffPart' | 'nearestHere'): void;
}

export interface Modifiers {
  readonly shift: boolean;
  readonly alt: boolean;
}

/** Directions of the arrow keys, in px of the page. */
export const arrows: Readonly<Record<string, Point>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Steps of a pen that arrow keys move, in reaches of the hand: without and with Shift. */
const penSteps = [0.5, 3] as const;

/** Returns the point of the page to which an arrow key moves a pen, or null for other keys. */
export function penMoved(at: Point, key: string, shift: boolean, { document, reach }: Pick<ToolHost, 'document' | 'reach'>): Point | null {
  const way = arrows[key];
  if (!way) return null;
  const step = reach * penSteps[shift ? 1 : 0];
  const within = (value: number, most: number): number => Math.min(most, Math.max(0, value));
  return [within(at[0] + step * way[0], document.width), within(at[1] + step * way[1], document.height)];
}

/** A tool: a small state machine between pointer and document. Points are in canvas px. */
export interface Tool {
  readonly cursor: string;
  down(point: Point, keys: Modifiers): void;
  move(point: Point, pressed: boolean): void;
  up(point: Point, keys: Modifiers): void;
  /** Undoes the gesture in progress, on Escape or when a second finger comes down. */
  cancel(): void;
  /** Handles a key while the page has the focus. Returns whether the tool uses the key. */
  key?(name: string, keys: Modifiers): boolean;
  /** Draws what the gesture is about to do. `pixel` is the size of a CSS px in canvas px. */
  draw(context: CanvasRenderingContext2D, pixel: number): void;
}
