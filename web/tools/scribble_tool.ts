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

/**
 * The kind of brush: `auto` chooses the part of a stroke itself, `part` draws for a given part, `outside` and
 * `hole` mark background, the others remove and move strokes.
 */
export type BrushKind = 'auto' | 'part' | 'outside' | 'hole' | 'erase' | 'move';

export interface Brush {
  readonly kind: BrushKind;
  /** The part of the brush `part`. */
  readonly part: string | null;
  /** CSS px. */
  readonly width: number;
  /** Whether strokes are soft, so that areas that mostly belong to other parts overrule them. */
  readonly soft: boolean;
}

/** What the tool needs besides ToolHost: the brush, the labels, and the interpretation of strokes. */
export interface ScribbleHost {
  readonly brush: Brush;
  /** The document with all queued strokes. */
  readonly pending: Document;
  readonly tint: ImageBitmap | null;
  /** Closed gaps that the user has not decided, and the chosen one. */
  readonly gaps: readonly Gap[];
  readonly gap: Gap | null;
  chooseGap(gap: Gap): void;
  /** Shows the labels of a document, until the next call or `drop`. */
  show(document: Document): void;
  /** Shows the labels of the queued strokes again. */
  drop(): void;
  /** Queues a change of strokes, which becomes a step of the document. */
  wish(label: string, change: (document: Document) => Document): void;
  /** Tells the user why a stroke was ignored: there is no picture to scribble on, or only paper under it. */
  refuse(reason: 'noScribbles' | 'paperStroke'): void;
  /** Returns whether the picture is empty at a point. */
  isPaper(point: Point): boolean;
}

/** Returns the dashes of a stroke: soft strokes are dotted, holes dashed. */
function dashOf({ kind }: Stroke, width: number): number[] {
  return kind === 'hole' ? [width, 2 * width] : kind === 'soft' ? [0, 1.4 * width] : [];
}

/** Marks parts by strokes over a flat drawing. Strokes of one colour mark one part. */
export class ScribbleTool implements Tool {
  private points: Point[] = [];
  private part: string | undefined;
  private kind: StrokeKind | 'erase' = 'hard';
  private at: Point | null = null;
  /** The closed gap on which the stroke began. */
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
    // Looks for it now, since the gaps change as soon as the stroke is shown.
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
    const counted = this.counted(this.points);
    if (counted.length === 0) {
      this.cancel();
      this.scribbles.refuse('paperStroke');
      return;
    }
    const change = this.change(simplify(counted, this.host.reach / 12));
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

  /** Moves the brush with arrows; Enter puts it down and lifts it. */
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
    const drawn = this.points.length > 0 && this.kind !== 'erase' ? this.change(this.counted(this.points))(pending) : pending;
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

  /** Returns the stretch of a stroke that counts: strokes for a part do not count on empty paper. */
  private counted(points: readonly Point[]): readonly Point[] {
    return this.kind === 'hard' || this.kind === 'soft' ? offPaper(points, (point) => this.scribbles.isPaper(point)) : points;
  }

  private get moves(): boolean {
    return this.scribbles.brush.kind === 'move';
  }

  private strokeKind({ kind, soft }: Brush): StrokeKind | 'erase' {
    if (kind === 'outside' || kind === 'hole' || kind === 'erase') return kind;
    return soft ? 'soft' : 'hard';
  }

  /** Asks about a closed gap that was clicked, instead of making a dot. Returns whether there was one. */
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
    this.scribbles.show(this.change(this.counted(this.points))(this.scribbles.pending));
  }

  /**
   * Returns the change that the stroke makes to a document. It applies to the document at the time when the
   * engine handles it.
   */
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
