import type { PaintStroke, Point } from '../document/document';
import { distance, rounded, simplify } from '../document/outline';
import { addPaint } from '../document/paint';
import { marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import { type Modifiers, penMoved, type Tool, type ToolHost } from './tool';

/** The paint brush: its colour, or null to rub out, and its width, px of the page. */
export type PaintBrush = Pick<PaintStroke, 'color' | 'width'>;

/** Paints on the page. The relief shows the paint at once. */
export class PaintTool implements Tool {
  readonly cursor = 'crosshair';
  private points: Point[] = [];
  private at: Point | null = null;
  private rubs = false;

  constructor(private readonly host: ToolHost, private readonly brush: () => PaintBrush) {}

  down(point: Point, keys: Modifiers): void {
    this.points = [point];
    this.at = point;
    this.rubs = keys.alt;
    this.show();
  }

  move(point: Point, pressed: boolean): void {
    this.at = point;
    const last = this.points.at(-1);
    if (!pressed || !last || distance(last, point) < this.host.reach / 8) return;
    this.points.push(point);
    this.show();
  }

  up(): void {
    if (this.points.length > 0) this.host.edit('paint', addPaint(this.host.document, this.stroke()));
    this.cancel();
  }

  cancel(): void {
    this.points = [];
    this.host.preview(null);
  }

  /** Moves the brush with arrows; Enter puts it down and lifts it. */
  key(name: string, keys: Modifiers): boolean {
    const { width, height } = this.host.document;
    const at = this.at ?? [width / 2, height / 2];
    if (name === 'Enter') {
      if (this.points.length > 0) this.up();
      else this.down(at, keys);
      return true;
    }
    const next = penMoved(at, name, keys.shift, this.host);
    if (next) this.move(next, true);
    return next !== null;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    const { color, width } = this.stroke();
    if (this.points.length > 0) strokeLine(context, this.points, color ?? 'rgb(255 255 255 / 60%)', width);
    if (!this.at) return;
    context.beginPath();
    context.arc(...(this.at as [number, number]), width / 2, 0, 2 * Math.PI);
    context.strokeStyle = color === null ? marks.culprit : marks.ink;
    context.lineWidth = 1.5 * pixel;
    context.stroke();
  }

  private stroke(): PaintStroke {
    const { color, width } = this.brush();
    const points = simplify(this.points, this.host.reach / 16).map((p) => rounded(p, 10));
    return { color: this.rubs ? null : color, width, points };
  }

  private show(): void {
    this.host.preview(addPaint(this.host.document, this.stroke()));
  }
}
