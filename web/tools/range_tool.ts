import { type Part, partIndex, type Point } from '../document/document';
import { addRange } from '../document/editing';
import { arcBetween, nearestPlace, type OutlinePlace } from '../document/outline';
import { rampColor } from '../view/colors';
import { drawDot, strokeLine } from '../view/paper_view';
import type { Tool, ToolHost } from './tool';

/** Makes a soft range by two clicks on an outline: soft at the first, firm at the second, as in the paper. */
export class RangeTool implements Tool {
  readonly cursor = 'crosshair';
  private from: { part: Part; place: OutlinePlace } | null = null;
  private at: { part: Part; place: OutlinePlace } | null = null;

  constructor(private readonly host: ToolHost) {}

  down(point: Point): void {
    const found = this.nearest(point, this.from?.part);
    if (!found) return;
    if (!this.from) {
      this.from = found;
      this.host.select(found.part.id);
      return;
    }
    const { document } = this.host;
    this.host.edit('range', addRange(document, this.from.part.id, this.from.place.point, found.place.point));
    this.cancel();
  }

  move(point: Point): void {
    this.at = this.nearest(point, this.from?.part);
    if (!this.from) this.host.hover(this.at?.part.id ?? null);
  }

  up(): void {}

  cancel(): void {
    this.from = this.at = null;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    const place = this.at?.place;
    if (this.from && place) this.drawArc(context, arcBetween(this.from.part.outline, this.from.place, place), pixel);
    for (const [end, fill] of [[this.from?.place, '#3a9d4a'], [place, this.from ? '#d6402f' : '#3a9d4a']] as const)
      if (end) drawDot(context, end.point, { radius: 6, fill, rim: '#fff', width: 2 }, pixel);
  }

  /** Returns the nearest place on the outline of `only` or, within reach, of the selected part or of any part. */
  private nearest(point: Point, only: Part | undefined): { part: Part; place: OutlinePlace } | null {
    const { document, selected, reach } = this.host;
    const chosen = only ?? document.parts[selected === null ? -1 : partIndex(document, selected)];
    const near = (part: Part) => ({ part, place: nearestPlace(part.outline, point) });
    if (chosen) {
      const found = near(chosen);
      if (only || found.place.distance < reach) return found;
    }
    return (
      document.parts
        .map(near)
        .filter((found) => found.place.distance < reach)
        .sort((a, b) => a.place.distance - b.place.distance)[0] ?? null
    );
  }

  private drawArc(context: CanvasRenderingContext2D, arc: readonly Point[], pixel: number): void {
    for (let i = 0; i + 1 < arc.length; i++)
      strokeLine(context, arc.slice(i, i + 2), rampColor(i / arc.length), 5 * pixel);
  }
}
