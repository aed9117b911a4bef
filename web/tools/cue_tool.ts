import { addCue, cueOfStroke } from '../document/cues';
import type { Cue, Point } from '../document/document';
import { distance } from '../document/outline';
import { partAt } from '../document/picking';
import { marks } from '../view/colors';
import { drawDot, strokeLine } from '../view/paper_view';
import type { Tool, ToolHost } from './tool';

const colors: Readonly<Record<Cue['kind'], string>> = { bulge: '#b0520a', slope: '#3a7d34', crease: '#6a3fb5' };

/** Draws lines on parts that change their profile: rounder along the line, rising in its direction, or folded. */
export class CueTool implements Tool {
  readonly cursor = 'crosshair';
  private stroke: Point[] = [];

  constructor(private readonly host: ToolHost, private readonly next: () => Pick<Cue, 'kind' | 'value'>) {}

  down(point: Point): void {
    this.stroke = [point];
  }

  move(point: Point, pressed: boolean): void {
    const last = this.stroke.at(-1);
    if (!pressed) this.host.hover(partAt(this.host.document, point)?.id ?? null);
    else if (last && distance(last, point) > this.host.reach / 6) this.stroke.push(point);
  }

  up(): void {
    const { stroke } = this;
    this.stroke = [];
    const cue = cueOfStroke(this.host.document, this.next(), stroke, this.host.reach);
    if (!cue) {
      this.host.refuse('cueOffPart');
      return;
    }
    this.host.edit('cue', addCue(this.host.document, cue));
    this.host.select(cue.part);
  }

  cancel(): void {
    this.stroke = [];
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    for (const { kind, line } of this.host.document.cues) {
      strokeLine(context, line, '#fff', 6 * pixel);
      strokeLine(context, line, colors[kind], 3 * pixel);
      const tip = line.at(-1);
      if (kind === 'slope' && tip) drawDot(context, tip, { radius: 5, fill: colors[kind], rim: '#fff', width: 2 }, pixel);
    }
    if (this.stroke.length > 1) strokeLine(context, this.stroke, marks.ink, 3 * pixel);
  }
}
