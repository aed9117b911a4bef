import type { Lines, Surface } from '../engine/messages';
import { lightFrom } from './lit_picture';
import type { ModelRenderer, ModelShading, Picked, Pose } from './model_renderer';
import { bledTexture, type Painted } from './painted_drawing';
import { snapshotOf } from './snapshot';

/** Draws the relief, with or without 3D graphics. */
export type Renderer = Pick<
  ModelRenderer,
  'isSoftware' | 'resize' | 'look' | 'aimLight' | 'show' | 'paint' | 'setShading' | 'highlight' | 'pick' | 'drawn' | 'picture' | 'snapshot'
>;

/** Longest side of the picture, px; its cost grows with every pixel. */
const longest = 900;
const clay = [203, 191, 174] as const;
const lit = [242, 140, 40] as const;

interface Frame {
  readonly width: number;
  readonly height: number;
  readonly image: ImageData;
  /** Depth of each pixel, larger is nearer; -Infinity where there is nothing. */
  readonly depth: Float32Array;
  /** Index of the part in each pixel, or -1. */
  readonly part: Int16Array;
}

/** The vertices of a surface on the screen: x and y, px, depth, and their brightness. */
interface Corners {
  readonly screen: Float32Array;
  readonly shade: Float32Array;
}

type Vector = readonly [number, number, number];

/** Returns the directions to the right, up and towards the viewer. */
function axesOf({ yaw, pitch }: Pose): readonly [Vector, Vector, Vector] {
  return [
    [Math.cos(yaw), 0, -Math.sin(yaw)],
    [-Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), -Math.cos(yaw) * Math.sin(pitch)],
    [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)],
  ];
}

function dot(a: Vector, x: number, y: number, z: number): number {
  return a[0] * x + a[1] * y + a[2] * z;
}

/** Draws the relief with the processor, for browsers without WebGL. It is slower and simpler. */
export class SoftwareRenderer implements Renderer {
  readonly isSoftware: boolean = true;
  private readonly context: OffscreenCanvasRenderingContext2D;
  private surface: Surface | null = null;
  private size: readonly [number, number] = [1, 1];
  private pose: Pose = { yaw: 0, pitch: 0, target: [0, 0, 0], frame: [-1, 1, 1, -1] };
  private light: Vector = [0, 0, 1];
  private texture: ImageData | null = null;
  private shading: ModelShading = 'drawing';
  private highlighted: string | null = null;
  private frame: Frame | null = null;
  private timer = 0;

  constructor(private readonly canvas: OffscreenCanvas) {
    const context = canvas.getContext('2d');
    if (!context) throw new Error('this browser has no canvas');
    this.context = context;
  }

  resize(width: number, height: number): void {
    const scale = Math.min(1, longest / Math.max(width, height, 1));
    this.canvas.width = Math.max(1, Math.round(scale * width));
    this.canvas.height = Math.max(1, Math.round(scale * height));
    this.redraw();
  }

  look(pose: Pose): void {
    this.pose = pose;
    this.redraw();
  }

  aimLight(right: number, up: number): void {
    this.light = lightFrom([right, up]);
    this.redraw();
  }

  show(surface: Surface | null, width: number, height: number): void {
    this.surface = surface;
    this.size = [width, height];
    this.redraw();
  }

  paint(document: Painted | null, picture: ImageBitmap | null, side?: number): void {
    const canvas = document && bledTexture(document, picture, side);
    this.texture = canvas && (canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? null);
    this.redraw();
  }

  setShading(shading: ModelShading): void {
    this.shading = shading;
    this.redraw();
  }

  highlight(part: string | null): void {
    this.highlighted = part;
    this.redraw();
  }

  pick(right: number, up: number): Picked | null {
    const { frame, surface, pose, size } = this;
    if (!frame || !surface) return null;
    const x = Math.floor(((right + 1) / 2) * frame.width);
    const y = Math.floor(((1 - up) / 2) * frame.height);
    const seen = surface.parts[frame.part[y * frame.width + x] ?? -1];
    if (!seen) return null;
    const [left, most, top, bottom] = pose.frame;
    const place: Vector = [left + ((right + 1) / 2) * (most - left), bottom + ((up + 1) / 2) * (top - bottom), frame.depth[y * frame.width + x] as number];
    const axes = axesOf(pose);
    const at = (k: 0 | 1): number => pose.target[k] + axes.reduce((sum, axis, i) => sum + axis[k] * (place[i] as number), 0);
    const unit = 2 / Math.max(...size);
    return { part: seen.id, at: [at(0) / unit + size[0] / 2, size[1] / 2 - at(1) / unit] };
  }

  async drawn(): Promise<void> {
    this.render();
  }

  picture(): Promise<Blob> {
    this.render();
    return this.canvas.convertToBlob({ type: 'image/png' });
  }

  snapshot(side: number, ground: string): ImageData {
    this.render();
    return snapshotOf(this.canvas, side, ground);
  }

  private redraw(): void {
    if (this.timer === 0) this.timer = requestAnimationFrame(() => this.render());
  }

  private render(): void {
    cancelAnimationFrame(this.timer);
    this.timer = 0;
    const { width, height } = this.canvas;
    const frame: Frame = {
      width, height,
      image: new ImageData(width, height),
      depth: new Float32Array(width * height).fill(-Infinity),
      part: new Int16Array(width * height).fill(-1),
    };
    this.frame = frame;
    const { surface } = this;
    if (surface) {
      const corners = this.project(surface, width, height);
      surface.parts.forEach(({ firstTriangle, triangleCount, hiddenCount }, part) => {
        for (let t = 0; t < triangleCount; t++)
          this.fill(frame, corners, { surface, triangle: firstTriangle + t, part, hidden: t >= triangleCount - hiddenCount });
      });
      if (surface.ink && this.shading === 'drawing') this.drawInk(frame, surface.ink);
    }
    this.context.putImageData(frame.image, 0, 0);
  }

  /** Draws contours where they face the viewer, without light. They cannot be picked. */
  private drawInk(frame: Frame, ink: Lines): void {
    const { screen } = this.project({ positions: ink.positions, normals: new Float32Array(ink.positions.length) }, frame.width, frame.height);
    const corners = { screen, shade: new Float32Array(screen.length / 3).fill(1) };
    const surface = { ...ink, normals: ink.positions, colors: new Uint8Array(), parts: [], pixelArt: false };
    const at = (corner: number, k: 0 | 1): number => screen[3 * (ink.triangles[corner] as number) + k] as number;
    for (let t = 0; t < ink.triangles.length; t += 3) {
      const turn = (at(t + 1, 0) - at(t, 0)) * (at(t + 2, 1) - at(t, 1)) - (at(t + 2, 0) - at(t, 0)) * (at(t + 1, 1) - at(t, 1));
      // Rows run downwards.
      if (turn < 0) this.fill(frame, corners, { surface, triangle: t / 3, part: -1, hidden: false });
    }
  }

  private project({ positions, normals }: Pick<Surface, 'positions' | 'normals'>, width: number, height: number): Corners {
    const { target, frame } = this.pose;
    const [left, right, top, bottom] = frame;
    const [across, up, near] = axesOf(this.pose);
    const unit = 2 / Math.max(...this.size);
    const count = positions.length / 3;
    const screen = new Float32Array(3 * count);
    const shade = new Float32Array(count);
    for (let i = 0; i < count; i++) {
      const at = (k: 0 | 1 | 2): number => positions[3 * i + k] as number;
      const x = unit * (at(0) - this.size[0] / 2) - target[0];
      const y = unit * (at(1) - this.size[1] / 2) - target[1];
      const z = unit * at(2) - target[2];
      screen[3 * i] = ((dot(across, x, y, z) - left) / (right - left)) * width;
      screen[3 * i + 1] = ((top - dot(up, x, y, z)) / (top - bottom)) * height;
      screen[3 * i + 2] = dot(near, x, y, z);
      const facing = dot(this.light, normals[3 * i] as number, normals[3 * i + 1] as number, normals[3 * i + 2] as number);
      shade[i] = 0.5 + 0.55 * Math.max(0, facing);
    }
    return { screen, shade };
  }

  private fill(frame: Frame, { screen, shade }: Corners, of: { surface: Surface; triangle: number; part: number; hidden: boolean }): void {
    const { surface, triangle, part } = of;
    const [a, b, c] = [0, 1, 2].map((k) => surface.triangles[3 * triangle + k] as number) as [number, number, number];
    const x = (i: number): number => screen[3 * i] as number;
    const y = (i: number): number => screen[3 * i + 1] as number;
    const whole = (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
    if (whole === 0) return;
    const [x0, x1] = [Math.max(0, Math.ceil(Math.min(x(a), x(b), x(c)) - 0.5)), Math.min(frame.width - 1, Math.floor(Math.max(x(a), x(b), x(c)) - 0.5))];
    const [y0, y1] = [Math.max(0, Math.ceil(Math.min(y(a), y(b), y(c)) - 0.5)), Math.min(frame.height - 1, Math.floor(Math.max(y(a), y(b), y(c)) - 0.5))];
    for (let row = y0; row <= y1; row++)
      for (let column = x0; column <= x1; column++) {
        const [px, py] = [column + 0.5, row + 0.5];
        const v = ((px - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (py - y(a))) / whole;
        const w = ((x(b) - x(a)) * (py - y(a)) - (px - x(a)) * (y(b) - y(a))) / whole;
        const u = 1 - v - w;
        if (u < 0 || v < 0 || w < 0) continue;
        const at = row * frame.width + column;
        const near = u * (screen[3 * a + 2] as number) + v * (screen[3 * b + 2] as number) + w * (screen[3 * c + 2] as number);
        if (near <= (frame.depth[at] as number)) continue;
        frame.depth[at] = near;
        if (part >= 0) frame.part[at] = part;
        const bright = u * (shade[a] as number) + v * (shade[b] as number) + w * (shade[c] as number);
        const mixed = (values: ArrayLike<number>, size: number, k: number): number =>
          u * (values[size * a + k] as number) + v * (values[size * b + k] as number) + w * (values[size * c + k] as number);
        this.color(frame.image.data, 4 * at, { surface, part, hidden: of.hidden, bright, mixed });
      }
  }

  private color(
    data: Uint8ClampedArray,
    at: number,
    of: { surface: Surface; part: number; hidden: boolean; bright: number; mixed(values: ArrayLike<number>, size: number, k: number): number },
  ): void {
    const { surface, mixed, bright } = of;
    const glow = surface.parts[of.part]?.id === this.highlighted ? 0.13 : 0;
    const { texture } = this;
    const pixel = texture && this.shading === 'drawing' && !of.hidden
      ? 4 * (texture.width * Math.min(texture.height - 1, Math.floor(mixed(surface.uvs, 2, 1) * texture.height)) + Math.min(texture.width - 1, Math.floor(mixed(surface.uvs, 2, 0) * texture.width)))
      : -1;
    for (let k = 0; k < 3; k++) {
      if (this.shading === 'normals') data[at + k] = 127.5 + 127.5 * mixed(surface.normals, 3, k);
      else {
        const base = pixel >= 0 ? (texture?.data[pixel + k] ?? 255) : this.shading === 'clay' ? (clay[k] as number) : mixed(surface.colors, 3, k);
        data[at + k] = bright * base + glow * (lit[k] as number);
      }
    }
    data[at + 3] = 255;
  }
}
