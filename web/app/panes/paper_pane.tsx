import { useEffect, useRef } from 'preact/hooks';
import type { Point } from '../../document/document';
import type { Tool } from '../../tools/tool';
import { drawPaper } from '../../view/paper_view';
import { fitted, panned, toCanvas, type Viewport, zoomed } from '../../view/viewport';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { PeekOverlay } from './peek_overlay';
import { useStore } from '../state/store';

/** Width that the toolbar covers at the left, CSS px. On narrow screens it lies below the page. */
const toolbarRoom = 90;
/** Height that the bars of tools cover at the bottom, CSS px. */
const barRoom = 68;
/** A pane lower than this, CSS px, is the small picture in the other pane and has no bars. */
const leastWithBars = 260;
/** A tap of two fingers undoes: its longest time, ms, and largest movement, CSS px. */
const tapMs = 300;
const tapPx = 10;
const narrow = window.matchMedia('(max-width: 900px)');

/** Controls the canvas of the drawing: its zoom, its redrawing, and the pointers on it. */
export class PaperControl {
  view: Viewport = { scale: 1, x: 0, y: 0 };
  spaceHeld = false;
  private readonly pointers = new Map<number, Point>();
  private gesture: 'none' | 'tool' | 'pan' | 'pinch' = 'none';
  private frame = 0;
  private shown: readonly unknown[] = [];
  private sawPen = false;
  /** The tap of two fingers in progress: its start, ms, and movement so far, CSS px. */
  private tap: { time: number; moved: number } | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly editor: Editor,
    private readonly tool: () => Tool,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.cancel(event));
    canvas.addEventListener('pointerleave', () => editor.set({ hovered: null }));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  get reach(): number {
    return 12 / this.view.scale;
  }

  fit(): void {
    const { width, height } = this.editor.document;
    const pane: Point = [this.canvas.clientWidth, this.canvas.clientHeight];
    this.view = pane[1] < leastWithBars
      ? fitted([width, height], pane, [4, 4], 4)
      : fitted([width, height], pane, [narrow.matches ? 24 : toolbarRoom, barRoom]);
    this.redraw();
  }

  zoom(factor: number): void {
    this.view = zoomed(this.view, factor, [this.canvas.clientWidth / 2, this.canvas.clientHeight / 2]);
    this.redraw();
  }

  resize(): void {
    const ratio = window.devicePixelRatio;
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    this.fit();
  }

  cancelGesture(): void {
    if (this.gesture === 'tool') this.tool().cancel();
    this.tool().cancel();
    this.gesture = 'none';
    this.redraw();
  }

  /** Passes a key to the tool. Returns whether the tool uses it. */
  toolKey(name: string, shift: boolean, alt: boolean): boolean {
    const taken = this.tool().key?.(name, { shift, alt }) ?? false;
    if (taken) this.redraw();
    return taken;
  }

  redraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.render());
  }

  /** Redraws if something that the canvas shows has changed. */
  follow(): void {
    const { history, relief, selected, hovered, culprit, depthTint, showMarks, picture, tool, tint, doubt, pending, brush } = this.editor.state;
    const shown = [history, relief, selected, hovered, culprit, depthTint, showMarks, picture, tool, tint, doubt, pending, brush];
    if (shown.every((value, i) => value === this.shown[i])) return;
    this.shown = shown;
    this.redraw();
  }

  private render(): void {
    this.frame = 0;
    const context = this.canvas.getContext('2d');
    if (!context) return;
    const { state } = this.editor;
    drawPaper(
      context,
      {
        document: state.history.document,
        picture: state.picture,
        overlays: state.relief?.overlays ?? null,
        selected: state.selected,
        hovered: state.hovered,
        culprit: state.culprit,
        doubt: state.doubt,
        depthTint: state.depthTint,
        showMarks: state.showMarks && state.tool !== 'scribble',
        dark: window.matchMedia('(prefers-color-scheme: dark)').matches,
        preview: (on, pixel) => this.tool().draw(on, pixel),
      },
      this.view,
      window.devicePixelRatio,
    );
    this.canvas.style.cursor =
      this.gesture === 'pan' ? 'grabbing' : this.spaceHeld || state.tool === 'hand' ? 'grab' : this.tool().cursor;
  }

  private at(event: { offsetX: number; offsetY: number }): Point {
    return toCanvas(this.view, [event.offsetX, event.offsetY]);
  }

  private wantsPan(event: PointerEvent): boolean {
    // Once a pen was used, fingers only move the page.
    const palm = this.sawPen && event.pointerType === 'touch';
    return event.button === 1 || this.spaceHeld || palm || this.editor.state.tool === 'hand';
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    if (event.pointerType === 'pen') this.sawPen = true;
    this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    if (this.pointers.size === 2) {
      if (this.gesture === 'tool') this.tool().cancel();
      this.gesture = 'pinch';
      this.tap = { time: event.timeStamp, moved: 0 };
    } else if (this.wantsPan(event)) this.gesture = 'pan';
    else if (event.button === 0) {
      this.gesture = 'tool';
      this.tool().down(this.at(event), { shift: event.shiftKey, alt: event.altKey });
    }
    this.redraw();
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    const now: Point = [event.offsetX, event.offsetY];
    if (before) this.pointers.set(event.pointerId, now);
    if (this.gesture === 'pan' && before) this.view = panned(this.view, now[0] - before[0], now[1] - before[1]);
    else if (this.gesture === 'pinch' && before) this.pinch(event.pointerId, before, now);
    else if (this.gesture === 'tool') {
      for (const step of event.getCoalescedEvents?.() ?? [event]) this.tool().move(this.at(step), true);
      this.tool().move(this.at(event), true);
    } else if (!before) this.tool().move(this.at(event), false);
    this.redraw();
  }

  private pinch(id: number, before: Point, now: Point): void {
    if (this.tap) this.tap.moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
    const other = [...this.pointers].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const span = (p: Point): number => Math.hypot(p[0] - other[0], p[1] - other[1]);
    const middle: Point = [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2];
    const moved = panned(this.view, (now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    this.view = zoomed(moved, span(now) / Math.max(1, span(before)), middle);
  }

  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    if (this.gesture === 'tool') this.tool().up(this.at(event), { shift: event.shiftKey, alt: event.altKey });
    if (this.pointers.size === 0) {
      if (this.tap && this.tap.moved < tapPx && event.timeStamp - this.tap.time < tapMs) this.editor.undo();
      this.gesture = 'none';
      this.tap = null;
    }
    this.redraw();
  }

  private cancel(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    if (this.gesture === 'tool') this.tool().cancel();
    if (this.pointers.size === 0) this.gesture = 'none';
    this.redraw();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : 1;
    const point: Point = [event.offsetX, event.offsetY];
    // Browsers report a pinch on a touchpad as a wheel with Ctrl.
    if (event.ctrlKey || event.metaKey)
      this.view = zoomed(this.view, Math.exp((-event.deltaY * unit) / 240), point);
    else this.view = panned(this.view, -event.deltaX * unit, -event.deltaY * unit);
    this.redraw();
  }
}

/** Tells beginners what to draw on an empty page. */
function EmptyCue({ editor }: { editor: Editor }) {
  const { history, preview } = useStore(editor);
  const { document } = history;
  if (document.parts.length > 0 || document.drawing || preview) return null;
  return <p class="empty-cue">{t('emptyCue')}</p>;
}

/** A button for peeking, for those without a keyboard. */
function PeekButton({ editor }: { editor: Editor }) {
  const { peeking, relief } = useStore(editor);
  if (!relief) return null;
  return (
    <div class="floating peek-button">
      <button type="button" id="peek" aria-pressed={peeking} title={t('hintPeek')} onClick={() => editor.set({ peeking: !peeking })}>{t('peek')}</button>
    </div>
  );
}

interface PaperPaneProps {
  editor: Editor;
  tool(): Tool;
  attach(control: PaperControl): void;
}

export function PaperPane({ editor, tool, attach }: PaperPaneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const control = useRef<PaperControl>(null);
  useEffect(() => {
    if (!canvas.current) return;
    const paper = new PaperControl(canvas.current, editor, tool);
    control.current = paper;
    attach(paper);
    const observer = new ResizeObserver(() => paper.resize());
    observer.observe(canvas.current);
    let canvasSize = '';
    const stop = editor.subscribe(() => {
      const { width, height } = editor.document;
      if (canvasSize !== `${width} ${height}`) paper.fit();
      canvasSize = `${width} ${height}`;
      paper.follow();
    });
    return () => {
      observer.disconnect();
      stop();
    };
  }, []);
  return (
    <section class="pane paper" aria-label={t('paper')}>
      <canvas ref={canvas} tabIndex={0} role="application" aria-label={t('paper')} />
      <EmptyCue editor={editor} />
      <PeekOverlay editor={editor} view={() => control.current?.view ?? null} />
      <PeekButton editor={editor} />
      <button type="button" class="swap" aria-label={t('showLarge', { name: t('paper') })} onClick={() => editor.set({ pane: 'paper' })} />
    </section>
  );
}
