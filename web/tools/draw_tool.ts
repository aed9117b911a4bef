import type { Point } from '../document/document';
import { distance } from '../document/outline';
import { type Drawn, drawStroke, type Hand, isClosed, previewStroke } from '../document/strokes';
import { marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import type { Modifiers, Tool, ToolHost } from './tool';

/** Every stroke makes something; see drawStroke. */
export class DrawTool implements Tool {
  readonly cursor = 'crosshair';
  private stroke: Point[] = [];
  /** Where the pen was when the relief last showed what it draws. */
  private shownAt: Point | null = null;

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
    if (distance(this.stroke[this.stroke.length - 1] as Point, point) <= this.host.reach / 6) return;
    this.stroke.push(point);
    const last = this.shownAt ?? (this.stroke[0] as Point);
    if (distance(last, point) < this.host.reach) return;
    this.shownAt = point;
    this.host.preview(previewStroke(this.host.document, this.hand(false), this.stroke));
  }

  up(_point: Point, keys: Modifiers): void {
    const { stroke } = this;
    this.stroke = [];
    if (stroke.length > 0) this.make(drawStroke(this.host.document, this.hand(keys.shift), stroke));
    // Only now, so that the relief goes from what was shown to what was made.
    this.cancel();
  }

  cancel(): void {
    this.stroke = [];
    this.shownAt = null;
    this.host.preview(null);
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
    if (this.stroke.length < 2) return;
    strokeLine(context, this.stroke, marks.ink, 3 * pixel);
    const first = this.stroke[0] as Point;
    const last = this.stroke[this.stroke.length - 1] as Point;
    context.setLineDash([6 * pixel, 6 * pixel]);
    strokeLine(context, [last, first], isClosed(this.host.document, this.stroke, this.host.reach) ? marks.ink : marks.join, 2 * pixel);
    context.setLineDash([]);
  }
}
