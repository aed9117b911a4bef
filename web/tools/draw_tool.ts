import type { Point } from '../document/document';
import { distance } from '../document/outline';
import { drawStroke, isClosed } from '../document/strokes';
import { marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import type { Modifiers, Tool, ToolHost } from './tool';

/** Every stroke makes something; see drawStroke. */
export class DrawTool implements Tool {
  readonly cursor = 'crosshair';
  private stroke: Point[] = [];

  constructor(
    private readonly host: ToolHost,
    private readonly partName: () => string,
    /** Whether what is drawn lies behind all, as with Shift. */
    private readonly behind: () => boolean,
  ) {}

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
    if (stroke.length === 0) return;
    const { document, reach } = this.host;
    const drawn = drawStroke(document, { reach, name: this.partName(), behind: keys.shift || this.behind() }, stroke);
    if ('refused' in drawn) {
      this.host.refuse(drawn.refused);
      return;
    }
    this.host.edit('draw', drawn.document);
    this.host.select(drawn.id);
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
    strokeLine(context, [last, first], isClosed(this.host.document, this.stroke, this.host.reach) ? marks.ink : marks.join, 2 * pixel);
    context.setLineDash([]);
  }
}
