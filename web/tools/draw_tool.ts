import type { Point } from '../document/document';
import { stampEyes } from '../document/eyes';
import { distance } from '../document/outline';
import { type Drawn, drawStroke, type Hand, isClosed, previewStroke } from '../document/strokes';
import { marks } from '../view/colors';
import { drawDot, strokeLine } from '../view/paper_view';
import { type Modifiers, penMoved, type Tool, type ToolHost } from './tool';

/** Draws parts; see drawStroke. With eyes switched on it adds eyes; see stampEyes. */
export class DrawTool implements Tool {
  readonly cursor = 'crosshair';
  private stroke: Point[] = [];
  /** Position of the pen at the last preview. */
  private shownAt: Point | null = null;
  /** Position of the pen that keys move. */
  private pen: Point | null = null;

  constructor(
    private readonly host: ToolHost,
    private readonly partName: () => string,
    /** Whether new parts lie behind all others, as with Shift. */
    private readonly behind: () => boolean,
    /** Whether strokes add eyes. */
    private readonly eyes: () => boolean,
  ) {}

  down(point: Point): void {
    this.pen = null;
    this.stroke = [point];
  }

  move(point: Point, pressed: boolean): void {
    if (!pressed || this.stroke.length === 0) return;
    if (distance(this.stroke[this.stroke.length - 1] as Point, point) <= this.host.reach / 6) return;
    this.stroke.push(point);
    const last = this.shownAt ?? (this.stroke[0] as Point);
    if (distance(last, point) < this.host.reach) return;
    this.shownAt = point;
    if (!this.eyes()) this.host.preview(previewStroke(this.host.document, this.hand(false), this.stroke));
  }

  up(_point: Point, keys: Modifiers): void {
    const { stroke } = this;
    this.stroke = [];
    const { document, reach } = this.host;
    if (stroke.length > 0) this.make(this.eyes() ? stampEyes(document, reach, stroke) : drawStroke(document, this.hand(keys.shift), stroke));
    // Ends the preview only now, so that the relief changes from the preview to the result directly.
    this.cancel();
  }

  cancel(): void {
    this.stroke = [];
    this.shownAt = null;
    this.host.preview(null);
  }

  /** Moves the pen with arrows; Enter puts it down and lifts it. */
  key(name: string, keys: Modifiers): boolean {
    const { width, height } = this.host.document;
    const at = this.pen ?? [width / 2, height / 2];
    const isDown = this.pen !== null && this.stroke.length > 0;
    if (name === 'Enter') {
      if (isDown) this.up(at, keys);
      else this.down(at);
      this.pen = at;
      return true;
    }
    const next = penMoved(at, name, keys.shift, this.host);
    if (!next) return false;
    this.pen = next;
    if (isDown) this.move(next, true);
    return true;
  }

  private make(drawn: Drawn): void {
    if ('refused' in drawn) {
      this.host.refuse(drawn.refused);
      return;
    }
    this.host.edit('draw', drawn.document);
    this.host.select(drawn.id);
  }

  private hand(shift: boolean): Hand {
    return { reach: this.host.reach, name: this.partName(), behind: shift || this.behind() };
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    if (this.pen) drawDot(context, this.pen, { radius: 5, fill: this.stroke.length > 0 ? marks.select : '#fff', rim: marks.select, width: 2 }, pixel);
    if (this.stroke.length < 2 || this.eyes()) return;
    strokeLine(context, this.stroke, marks.ink, 3 * pixel);
    const first = this.stroke[0] as Point;
    const last = this.stroke[this.stroke.length - 1] as Point;
    context.setLineDash([6 * pixel, 6 * pixel]);
    strokeLine(context, [last, first], isClosed(this.host.document, this.stroke, this.host.reach) ? marks.ink : marks.join, 2 * pixel);
    context.setLineDash([]);
  }
}
