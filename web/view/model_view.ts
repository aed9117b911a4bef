import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Surface } from '../engine/messages';
import { marks } from './colors';
import type { Viewport } from './viewport';

export type ModelShading = 'drawing' | 'clay' | 'normals';

/** The relief in three dimensions. Draws when something changed, never by itself. */
export class ModelView {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
  private readonly controls: OrbitControls;
  private readonly light = new THREE.DirectionalLight(0xffffff, 2.3);
  private readonly model = new THREE.Group();
  private readonly materials = {
    drawing: new THREE.MeshStandardMaterial({ roughness: 0.92, side: THREE.DoubleSide }),
    clay: new THREE.MeshStandardMaterial({ color: 0xcbbfae, roughness: 0.75, side: THREE.DoubleSide }),
    normals: new THREE.MeshNormalMaterial({ side: THREE.DoubleSide }),
  };
  private readonly picker = new THREE.Raycaster();
  private shading: ModelShading = 'drawing';
  private highlighted: string | null = null;
  private frame = 0;
  private size: [number, number] = [1, 1];
  private canvasSize: [number, number] = [1000, 800];

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.scene.add(this.model, this.light, this.light.target, new THREE.HemisphereLight(0xffffff, 0xcfc8bd, 1.85));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.mouseButtons = { LEFT: THREE.MOUSE.ROTATE, MIDDLE: THREE.MOUSE.PAN, RIGHT: null };
    this.aimLight(-0.45, 0.6);
    this.turn(-0.42, 0.16);
  }

  resize(width: number, height: number): void {
    this.size = [Math.max(1, width), Math.max(1, height)];
    this.renderer.setSize(this.size[0], this.size[1], false);
    this.frameModel();
  }

  /** The camera turned to the right and up, radians, from the front view. */
  turn(yaw: number, pitch: number): void {
    const distance = 5;
    this.camera.position
      .set(Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch))
      .multiplyScalar(distance)
      .add(this.controls.target);
    this.controls.update();
    this.redraw();
  }

  get angles(): { yaw: number; pitch: number } {
    return { yaw: this.controls.getAzimuthalAngle(), pitch: Math.PI / 2 - this.controls.getPolarAngle() };
  }

  /** Light from the right and from above, each in [-1, 1]. */
  aimLight(right: number, up: number): void {
    const z = Math.sqrt(Math.max(0.05, 1 - Math.min(0.95, right * right + up * up)));
    this.light.position.set(right, up, z);
    this.redraw();
  }

  show(surface: Surface | null, width: number, height: number): void {
    this.clear();
    if (width !== this.canvasSize[0] || height !== this.canvasSize[1]) {
      this.canvasSize = [width, height];
      this.frameModel();
    }
    if (surface) for (const mesh of this.meshes(surface)) this.model.add(mesh);
    const scale = 2 / Math.max(width, height);
    this.model.scale.setScalar(scale);
    this.model.position.set((-scale * width) / 2, (-scale * height) / 2, 0);
    this.redraw();
  }

  setPicture(picture: TexImageSource | null): void {
    this.materials.drawing.map?.dispose();
    if (picture) {
      const texture = new THREE.Texture(picture);
      texture.colorSpace = THREE.SRGBColorSpace;
      texture.flipY = false;
      texture.anisotropy = 4;
      texture.generateMipmaps = true;
      texture.needsUpdate = true;
      this.materials.drawing.map = texture;
    } else this.materials.drawing.map = null;
    this.materials.drawing.needsUpdate = true;
    this.redraw();
  }

  setShading(shading: ModelShading): void {
    this.shading = shading;
    this.highlight(this.highlighted);
  }

  highlight(part: string | null): void {
    this.highlighted = part;
    for (const mesh of this.model.children as THREE.Mesh[]) {
      const lit = mesh.name === part && this.shading !== 'normals';
      const usual = this.materials[this.shading];
      const shared = Object.values<THREE.Material>(this.materials).includes(mesh.material as THREE.Material);
      if (!shared) (mesh.material as THREE.Material).dispose();
      mesh.material = lit ? this.litMaterial(usual as THREE.MeshStandardMaterial) : usual;
    }
    this.redraw();
  }

  /** The part under a point of the pane, CSS px. */
  pick(x: number, y: number): string | null {
    const pointer = new THREE.Vector2((2 * x) / this.size[0] - 1, 1 - (2 * y) / this.size[1]);
    this.picker.setFromCamera(pointer, this.camera);
    return this.picker.intersectObject(this.model)[0]?.object.name ?? null;
  }

  /** All of the model in front, as it was at first. */
  frameModel(): void {
    const [width, height] = this.canvasSize;
    const longest = Math.max(width, height);
    const half = [(1.12 * width) / longest, (1.12 * height) / longest] as const;
    const aspect = this.size[0] / this.size[1];
    const up = Math.max(half[1], half[0] / aspect);
    this.camera.left = -up * aspect;
    this.camera.right = up * aspect;
    this.camera.top = up;
    this.camera.bottom = -up;
    this.camera.zoom = 1;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /** The model exactly over a page that is seen through a viewport of the same pane. */
  align(view: Viewport): void {
    const [width, height] = this.canvasSize;
    const scale = 2 / Math.max(width, height);
    const across = (screen: number): number => scale * ((screen - view.x) / view.scale - width / 2);
    const up = (screen: number): number => scale * (height / 2 - (screen - view.y) / view.scale);
    this.camera.left = across(0);
    this.camera.right = across(this.size[0]);
    this.camera.top = up(0);
    this.camera.bottom = up(this.size[1]);
    this.camera.zoom = 1;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /** The view as pixels on a ground of one colour, its longest side `side` px at most. */
  snapshot(side: number, ground: string): ImageData {
    this.render();
    const scale = Math.min(1, side / Math.max(this.canvas.width, this.canvas.height));
    const [width, height] = [Math.round(scale * this.canvas.width), Math.round(scale * this.canvas.height)];
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    if (!context) throw new Error('this browser has no canvas');
    context.fillStyle = ground;
    context.fillRect(0, 0, width, height);
    context.drawImage(this.canvas, 0, 0, width, height);
    return context.getImageData(0, 0, width, height);
  }

  picture(): Promise<Blob> {
    this.render();
    return new Promise((resolve, reject) =>
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png'),
    );
  }

  private litMaterial(usual: THREE.MeshStandardMaterial): THREE.MeshStandardMaterial {
    const lit = usual.clone();
    lit.emissive = new THREE.Color(marks.select);
    lit.emissiveIntensity = 0.13;
    return lit;
  }

  private meshes(surface: Surface): THREE.Mesh[] {
    const attribute = (array: Float32Array<ArrayBuffer>, size: number) => new THREE.BufferAttribute(array, size);
    const positions = attribute(surface.positions, 3);
    const normals = attribute(surface.normals, 3);
    const uvs = attribute(surface.uvs, 2);
    const corners = new THREE.BufferAttribute(surface.triangles, 1);
    return surface.parts.map((part) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', positions);
      geometry.setAttribute('normal', normals);
      geometry.setAttribute('uv', uvs);
      geometry.setIndex(corners);
      geometry.setDrawRange(3 * part.firstTriangle, 3 * part.triangleCount);
      const mesh = new THREE.Mesh(geometry, this.materials[this.shading]);
      mesh.name = part.id;
      if (part.id === this.highlighted && this.shading !== 'normals')
        mesh.material = this.litMaterial(mesh.material as THREE.MeshStandardMaterial);
      return mesh;
    });
  }

  private clear(): void {
    for (const mesh of [...this.model.children] as THREE.Mesh[]) {
      mesh.geometry.dispose();
      this.model.remove(mesh);
    }
  }

  private redraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.render());
  }

  private render(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.renderer.render(this.scene, this.camera);
  }
}
