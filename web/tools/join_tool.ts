import type { Point } from '../document/document';
import { addJoin, joinOfLine, partAt } from '../document/editing';
import { distance } from '../document/outline';
import { marks } from '../view/colors';
import { traceLine } from '../view/paper_view';
import type { Tool, ToolHost } from './tool';

/** A line across the root of a part joins it to the part below. */
export class JoinTool implements Tool {
  readonly cursor = 'crosshair';
  private line: Point[] = [];

  constructor(private readonly host: ToolHost) {}

  down(point: Point): void {
    this.line = [point];
  }

  move(point: Point, pressed: boolean): void {
    if (pressed) this.line.push(point);
    else this.host.hover(partAt(this.host.document, point)?.id ?? null);
  }

  up(): void {
    const join = this.proposed();
    this.line = [];
    if (!join) return;
    this.host.edit('join', addJoin(this.host.document, join));
    this.host.select(join.upper);
  }

  cancel(): void {
    this.line = [];
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    if (this.line.length < 2) return;
    traceLine(context, this.line);
    context.strokeStyle = 'rgb(47 111 237 / 45%)';
    context.lineWidth = 2 * pixel;
    context.stroke();
    const join = this.proposed();
    if (!join) return;
    traceLine(context, join.line);
    context.strokeStyle = marks.join;
    context.lineWidth = 5 * pixel;
    context.lineCap = 'round';
    context.stroke();
  }

  private proposed() {
    const first = this.line[0];
    const last = this.line[this.line.length - 1];
    if (!first || !last || distance(first, last) < this.host.reach / 2) return null;
    return joinOfLine(this.host.document, this.line, 4 * this.host.reach);
  }
}
