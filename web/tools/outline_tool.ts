import { type Document, type Part, partIndex, type Point } from '../document/document';
import { distance, nearestPlace, type OutlinePlace, simplify, smooth } from '../document/outline';
import { partAt, partBelow } from '../document/picking';
import { grips, pushOutline, type Refusal, redrawOutline, type Reshaped } from '../document/reshape';
import { marks } from '../view/colors';
import { dashHidden, drawDot, strokeLine } from '../view/paper_view';
import { arrows, type Modifiers, type Tool, type ToolHost } from './tool';

/** Distance between grips, and radius of a push along the outline, in reaches of the hand. */
const spacing = 4;
const pushRadius = 7;

type Gesture =
  | { kind: 'none' }
  | { kind: 'push'; part: Part; place: OutlinePlace; radius: number; before: Document; refused: Refusal | null }
  | { kind: 'redraw'; part: Part; stroke: Point[] };

/**
 * Corrects the outline of the selected part, including its hidden stretches. Dragging a grip pushes the
 * outline; a stroke from outline to outline replaces the stretch between its ends.
 */
export class OutlineTool implements Tool {
  cursor = 'default';
  private gesture: Gesture = { kind: 'none' };
  private count = 0;
  /** The grip nearest to this point is the one that keys move. */
  private focus: Point = [0, 0];

  constructor(private readonly host: ToolHost) {}

  down(point: Point, keys: Modifiers): void {
    const { document, selected, reach } = this.host;
    this.count++;
    const part = this.part();
    const place = part && nearestPlace(part.outline, point);
    const grip = this.gripAt(point);
    if (part && grip)
      this.gesture = { kind: 'push', part, place: grip, radius: pushRadius * reach, before: document, refused: null };
    else if (part && place && place.distance < reach) this.gesture = { kind: 'redraw', part, stroke: [place.point] };
    else this.host.select(partBelow(document, point, selected, keys.alt)?.id ?? null);
  }

  move(point: Point, pressed: boolean): void {
    const { gesture } = this;
    if (gesture.kind === 'push') this.push(gesture, point);
    else if (gesture.kind === 'redraw') {
      const last = gesture.stroke[gesture.stroke.length - 1] as Point;
      if (distance(last, point) > this.host.reach / 6) gesture.stroke.push(point);
    } else if (!pressed) {
      const part = this.part();
      const near = part && nearestPlace(part.outline, point).distance < this.host.reach;
      this.cursor = this.gripAt(point) ? 'grab' : near ? 'crosshair' : 'default';
      this.host.hover(near ? null : (partAt(this.host.document, point)?.id ?? null));
    }
  }

  up(point: Point): void {
    const { gesture } = this;
    this.gesture = { kind: 'none' };
    this.focus = point;
    if (gesture.kind === 'push' && gesture.refused) this.host.refuse(gesture.refused);
    if (gesture.kind === 'redraw') this.redraw(gesture.part, gesture.stroke);
  }

  cancel(): void {
    if (this.gesture.kind === 'push') this.host.edit('cancel', this.gesture.before, `outline ${this.count}`);
    this.gesture = { kind: 'none' };
  }

  /** Chooses a grip with comma and full stop and pushes it with arrows. The chosen grip is filled. */
  key(name: string, keys: Modifiers): boolean {
    const part = this.part();
    const all = part ? this.grips(part) : [];
    if (!part || all.length === 0) return false;
    const turn = { '.': 1, ',': -1 }[name];
    if (turn !== undefined) {
      const at = all.indexOf(this.nearest(all, this.focus) as OutlinePlace);
      this.focus = (all[(at + turn + all.length) % all.length] as OutlinePlace).point;
      return true;
    }
    const step = arrows[name];
    const place = this.nearest(all, this.focus);
    if (!step || !place) return false;
    const size = keys.shift ? 10 : 1;
    const by: Point = [size * step[0], size * step[1]];
    const { document, reach } = this.host;
    this.take(pushOutline(document, part.id, place, pushRadius * reach, by), `outline keys ${part.id}`);
    this.focus = [place.point[0] + by[0], place.point[1] + by[1]];
    return true;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    const { gesture } = this;
    const part = this.part();
    if (!part) return;
    dashHidden(context, this.host.document.parts, part.id, pixel);
    if (gesture.kind === 'redraw') strokeLine(context, gesture.stroke, marks.ink, 3 * pixel);
    const all = this.grips(part);
    const focused = this.nearest(all, this.focus);
    for (const grip of all) {
      const idle = gesture.kind === 'none';
      const fill = grip === focused && idle ? marks.select : '#fff';
      drawDot(context, grip.point, { radius: idle ? 4.5 : 3, fill, rim: marks.select, width: 2 }, pixel);
    }
  }

  private part(): Part | undefined {
    const { document, selected } = this.host;
    return document.parts[selected === null ? -1 : partIndex(document, selected)];
  }

  private grips(part: Part): OutlinePlace[] {
    return grips(part.outline, spacing * this.host.reach);
  }

  private nearest(all: readonly OutlinePlace[], point: Point): OutlinePlace | undefined {
    const gaps = all.map((grip) => distance(grip.point, point));
    return all[gaps.indexOf(Math.min(...gaps))];
  }

  private gripAt(point: Point): OutlinePlace | null {
    const part = this.part();
    const grip = part && this.nearest(this.grips(part), point);
    return grip && distance(grip.point, point) < this.host.reach ? grip : null;
  }

  private push(gesture: Gesture & { kind: 'push' }, point: Point): void {
    const { place, part, radius, before } = gesture;
    const by: Point = [point[0] - place.point[0], point[1] - place.point[1]];
    const next = pushOutline(before, part.id, place, radius, by);
    gesture.refused = 'refused' in next ? next.refused : null;
    if ('document' in next) this.host.edit('outline', next.document, `outline ${this.count}`);
  }

  private redraw(part: Part, stroke: readonly Point[]): void {
    const { document, reach } = this.host;
    const first = stroke[0] as Point;
    const last = nearestPlace(part.outline, stroke[stroke.length - 1] as Point);
    if (stroke.length < 3) return;
    if (last.distance > 1.5 * reach || distance(first, last.point) < reach / 2) {
      this.host.refuse('endsOffOutline');
      return;
    }
    const line = smooth(simplify([...stroke.slice(0, -1), last.point], reach / 10), false);
    this.take(redrawOutline(document, part.id, line));
  }

  private take(next: Reshaped, gesture?: string): void {
    if ('refused' in next) this.host.refuse(next.refused);
    else this.host.edit('outline', next.document, gesture);
  }
}
