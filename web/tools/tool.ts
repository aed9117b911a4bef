import type { Document, Pair, Point, RelationKind } from '../document/document';
import type { Refusal } from '../document/reshape';
import type { StrokeRefusal } from '../document/strokes';

/** What a tool may see and do. Lengths in canvas px. */
export interface ToolHost {
  readonly document: Document;
  readonly selected: string | null;
  /** How far a hand may miss, canvas px. */
  readonly reach: number;
  edit(label: string, next: Document, gesture?: string): void;
  /** Lets the relief show what would be, until null. */
  preview(document: Document | null): void;
  select(id: string | null): void;
  hover(id: string | null): void;
  /** Says what holds between two parts now; null: the usual. */
  tellRelation(pair: Pair, kind: RelationKind | null): void;
  /** Says why nothing was changed. */
  refuse(reason: Refusal | StrokeRefusal | 'cueOffPart' | 'nearestHere'): void;
}

export interface Modifiers {
  readonly shift: boolean;
  readonly alt: boolean;
}

/** What arrow keys mean, in px of the page. */
export const arrows: Readonly<Record<string, Point>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** How far an arrow key moves a pen, as shares of the reach of a hand: usually, with Shift. */
const penSteps = [0.5, 3] as const;

/** Where an arrow key takes a pen, on the page; null for other keys. */
export function penMoved(at: Point, key: string, shift: boolean, { document, reach }: Pick<ToolHost, 'document' | 'reach'>): Point | null {
  const way = arrows[key];
  if (!way) return null;
  const step = reach * penSteps[shift ? 1 : 0];
  const within = (value: number, most: number): number => Math.min(most, Math.max(0, value));
  return [within(at[0] + step * way[0], document.width), within(at[1] + step * way[1], document.height)];
}

/** A small state machine between pointer and document. Points are in canvas px. */
export interface Tool {
  readonly cursor: string;
  down(point: Point, keys: Modifiers): void;
  move(point: Point, pressed: boolean): void;
  up(point: Point, keys: Modifiers): void;
  /** Escape, or a second finger: as if the gesture had not begun. */
  cancel(): void;
  /** A key while the tool is in hand and the page has the focus; whether it means something. */
  key?(name: string, keys: Modifiers): boolean;
  /** What the hand is about to do. `pixel`: a CSS px in canvas px. */
  draw(context: CanvasRenderingContext2D, pixel: number): void;
}
