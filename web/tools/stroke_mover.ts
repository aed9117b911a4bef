import type { Document, Point } from '../document/document';
import { clearStroke, moveStroke, scribblesOf, strokeAt } from '../document/scribbling';
import type { Stroke } from '../document/segmentation';
import { arrows, type ToolHost } from './tool';

/** The members of ScribbleHost that the mover needs. */
interface StrokeHost {
  readonly pending: Document;
  show(document: Document): void;
  drop(): void;
  wish(label: string, change: (document: Document) => Document): void;
}

/** Moves strokes by dragging. Keys choose, move and remove them. */
export class StrokeMover {
  private chosen: Stroke | null = null;
  private from: Point | null = null;
  private by: Point = [0, 0];

  constructor(private readonly host: ToolHost, private readonly scribbles: StrokeHost) {}

  /** The chosen stroke at its current position, or null. */
  get shown(): Stroke | null {
    const { chosen, by } = this;
    if (!chosen) return null;
    return { ...chosen, points: chosen.points.map(([x, y]): Point => [x + by[0], y + by[1]]) };
  }

  /** Returns a document with the chosen stroke at its current position. */
  moved(document: Document): Document {
    return this.chosen && this.from ? moveStroke(document, this.chosen, this.by) : document;
  }

  down(point: Point): void {
    this.chosen = strokeAt(scribblesOf(this.scribbles.pending), point, this.host.reach / 2) ?? null;
    this.from = this.chosen && point;
    this.by = [0, 0];
  }

  move(point: Point): void {
    if (!this.from) return;
    this.by = [point[0] - this.from[0], point[1] - this.from[1]];
    this.scribbles.show(this.moved(this.scribbles.pending));
  }

  up(): void {
    if (this.from) this.settle();
  }

  cancel(): void {
    if (!this.from) return;
    this.from = null;
    this.by = [0, 0];
    this.scribbles.drop();
  }

  /** Chooses a stroke with comma and full stop, moves it with arrows and removes it with Delete. */
  key(name: string, shift: boolean): boolean {
    const { strokes } = scribblesOf(this.scribbles.pending);
    const turn = { '.': 1, ',': -1 }[name];
    const at = strokes.findIndex((stroke) => JSON.stringify(stroke) === JSON.stringify(this.chosen));
    if (turn !== undefined && strokes.length > 0) {
      const next = at < 0 ? (turn > 0 ? 0 : strokes.length - 1) : (at + turn + strokes.length) % strokes.length;
      this.chosen = strokes[next] as Stroke;
      return true;
    }
    const { chosen } = this;
    if (!chosen || at < 0) return false;
    if (name === 'Delete' || name === 'Backspace') {
      this.chosen = null;
      this.scribbles.wish('erase', (document) => clearStroke(document, chosen));
      return true;
    }
    const way = arrows[name];
    if (!way) return false;
    const size = shift ? 10 : 1;
    this.from = chosen.points[0] as Point;
    this.by = [size * way[0], size * way[1]];
    this.settle();
    return true;
  }

  private settle(): void {
    const { chosen, by } = this;
    this.from = null;
    this.by = [0, 0];
    if (!chosen) return;
    const after = moveStroke(this.scribbles.pending, chosen, by);
    if (after === this.scribbles.pending) return;
    const { strokes } = scribblesOf(this.scribbles.pending);
    const at = strokes.findIndex((stroke, i) => stroke !== scribblesOf(after).strokes[i]);
    this.chosen = scribblesOf(after).strokes[at] ?? null;
    this.scribbles.wish('move', (document) => moveStroke(document, chosen, by));
  }
}
