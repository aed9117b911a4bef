import type { Document, Point } from '../document/document';
import { type Gap, gapAt, sameGap } from '../document/gaps';
import { distance, rounded, simplify } from '../document/outline';
import { offPaper } from '../document/paper';
import { addStroke, canScribble, eraseStrokes, foundPartAt, labelOfStroke, partOfStroke, scribblesOf } from '../document/scribbling';
import type { Stroke, StrokeKind } from '../document/segmentation';
import { inkOf, marks } from '../view/colors';
import { strokeLine } from '../view/paper_view';
import { traceLine } from '../view/trace';
import { StrokeMover } from './stroke_mover';
import { type Modifiers, penMoved, type Tool, type ToolHost } from './tool';

/** What the brush says: by itself, for one part, for the background, or nothing any more; or it moves strokes. */
export type BrushKind = 'auto' | 'part' | 'outside' | 'hole' | 'erase' | 'move';

export interface Brush {
  readonly kind: BrushKind;
  /** Of 'part': whose strokes it makes. */
  readonly part: string | null;
  /** CSS px. */
  readonly width: number;
  /** Whether lines may overrule strokes for parts. */
  readonly soft: boolean;
}

/** What the tool needs besides: a brush, and someone who understands strokes. */
export interface ScribbleHost {
  readonly brush: Brush;
  /** The document with strokes that wait to be understood. */
  readonly pending: Document;
  readonly tint: ImageBitmap | null;
  /** Closed gaps of which nothing has been said, and the one that is chosen. */
  readonly gaps: readonly Gap[];
  readonly gap: Gap | null;
  chooseGap(gap: Gap): void;
  /** Shows what a document would be, until the next or `done`. */
  show(document: Document): void;
  /** Nothing is being drawn any more. */
  drop(): void;
  /** Makes a change of strokes a step of the document. */
  wish(label: string, change: (document: Document) => Document): void;
  /** Says why a stroke says nothing: that there is no picture to scribble on, or nothing but paper under it. */
  refuse(reason: 'noScribbles' | 'paperStroke'): void;
  /** Whether the picture shows nothing at a point. */
  isPaper(point: Point): boolean;
}

/** Soft strokes are dotted, holes dashed. */
function dashOf({ kind }: Stroke, width: number): number[] {
  return kind === 'hole' ? [width, 2 * width] : kind === 'soft' ? [0, 1.4 * width] : [];
}

/** A stroke says what belongs together; strokes of one colour are one part. */
export class ScribbleTool implements Tool {
  private points: Point[] = [];
  private part: string | undefined;
  private kind: StrokeKind | 'erase' = 'hard';
  private at: Point | null = null;
  /** The closed gap on which the stroke begins. */
  private asked: Gap | undefined;
  private readonly mover: StrokeMover;

  constructor(private readonly host: ToolHost, private readonly scribbles: ScribbleHost) {
    this.mover = new StrokeMover(host, scribbles);
  }

  get cursor(): string {
    return this.moves ? 'move' : 'crosshair';
  }

  down(point: Point, keys: Modifiers): void {
    if (!canScribble(this.host.document)) {
      this.scribbles.refuse('noScribbles');
      return;
    }
    const { brush } = this.scribbles;
    if (this.moves) {
      this.mover.down(point);
      return;
    }
    this.kind = keys.alt ? 'erase' : this.strokeKind(brush);
    // The gaps change as soon as the stroke is shown.
    this.asked = this.kind === 'erase' ? undefined : gapAt(this.scribbles.gaps, point, this.host.reach);
    this.points = [point];
    this.part = keys.shift ? foundPartAt(this.scribbles.pending, point) : brush.kind === 'part' ? brush.part ?? undefined : undefined;
    this.show();
  }

  move(point: Point, pressed: boolean): void {
    this.at = point;
    if (this.moves) {
      if (pressed) this.mover.move(point);
      return;
    }
    if (!pressed || this.points.length === 0) return;
    const last = this.points[this.points.length - 1] as Point;
    if (Math.hypot(point[0] - last[0], point[1] - last[1]) < this.host.reach / 6) return;
    this.points.push(point);
    this.show();
  }

  up(): void {
    this.mover.up();
    if (this.points.length === 0 || this.choseGap()) return;
    const said = this.saying(this.points);
    if (said.length === 0) {
      this.cancel();
      this.scribbles.refuse('paperStroke');
      return;
    }
    const change = this.change(simplify(said, this.host.reach / 12));
    const label = this.kind === 'erase' ? 'erase' : 'scribble';
    this.points = [];
    this.scribbles.wish(label, change);
  }

  cancel(): void {
    this.mover.cancel();
    if (this.points.length === 0) return;
    this.points = [];
    this.scribbles.drop();
  }

  /** Arrows move the brush, Enter sets it down and lifts it. */
  key(name: string, keys: Modifiers): boolean {
    if (this.moves) return this.mover.key(name, keys.shift);
    const { width, height } = this.host.document;
    const [x, y] = this.at ?? [width / 2, height / 2];
    if (name === 'Enter') {
      this.at = [x, y];
      if (this.points.length > 0) this.up();
      else this.down([x, y], keys);
      return true;
    }
    const next = penMoved([x, y], name, keys.shift, this.host);
    if (next) this.move(next, true);
    return next !== null;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    const { pending, tint, brush } = this.scribbles;
    const { width, height } = pending;
    if (tint) context.drawImage(tint, 0, 0, width, height);
    const drawn = this.points.length > 0 && this.kind !== 'erase' ? this.change(this.saying(this.points))(pending) : pending;
    const shown = this.mover.moved(drawn);
    context.lineCap = context.lineJoin = 'round';
    for (const stroke of scribblesOf(shown).strokes) this.drawStroke(context, shown, stroke, pixel);
    this.drawGaps(context, pixel);
    const chosen = this.moves && this.mover.shown;
    if (chosen) strokeLine(context, chosen.points, marks.select, 2.5 * pixel);
    if (!this.at || this.moves) return;
    context.beginPath();
    context.arc(this.at[0], this.at[1], (brush.width / 2) * pixel, 0, 2 * Math.PI);
    context.strokeStyle = brush.kind === 'erase' ? marks.culprit : marks.ink;
    context.lineWidth = 1.5 * pixel;
    context.stroke();
  }

  /** What of a stroke says something: one for a part does not where it runs over nothing but paper. */
  private saying(points: readonly Point[]): readonly Point[] {
    return this.kind === 'hard' || this.kind === 'soft' ? offPaper(points, (point) => this.scribbles.isPaper(point)) : points;
  }

  private get moves(): boolean {
    return this.scribbles.brush.kind === 'move';
  }

  private strokeKind({ kind, soft }: Brush): StrokeKind | 'erase' {
    if (kind === 'outside' || kind === 'hole' || kind === 'erase') return kind;
    return soft ? 'soft' : 'hard';
  }

  /** A click on a closed gap asks about it instead of making a dot. */
  private choseGap(): boolean {
    const { asked } = this;
    const [first] = this.points;
    if (!asked || !this.points.every((point) => distance(point, first as Point) < this.host.reach / 2)) return false;
    this.cancel();
    this.scribbles.chooseGap(asked);
    return true;
  }

  private drawGaps(context: CanvasRenderingContext2D, pixel: number): void {
    const { gaps, gap } = this.scribbles;
    for (const one of gaps) {
      const chosen = sameGap([one], gap) !== undefined;
      strokeLine(context, one.points, 'rgb(255 255 255 / 85%)', (chosen ? 9 : 6) * pixel);
      strokeLine(context, one.points, marks.gap, (chosen ? 5 : 3) * pixel);
    }
  }

  private show(): void {
    this.scribbles.show(this.change(this.saying(this.points))(this.scribbles.pending));
  }

  /** What the stroke does to a document, whichever is there when it comes to be understood. */
  private change(points: readonly Point[]): (document: Document) => Document {
    const { kind, part } = this;
    const { reach } = this.host;
    const width = Math.max(1, (this.scribbles.brush.width * reach) / 12);
    const line = points.map((p) => rounded(p, 10));
    if (line.length === 0) return (document) => document;
    if (kind === 'erase') return (document) => eraseStrokes(document, line, width / 2);
    if (kind === 'outside' || kind === 'hole') return (document) => addStroke(document, { kind, width, points: line });
    return (document) =>
      addStroke(document, { kind, part: part ?? partOfStroke(document, line, reach / 2), width, points: line });
  }

  private drawStroke(context: CanvasRenderingContext2D, document: Document, stroke: Stroke, pixel: number): void {
    const label = labelOfStroke(document, stroke);
    traceLine(context, stroke.points);
    const width = Math.max(stroke.width, 3 * pixel);
    for (const [color, extra, dash] of [
      ['#fff', 3 * pixel, []],
      [label === undefined ? marks.ink : inkOf(label), 0, dashOf(stroke, width)],
    ] as const) {
      context.strokeStyle = color;
      context.lineWidth = width + extra;
      context.setLineDash([...dash]);
      context.stroke();
    }
    context.setLineDash([]);
  }
}
