import type { Document, Point } from '../document/document';
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
  /** Says why nothing was changed. */
  refuse(reason: Refusal | StrokeRefusal | 'cueOffPart'): void;
}

export interface Modifiers {
  readonly shift: boolean;
  readonly alt: boolean;
}

/** What arrow keys mean, in px of the page. */
export const arrows: Readonly<Record<string, Point>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

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
