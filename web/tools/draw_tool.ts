import type { Point } from '../document/document';
import { addOpenPart, addPart, movePart } from '../document/editing';
import { area, distance, simplify, smooth } from '../document/outline';
import { marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import type { Modifiers, Tool, ToolHost } from './tool';

/** Ends so near to each other, as a share of the stroke's length, are one. */
const closing = 0.05;

/** A closed stroke is a part; an open one is a part that grows out of what lies below its ends. */
export class DrawTool implements Tool {
  readonly cursor = 'crosshair';
  private stroke: Point[] = [];

  constructor(private readonly host: ToolHost, private readonly partName: () => string) {}

  down(point: Point): void {
    this.stroke = [point];
  }

  move(point: Point, pressed: boolean): void {
    if (!pressed || this.stroke.length === 0) return;
    if (distance(this.stroke[this.stroke.length - 1] as Point, point) > this.host.reach / 6) this.stroke.push(point);
  }

  up(_point: Point, keys: Modifiers): void {
    const stroke = this.stroke;
    this.stroke = [];
    const { document, reach } = this.host;
    if (stroke.length < 4 || Math.abs(area(stroke)) < 4 * reach * reach) return;
    const closed = this.isClosed(stroke);
    const line = smooth(simplify(closed ? stroke.slice(0, -1) : stroke, reach / 10), closed);
    const name = this.partName();
    const added = closed ? addPart(document, name, line) : addOpenPart(document, name, line);
    const id = added.parts[added.parts.length - 1]?.id as string;
    this.host.edit('draw', keys.shift ? movePart(added, id, 0) : added);
    this.host.select(id);
  }

  cancel(): void {
    this.stroke = [];
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    if (this.stroke.length < 2) return;
    strokeLine(context, this.stroke, marks.ink, 3 * pixel);
    const first = this.stroke[0] as Point;
    const last = this.stroke[this.stroke.length - 1] as Point;
    context.setLineDash([6 * pixel, 6 * pixel]);
    strokeLine(context, [last, first], this.isClosed(this.stroke) ? marks.ink : marks.join, 2 * pixel);
    context.setLineDash([]);
  }

  private isClosed(stroke: readonly Point[]): boolean {
    let length = 0;
    for (let i = 1; i < stroke.length; i++) length += distance(stroke[i - 1] as Point, stroke[i] as Point);
    const gap = distance(stroke[0] as Point, stroke[stroke.length - 1] as Point);
    return gap < Math.max(1.5 * this.host.reach, closing * length);
  }
}
