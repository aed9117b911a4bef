import type { Join, Point } from '../document/document';
import { addJoin, joinOfLine, removeJoin } from '../document/editing';
import { distance } from '../document/outline';
import { partAt } from '../document/picking';
import { pairAt, relationOf, turnRelation } from '../document/relations';
import { joinAt, suggestedJoins } from '../document/suggestions';
import { marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import type { Tool, ToolHost } from './tool';

/**
 * Joins parts by a line across a root or a tap on a suggestion. A tap on a join separates its parts; a
 * tap on another outline switches the relation of the parts that meet there.
 */
export class JoinTool implements Tool {
  cursor = 'crosshair';
  private line: Point[] = [];

  constructor(private readonly host: ToolHost) {}

  down(point: Point): void {
    this.line = [point];
  }

  move(point: Point, pressed: boolean): void {
    if (pressed) this.line.push(point);
    else {
      const { document, reach } = this.host;
      const near = this.joinNear(point) ?? pairAt(document, point, reach);
      this.cursor = near ? 'pointer' : 'crosshair';
      this.host.hover(near?.upper ?? partAt(document, point)?.id ?? null);
    }
  }

  up(): void {
    const { document } = this.host;
    const spot = this.tapped();
    const join = spot ? this.joinNear(spot) : this.proposed();
    this.line = [];
    if (spot && !join) this.turnRelation(spot);
    if (!join) return;
    const isThere = document.joins.includes(join);
    this.host.edit('join', isThere ? removeJoin(document, join.upper, join.lower) : addJoin(document, join));
    this.host.select(join.upper);
  }

  cancel(): void {
    this.line = [];
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    if (this.line.length < 2) {
      this.drawSuggestions(context, pixel);
      return;
    }
    strokeLine(context, this.line, 'rgb(47 111 237 / 45%)', 2 * pixel);
    const join = this.proposed();
    if (join) strokeLine(context, join.line, marks.join, 5 * pixel);
  }

  private drawSuggestions(context: CanvasRenderingContext2D, pixel: number): void {
    context.setLineDash([7 * pixel, 6 * pixel]);
    for (const { line } of suggestedJoins(this.host.document)) {
      strokeLine(context, line, 'rgb(255 255 255 / 70%)', 6 * pixel);
      strokeLine(context, line, 'rgb(47 111 237 / 60%)', 3 * pixel);
    }
    context.setLineDash([]);
  }

  /** Returns the position of the pen if it did not move, else null. */
  private tapped(): Point | null {
    const [first] = this.line;
    return first && this.line.every((point) => distance(point, first) < this.host.reach / 2) ? first : null;
  }

  /** Returns the suggestion or join near a point, or null. */
  private joinNear(point: Point): Join | null {
    const { document, reach } = this.host;
    return joinAt([...suggestedJoins(document), ...document.joins], point, reach);
  }

  /** Switches the relation of the parts that meet at an outline. */
  private turnRelation(point: Point): void {
    const pair = pairAt(this.host.document, point, this.host.reach);
    if (!pair) return;
    this.host.edit('relation', turnRelation(this.host.document, pair));
    this.host.select(pair.upper);
    this.host.tellRelation(pair, relationOf(this.host.document, pair));
  }

  private proposed() {
    const first = this.line[0];
    const last = this.line[this.line.length - 1];
    if (!first || !last || distance(first, last) < this.host.reach / 2) return null;
    return joinOfLine(this.host.document, this.line, 4 * this.host.reach);
  }
}
