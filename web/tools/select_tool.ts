import type { Document, Part, Point } from '../document/document';
import { isMovable, shiftPart } from '../document/editing';
import { partAt, partBelow } from '../document/picking';
import { marks } from '../view/colors';
import { drawDot } from '../view/paper_view';
import { type Handle, handleAt, handlesOf, slide } from './handles';
import { arrows, type Modifiers, type Tool, type ToolHost } from './tool';

type Gesture =
  | { kind: 'none' }
  | { kind: 'slide'; handle: Handle; before: Document }
  | { kind: 'move'; part: Part; from: Point; before: Document };

/** Selects parts, slides the ends of joins and ranges, and moves parts that were drawn by hand. */
export class SelectTool implements Tool {
  cursor = 'default';
  private gesture: Gesture = { kind: 'none' };
  private count = 0;

  constructor(private readonly host: ToolHost) {}

  down(point: Point, keys: Modifiers): void {
    const { document, selected, reach } = this.host;
    const handle = handleAt(handlesOf(document, selected), point, reach);
    this.count++;
    if (handle) {
      this.gesture = { kind: 'slide', handle, before: document };
      return;
    }
    const part = partBelow(document, point, selected, keys.alt);
    this.host.select(part?.id ?? null);
    if (part && isMovable(document, part.id)) this.gesture = { kind: 'move', part, from: point, before: document };
  }

  move(point: Point, pressed: boolean): void {
    const { document, selected, reach } = this.host;
    const gesture = this.gesture;
    if (pressed && gesture.kind === 'slide')
      this.host.edit('slide', slide(gesture.before, gesture.handle, point), `slide ${this.count}`);
    else if (pressed && gesture.kind === 'move') this.shift(gesture, point);
    if (pressed) return;
    this.cursor = handleAt(handlesOf(document, selected), point, reach) ? 'grab' : 'default';
    this.host.hover(partAt(document, point)?.id ?? null);
  }

  up(): void {
    this.gesture = { kind: 'none' };
  }

  cancel(): void {
    if (this.gesture.kind !== 'none') this.host.edit('cancel', this.gesture.before, `${this.gesture.kind} ${this.count}`);
    this.gesture = { kind: 'none' };
  }

  /** Moves the selected part with arrows if it can be moved. */
  key(name: string, keys: Modifiers): boolean {
    const { document, selected } = this.host;
    const way = arrows[name];
    if (!way || selected === null || !isMovable(document, selected)) return false;
    const size = keys.shift ? 10 : 1;
    this.host.edit('move', shiftPart(document, selected, [size * way[0], size * way[1]]), `move keys ${selected}`);
    return true;
  }

  draw(context: CanvasRenderingContext2D, pixel: number): void {
    const { document, selected } = this.host;
    for (const handle of handlesOf(document, selected)) {
      const rim = handle.kind === 'join' ? marks.join : handle.end === 'first' ? '#3a9d4a' : '#d6402f';
      drawDot(context, handle.point, { radius: 5.5, fill: '#fff', rim, width: 2.5 }, pixel);
    }
  }

  private shift({ before, part, from }: Gesture & { kind: 'move' }, [x, y]: Point): void {
    this.host.edit('move', shiftPart(before, part.id, [x - from[0], y - from[1]]), `move ${this.count}`);
  }
}
