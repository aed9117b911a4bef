import * as THREE from 'three';
import type { Lines, Surface } from '../engine/messages';
import { marks } from './colors';
import { lightFrom } from './lit_picture';
import { bledTexture, type Painted } from './painted_drawing';
import { snapshotOf } from './snapshot';

export type ModelShading = 'drawing' | 'clay' | 'normals';

/** The camera, in units in which the longest side of the model is 2. */
export interface Pose {
  /** Angles to the right and up from the front view, radians. */
  readonly yaw: number;
  readonly pitch: number;
  readonly target: readonly [number, number, number];
  /** Left, right, top and bottom of the visible area, relative to the target. */
  readonly frame: readonly [number, number, number, number];
}

/** A part that was picked, with the picked point of the page, px. */
export interface Picked {
  readonly part: string;
  readonly at: readonly [number, number];
}

/** Converts bytes of sRGB to linear light, in which vertex colours are given. */
function linearOf(bytes: Uint8Array): Float32Array<ArrayBuffer> {
  const color = new THREE.Color();
  const levels = Float32Array.from({ length: 256 }, (_, i) => color.setRGB(i / 255, 0, 0, THREE.SRGBColorSpace).r);
  return Float32Array.from(bytes, (byte) => levels[byte] as number);
}

/** Draws the relief with WebGL. It draws only after a change, never continuously. */
export class ModelRenderer {
  /** Whether the processor draws, without 3D graphics. */
  readonly isSoftware: boolean = false;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
  private readonly light = new THREE.DirectionalLight(0xffffff, 2.3);
  private readonly model = new THREE.Group();
  private readonly materials = {
    drawing: new THREE.MeshStandardMaterial({ roughness: 0.92, side: THREE.DoubleSide }),
    /** For surfaces that the drawing does not show. */
    hidden: new THREE.MeshStandardMaterial({ roughness: 0.92, side: THREE.DoubleSide, vertexColors: true }),
    clay: new THREE.MeshStandardMaterial({ color: 0xcbbfae, roughness: 0.75, side: THREE.DoubleSide }),
    normals: new THREE.MeshNormalMaterial({ side: THREE.DoubleSide }),
    /** For contours, which have no light and no back. */
    ink: new THREE.MeshBasicMaterial(),
  };
  private readonly picker = new THREE.Raycaster();
  private shading: ModelShading = 'drawing';
  private highlighted: string | null = null;
  private frame = 0;
  private filter: THREE.MagnificationTextureFilter = THREE.LinearFilter;
  /** Height of the page, px. */
  private height = 0;

  constructor(private readonly canvas: OffscreenCanvas) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    canvas.addEventListener('webglcontextrestored', () => this.redraw());
    this.scene.add(this.model, this.light, this.light.target, new THREE.HemisphereLight(0xffffff, 0xcfc8bd, 1.85));
  }

  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(Math.max(1, width), Math.max(1, height), false);
    this.redraw();
  }

  look({ yaw, pitch, target, frame }: Pose): void {
    const distance = 5;
    const at = new THREE.Vector3(...target);
    this.camera.position
      .set(Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch))
      .multiplyScalar(distance)
      .add(at);
    this.camera.lookAt(at);
    [this.camera.left, this.camera.right, this.camera.top, this.camera.bottom] = frame;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /** Moves the light to the right and up, each in [-1, 1]. */
  aimLight(right: number, up: number): void {
    this.light.position.set(...lightFrom([right, up]));
    this.redraw();
  }

  show(surface: Surface | null, width: number, height: number): void {
    this.clear();
    if (surface) for (const mesh of this.meshes(surface)) this.model.add(mesh);
    if (surface?.ink) this.model.add(this.inkMesh(surface.ink));
    this.filter = surface?.pixelArt ? THREE.NearestFilter : THREE.LinearFilter;
    this.sharpen();
    const scale = 2 / Math.max(width, height);
    this.height = height;
    this.model.scale.setScalar(scale);
    this.model.position.set((-scale * width) / 2, (-scale * height) / 2, 0);
    this.redraw();
  }

  /**
   * Sets the texture: a picture, or the parts painted flat, or nothing without a document. `side` limits its
   * size, px.
   */
  paint(document: Painted | null, picture: ImageBitmap | null, side?: number): void {
    const { drawing, ink } = this.materials;
    drawing.map?.dispose();
    drawing.map = document && this.textureOf(bledTexture(document, picture, side));
    ink.map = drawing.map;
    for (const material of [drawing, ink]) material.needsUpdate = true;
    this.sharpen();
    this.redraw();
  }

  /** Shows the pixels of pixel art. */
  private sharpen(): void {
    const { map } = this.materials.drawing;
    if (!map || map.magFilter === this.filter) return;
    map.magFilter = this.filter;
    map.needsUpdate = true;
  }

  setShading(shading: ModelShading): void {
    this.shading = shading;
    this.highlight(this.highlighted);
  }

  highlight(part: string | null): void {
    this.highlighted = part;
    for (const mesh of this.model.children as THREE.Mesh[]) {
      if (mesh.material === this.materials.ink) {
        mesh.visible = this.shading === 'drawing';
        continue;
      }
      const lit = mesh.name === part && this.shading !== 'normals';
      const usual = this.usualMaterial(mesh);
      const shared = Object.values<THREE.Material>(this.materials).includes(mesh.material as THREE.Material);
      if (!shared) (mesh.material as THREE.Material).dispose();
      mesh.material = lit ? this.litMaterial(usual as THREE.MeshStandardMaterial) : usual;
    }
    this.redraw();
  }

  /** Returns what is visible at a point of the view, right and up in [-1, 1]. */
  pick(right: number, up: number): Picked | null {
    this.camera.updateMatrixWorld();
    this.picker.setFromCamera(new THREE.Vector2(right, up), this.camera);
    const [hit] = this.picker.intersectObject(this.model);
    if (!hit) return null;
    const { x, y } = this.model.worldToLocal(hit.point.clone());
    return { part: hit.object.name, at: [x, this.height - y] };
  }

  /** Draws pending changes at once. Resolves when the graphics have finished and the page has the result. */
  async drawn(): Promise<void> {
    this.render();
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }

  /** Returns the view as a PNG file. */
  picture(): Promise<Blob> {
    this.render();
    return this.canvas.convertToBlob({ type: 'image/png' });
  }

  /** Returns the pixels of the view on a background of one colour, at most `side` px long. */
  snapshot(side: number, ground: string): ImageData {
    this.render();
    return snapshotOf(this.canvas, side, ground);
  }

  private textureOf(source: OffscreenCanvas): THREE.Texture {
    const texture = new THREE.Texture(source);
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.flipY = false;
    texture.anisotropy = 4;
    texture.generateMipmaps = true;
    texture.needsUpdate = true;
    return texture;
  }

  private litMaterial(usual: THREE.MeshStandardMaterial): THREE.MeshStandardMaterial {
    const lit = usual.clone();
    lit.emissive = new THREE.Color(marks.select);
    lit.emissiveIntensity = 0.13;
    return lit;
  }

  private meshes(surface: Surface): THREE.Mesh[] {
    const attribute = (array: Float32Array<ArrayBuffer>, size: number) => new THREE.BufferAttribute(array, size);
    const attributes = {
      position: attribute(surface.positions, 3),
      normal: attribute(surface.normals, 3),
      uv: attribute(surface.uvs, 2),
      color: attribute(linearOf(surface.colors), 3),
    };
    const corners = new THREE.BufferAttribute(surface.triangles, 1);
    let sphere: THREE.Sphere | null = null;
    const mesh = (part: string, hidden: boolean, first: number, count: number): THREE.Mesh => {
      const geometry = new THREE.BufferGeometry();
      for (const [name, values] of Object.entries(attributes)) geometry.setAttribute(name, values);
      geometry.setIndex(corners);
      geometry.setDrawRange(3 * first, 3 * count);
      // All meshes share the vertices of the whole, so they share one sphere.
      if (sphere) geometry.boundingSphere = sphere;
      else geometry.computeBoundingSphere();
      sphere = geometry.boundingSphere;
      const made = new THREE.Mesh(geometry);
      made.name = part;
      made.userData['hidden'] = hidden;
      const usual = this.usualMaterial(made);
      const lit = part === this.highlighted && this.shading !== 'normals';
      made.material = lit ? this.litMaterial(usual as THREE.MeshStandardMaterial) : usual;
      return made;
    };
    return surface.parts.flatMap(({ id, firstTriangle, triangleCount, hiddenCount }) => {
      const seen = triangleCount - hiddenCount;
      const made = [mesh(id, false, firstTriangle, seen)];
      if (hiddenCount > 0) made.push(mesh(id, true, firstTriangle + seen, hiddenCount));
      return made;
    });
  }

  /** Returns the mesh of contours. It cannot be picked. */
  private inkMesh({ positions, uvs, triangles }: Lines): THREE.Mesh {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute('uv', new THREE.BufferAttribute(uvs, 2));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    const mesh = new THREE.Mesh(geometry, this.materials.ink);
    mesh.visible = this.shading === 'drawing';
    mesh.raycast = () => undefined;
    return mesh;
  }

  private usualMaterial({ userData }: THREE.Mesh): THREE.Material {
    return this.materials[this.shading === 'drawing' && userData['hidden'] ? 'hidden' : this.shading];
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
