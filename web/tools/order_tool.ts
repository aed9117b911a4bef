import type { Part, Point } from '../document/document';
import { bringBefore, nextInFront } from '../document/editing';
import { distance } from '../document/outline';
import { partAt } from '../document/picking';
import { marks } from '../view/colors';
import { tracePart } from '../view/trace';
import type { Tool, ToolHost } from './tool';

/** Orders parts by an arrow from the nearer to the farther part, or by a tap on a part that should come nearer. */
export class OrderTool implements Tool {
  readonly cursor = 'crosshair';
  private from: Point | null = null;
  private to: Point | null = null;

  constructor(private readonly host: ToolHost) {}

  down(point: Point): void {
    this.from = this.to = point;
  }

  move(point: Point, pressed: boolean): void {
    if (pressed) this.to = point;
    this.host.hover(partAt(this.host.document, point)?.id ?? null);
  }

  up(): void {
    const tapped = this.tapped();
    const back = tapped && nextInFront(this.host.document, tapped.id);
    const pair = tapped ? back && { front: tapped, back } : this.pair();
    this.cancel();
    if (tapped && !back) this.host.refuse('nearestHere');
    if (!pair) return;
    this.host.edit('order', bringBefore(this.host.document, pair.front.id, pair.back.id));
    this.host.select(pair.front.id);
  }

  cancel(): void {
    this.from = this.to = null;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    if (!this.from || !this.to) return;
    const pair = this.pair();
    if (pair) {
      tracePart(context, pair.back.outline);
      context.strokeStyle = marks.above;
      context.lineWidth = 2 * pixel;
      context.stroke();
    }
    this.arrow(context, this.from, this.to, pixel);
  }

  private pair(): { front: Part; back: Part } | null {
    const front = this.from && partAt(this.host.document, this.from);
    const back = this.to && partAt(this.host.document, this.to);
    return front && back && front !== back ? { front, back } : null;
  }

  /** Returns the part under the pen if it did not move. */
  private tapped(): Part | undefined {
    const { from, to } = this;
    const stayed = from && to && distance(from, to) < this.host.reach / 2;
    return stayed ? partAt(this.host.document, from) : undefined;
  }

  private arrow(context: CanvasRenderingContext2D, from: Point, to: Point, pixel: number): void {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const head = 14 * pixel;
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...to);
    for (const side of [-0.45, 0.45]) {
      context.moveTo(...to);
      context.lineTo(to[0] - head * Math.cos(angle + side), to[1] - head * Math.sin(angle + side));
    }
    context.strokeStyle = marks.select;
    context.lineWidth = 3.5 * pixel;
    context.lineCap = 'round';
    context.stroke();
  }
}
