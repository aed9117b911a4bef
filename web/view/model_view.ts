import * as Comlink from 'comlink';
import type { Surface } from '../engine/messages';
import type { ModelShading, Picked, Pose } from './model_renderer';
import type { StartRenderer } from './model_worker';
import type { Painted } from './painted_drawing';
import type { Renderer } from './software_renderer';
import type { Viewport } from './viewport';

type Frame = Pose['frame'];

/** Height that buttons cover at the bottom of a view, and least height of a view that has them, CSS px. */
const barHeight = 60;
const leastWithBar = 260;

/** Shows the relief on a canvas. A worker draws it, so that slow graphics do not block the page. */
export class ModelView {
  private readonly worker = new Worker(new URL('./model_worker.ts', import.meta.url), { type: 'module' });
  private readonly renderer: Promise<Comlink.Remote<Renderer>>;
  private pose: Pose = { yaw: -0.42, pitch: 0.16, target: [0, 0, 0], frame: [-1, 1, 1, -1] };
  private zoomed = 1;
  private painting: Promise<void> = Promise.resolve();
  private isPainting = false;
  private toPaint: { document: Painted | null; picture: ImageBitmap | null; side: number | undefined } | null = null;
  private size: [number, number] = [1, 1];
  private canvasSize: [number, number] = [1000, 800];

  /** `lost` is called when the graphics are lost. A new view on a new canvas may get them back. */
  constructor(canvas: HTMLCanvasElement, lost: () => void = () => undefined) {
    const offscreen = canvas.transferControlToOffscreen();
    const start = Comlink.wrap<StartRenderer>(this.worker);
    this.renderer = start(Comlink.transfer(offscreen, [offscreen]), Comlink.proxy(lost)) as Promise<Comlink.Remote<Renderer>>;
    this.aimLight(-0.45, 0.6);
  }

  dispose(): void {
    this.worker.terminate();
  }

  resize(width: number, height: number): void {
    this.size = [Math.max(1, width), Math.max(1, height)];
    this.tell((renderer) => renderer.resize(width, height, Math.min(2, window.devicePixelRatio)));
    this.frameModel();
  }

  /** Turns the camera to angles to the right and up from the front view, radians. */
  turn(yaw: number, pitch: number): void {
    const most = Math.PI / 2 - 1e-3;
    this.look({ ...this.pose, yaw, pitch: Math.min(most, Math.max(-most, pitch)) });
  }

  get angles(): { yaw: number; pitch: number } {
    return this.pose;
  }

  /** Moves the model on the screen, CSS px. */
  pan(dx: number, dy: number): void {
    const [left, right] = this.pose.frame;
    const unit = (right - left) / this.size[0];
    const { yaw, pitch, target } = this.pose;
    const across = [Math.cos(yaw), 0, -Math.sin(yaw)] as const;
    const up = [-Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), -Math.cos(yaw) * Math.sin(pitch)] as const;
    const moved = (k: 0 | 1 | 2): number => target[k] - unit * dx * across[k] + unit * dy * up[k];
    this.look({ ...this.pose, target: [moved(0), moved(1), moved(2)] });
  }

  zoom(factor: number): void {
    this.zoomed = Math.min(20, Math.max(0.3, this.zoomed * factor));
    this.look({ ...this.pose, frame: this.wholeFrame() });
  }

  /** Moves the light to the right and up, each in [-1, 1]. */
  aimLight(right: number, up: number): void {
    this.tell((renderer) => renderer.aimLight(right, up));
  }

  show(surface: Surface | null, width: number, height: number): void {
    if (width !== this.canvasSize[0] || height !== this.canvasSize[1]) {
      this.canvasSize = [width, height];
      this.frameModel();
    }
    this.tell((renderer) => renderer.show(surface, width, height));
  }

  /**
   * Sets the texture: a picture, or the parts painted flat, or nothing without a document. `side` limits its
   * size, px.
   */
  paint(document: Painted | null, picture: ImageBitmap | null, side?: number): void {
    this.toPaint = { document, picture, side };
    if (!this.isPainting) this.painting = this.paintNewest();
  }

  setShading(shading: ModelShading): void {
    this.tell((renderer) => renderer.setShading(shading));
  }

  highlight(part: string | null): void {
    this.tell((renderer) => renderer.highlight(part));
  }

  /** Returns what is visible at a point of the pane, CSS px. */
  async pick(x: number, y: number): Promise<Picked | null> {
    return (await this.renderer).pick((2 * x) / this.size[0] - 1, 1 - (2 * y) / this.size[1]);
  }

  /** Shows the whole model again, as large as possible. */
  frameModel(): void {
    this.zoomed = 1;
    this.look({ ...this.pose, target: [0, 0, 0], frame: this.wholeFrame() });
  }

  /** Places the model exactly over the page as a viewport of the same size shows it. */
  align(view: Viewport): void {
    const [width, height] = this.canvasSize;
    const scale = 2 / Math.max(width, height);
    const across = (screen: number): number => scale * ((screen - view.x) / view.scale - width / 2);
    const up = (screen: number): number => scale * (height / 2 - (screen - view.y) / view.scale);
    const frame: Frame = [across(0), across(this.size[0]), up(0), up(this.size[1])];
    this.look({ ...this.pose, target: [0, 0, 0], frame });
  }

  /** Returns whether the processor draws, without 3D graphics. */
  async isSoftware(): Promise<boolean> {
    return (await this.renderer).isSoftware;
  }

  /** Resolves when all changes so far are on the screen. */
  async drawn(): Promise<void> {
    await this.painting;
    await (await this.renderer).drawn();
  }

  /** Returns the view as a PNG file. */
  async picture(): Promise<Blob> {
    return (await this.renderer).picture();
  }

  /** Returns the pixels of the view on a background of one colour, at most `side` px long. */
  async snapshot(side: number, ground: string): Promise<ImageData> {
    return (await this.renderer).snapshot(side, ground);
  }

  /** Paints the newest texture until there is no newer one. Textures that are overtaken are skipped. */
  private async paintNewest(): Promise<void> {
    this.isPainting = true;
    try {
      for (let next = this.toPaint; next; next = this.toPaint) {
        this.toPaint = null;
        const { document, picture, side } = next;
        const copy = picture && (await createImageBitmap(picture));
        const content = document && { width: document.width, height: document.height, parts: document.parts, joins: document.joins, paint: document.paint, settings: document.settings };
        await (await this.renderer).paint(content, copy && Comlink.transfer(copy, [copy]), side);
      }
    } finally {
      this.isPainting = false;
    }
  }

  private wholeFrame(): Frame {
    const [width, height] = this.canvasSize;
    const longest = Math.max(width, height);
    const half = [(1.12 * width) / longest, (1.12 * height) / longest] as const;
    const aspect = this.size[0] / this.size[1];
    const covered = this.size[1] < leastWithBar ? 0 : barHeight / this.size[1];
    const up = Math.max(half[1] / (1 - covered), half[0] / aspect) / this.zoomed;
    return [-up * aspect, up * aspect, (1 - covered) * up, -(1 + covered) * up];
  }

  private look(pose: Pose): void {
    this.pose = pose;
    this.tell((renderer) => renderer.look(pose));
  }

  /** Calls the renderer. Calls arrive in the order in which they are made. */
  private tell(call: (renderer: Comlink.Remote<Renderer>) => Promise<unknown>): void {
    void this.renderer.then(call);
  }
}
