import type { Document, Part, Point, Ring } from '../document/document';
import type { Doubt } from '../document/doubts';
import { hiddenOutline } from '../document/hidden';
import type { Overlays } from '../engine/messages';
import { marks, rampColor } from './colors';
import { drawAdded, drawPaint } from './paint_view';
import { type Context, traceLine, tracePart } from './trace';
import type { Viewport } from './viewport';

/** Everything that the canvas of the drawing shows. */
interface PaperContent {
  document: Document;
  picture: ImageBitmap | null;
  overlays: Overlays | null;
  selected: string | null;
  hovered: string | null;
  culprit: string | null;
  /** The guess that the user is asked about. */
  doubt: Doubt | null;
  depthTint: boolean;
  showMarks: boolean;
  dark: boolean;
  /** Draws what the current tool shows, in canvas px. */
  preview(context: CanvasRenderingContext2D, pixel: number): void;
}

/** Draws a line with round ends and corners; `width` is in canvas px. */
export function strokeLine(context: CanvasRenderingContext2D, line: Ring, color: string, width: number): void {
  traceLine(context, line);
  context.lineJoin = context.lineCap = 'round';
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}

interface Dot {
  readonly radius: number;
  readonly fill: string;
  readonly rim: string;
  readonly width: number;
}

/** Draws a round mark; its lengths are in CSS px. */
export function drawDot(context: CanvasRenderingContext2D, [x, y]: Point, { radius, fill, rim, width }: Dot, pixel: number): void {
  context.beginPath();
  context.arc(x, y, radius * pixel, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.lineWidth = width * pixel;
  context.strokeStyle = rim;
  context.stroke();
}

/**
 * Paints the parts in flat colours, in place of a drawing. There is no ink along joins, since joined
 * parts are one surface.
 */
function paintParts(context: Context, document: Pick<Document, 'parts' | 'joins' | 'settings'>, pen: number): void {
  const { inkColor, inkWidth } = document.settings;
  context.lineJoin = 'round';
  for (const part of document.parts) {
    const color = part.color ?? '#d9d4c7';
    tracePart(context, part.outline);
    context.fillStyle = color;
    context.fill('nonzero');
    if (inkWidth === 0) continue;
    context.strokeStyle = inkColor;
    context.lineWidth = pen * inkWidth;
    context.stroke();
    context.strokeStyle = color;
    context.lineWidth = 1.6 * pen * inkWidth;
    for (const join of document.joins)
      if (join.upper === part.id) {
        traceLine(context, join.line);
        context.stroke();
      }
  }
}

function segments(context: CanvasRenderingContext2D, ends: Float32Array, color: string, width: number): void {
  context.beginPath();
  for (let i = 0; i < ends.length; i += 4) {
    context.moveTo(ends[i] as number, ends[i + 1] as number);
    context.lineTo(ends[i + 2] as number, ends[i + 3] as number);
  }
  context.strokeStyle = color;
  context.lineWidth = width;
  context.lineCap = 'round';
  context.stroke();
}

function drawMarks(context: CanvasRenderingContext2D, overlays: Overlays, pixel: number): void {
  segments(context, overlays.above, marks.above, 1.6 * pixel);
  segments(context, overlays.below, marks.below, 1.6 * pixel);
  segments(context, overlays.equal, marks.equal, 2.4 * pixel);
  segments(context, overlays.joins, marks.join, 3.2 * pixel);
  const { ramps } = overlays;
  for (let i = 0; i < ramps.length; i += 6) {
    const alpha = ((ramps[i + 4] as number) + (ramps[i + 5] as number)) / 2;
    segments(context, ramps.subarray(i, i + 4), rampColor(alpha), 3.2 * pixel);
  }
}

function drawPage(context: CanvasRenderingContext2D, content: PaperContent, pixel: number): void {
  const { document, picture } = content;
  context.fillStyle = content.dark ? '#f4f1ea' : '#fffdf8';
  context.fillRect(0, 0, document.width, document.height);
  context.strokeStyle = content.dark ? 'rgb(0 0 0 / 60%)' : 'rgb(60 50 30 / 16%)';
  context.lineWidth = pixel;
  context.strokeRect(0, 0, document.width, document.height);
  drawContent(context, document, picture, 2 * pixel);
}

/** Draws the drawing, or the parts in flat colours if there is none, and everything drawn and painted over it. */
export function drawContent(context: Context, document: Pick<Document, 'width' | 'height' | 'parts' | 'joins' | 'paint' | 'settings'>, picture: ImageBitmap | null, pen: number): void {
  if (picture) {
    context.drawImage(picture, 0, 0, document.width, document.height);
    drawAdded(context, document, pen);
  } else paintParts(context, document, pen);
  drawPaint(context, document.paint);
}

/** Draws nearer parts lighter, as in the paper's figure 3. */
function drawDepths(context: CanvasRenderingContext2D, parts: readonly Part[], pixel: number): void {
  parts.forEach((part, i) => {
    const light = 32 + (56 * (i + 1)) / parts.length;
    tracePart(context, part.outline);
    context.fillStyle = `hsl(38 28% ${light}% / 92%)`;
    context.fill('nonzero');
    context.strokeStyle = 'rgb(60 50 40 / 55%)';
    context.lineWidth = pixel;
    context.stroke();
  });
}

function drawPart(context: CanvasRenderingContext2D, part: Part, color: string, strong: boolean, pixel: number): void {
  tracePart(context, part.outline);
  context.globalAlpha = strong ? 0.16 : 0.1;
  context.fillStyle = color;
  context.fill('nonzero');
  context.globalAlpha = 1;
  context.lineJoin = 'round';
  context.strokeStyle = 'rgb(255 255 255 / 85%)';
  context.lineWidth = (strong ? 5 : 3.5) * pixel;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = (strong ? 2.4 : 1.6) * pixel;
  context.stroke();
}

/** Draws dashes along the hidden stretches of a part's outline. */
export function dashHidden(context: CanvasRenderingContext2D, parts: readonly Part[], id: string, pixel: number): void {
  context.lineCap = 'butt';
  for (const [dash, color, width] of [[[], '#fff', 3.2], [[5 * pixel, 4 * pixel], marks.select, 2]] as const) {
    context.setLineDash([...dash]);
    context.strokeStyle = color;
    context.lineWidth = width * pixel;
    for (const line of hiddenOutline(parts, id)) {
      traceLine(context, line);
      context.stroke();
    }
  }
  context.setLineDash([]);
}

/** Draws the two parts that a guess is about in two colours, and their join. */
function drawDoubt(context: CanvasRenderingContext2D, { parts, joins }: Document, doubt: Doubt, pixel: number): void {
  if (doubt.kind === 'gap') return;
  for (const part of parts)
    if (part.id === doubt.upper) drawPart(context, part, marks.select, true, pixel);
    else if (part.id === doubt.lower) drawPart(context, part, marks.above, true, pixel);
  const join = doubt.kind === 'join' && joins.find(({ upper, lower }) => upper === doubt.upper && lower === doubt.lower);
  if (!join) return;
  strokeLine(context, join.line, '#fff', 9 * pixel);
  strokeLine(context, join.line, marks.join, 5.5 * pixel);
}

/** Draws everything. `ratio` is the number of device px per CSS px. */
export function drawPaper(
  context: CanvasRenderingContext2D,
  content: PaperContent,
  view: Viewport,
  ratio: number,
): void {
  const { canvas } = context;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.setTransform(ratio * view.scale, 0, 0, ratio * view.scale, ratio * view.x, ratio * view.y);
  const pixel = 1 / view.scale;
  const { document } = content;
  drawPage(context, content, pixel);
  if (content.depthTint) drawDepths(context, document.parts, pixel);
  for (const part of document.parts) {
    if (part.id === content.culprit) drawPart(context, part, marks.culprit, true, pixel);
    else if (part.id === content.selected) drawPart(context, part, marks.select, true, pixel);
    else if (part.id === content.hovered) drawPart(context, part, marks.select, false, pixel);
  }
  if (content.selected !== null) dashHidden(context, document.parts, content.selected, pixel);
  if (content.showMarks && content.overlays) drawMarks(context, content.overlays, pixel);
  if (content.doubt) drawDoubt(context, document, content.doubt, pixel);
  content.preview(context, pixel);
}

/** Draws a whole document on a small canvas: its drawing with the outlines of its parts, or its parts. */
export function drawStamp(context: CanvasRenderingContext2D, document: Document, picture: ImageBitmap | null): void {
  const scale = context.canvas.width / document.width;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.fillStyle = '#fffdf8';
  context.fillRect(0, 0, document.width, document.height);
  drawContent(context, document, picture, 3 / scale);
  if (!picture) return;
  for (const part of document.parts) {
    tracePart(context, part.outline);
    context.strokeStyle = marks.select;
    context.lineWidth = 2.5 / scale;
    context.stroke();
  }
}
