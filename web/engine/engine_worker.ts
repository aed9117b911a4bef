import * as Comlink from 'comlink';
import {
  type BuiltRelief, type Dressed, type Failure, type FlatDrawing, isFailure, type OutputFile, type Progress, type SegmentationRequest,
  type Solid, type SolidOptions, type Surface, type Texture, type TintedLabels, type UnderstandingRequest,
} from './messages';
import { type BuildRequest, ReliefService, type SurfaceRequest } from './relief_service';
import { tintOf } from './tint';

/** Returns the arrays of a surface, to transfer them instead of copying. */
function arraysOf(surface: Surface): ArrayBuffer[] {
  const { ink } = surface;
  const lines = ink ? [ink.positions, ink.uvs, ink.triangles] : [];
  return [surface.positions, surface.normals, surface.uvs, surface.triangles, surface.colors, ...lines].map((array) => array.buffer);
}

function arraysOfRelief({ surface, overlays }: BuiltRelief): ArrayBuffer[] {
  const lines = [overlays.joins, overlays.equal, overlays.above, overlays.below, overlays.ramps].map((array) => array.buffer);
  return [...arraysOf(surface), ...lines];
}

function pixelsOf(picture: ImageBitmap): Texture {
  const { width, height } = picture;
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('this browser has no canvas');
  context.drawImage(picture, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  return { rgba: new Uint8Array(data.buffer as ArrayBuffer), width, height };
}

function pictureOf({ rgba, width, height }: Texture): Promise<ImageBitmap> {
  return createImageBitmap(new ImageData(new Uint8ClampedArray(rgba), width, height));
}

/** Marks the arrays and the picture of a result for transfer. */
function handedOver<T extends Dressed>(made: T): T {
  return Comlink.transfer(made, [...arraysOf(made.surface), made.picture]);
}

let service: Promise<ReliefService> | undefined;

function started(): Promise<ReliefService> {
  if (!service) throw new Error('the worker has no module yet');
  return service;
}

const endpoint = {
  async start(compiled: WebAssembly.Module): Promise<void> {
    service = ReliefService.start(compiled);
    await service;
  },
  async importSvg(bytes: Uint8Array) {
    return (await started()).importSvg(bytes);
  },
  async departsFromPaint(bytes: Uint8Array, painting: Texture) {
    return (await started()).departsFromPaint(bytes, painting);
  },
  async unreadFile(bytes: Uint8Array) {
    return (await started()).unreadFile(bytes);
  },
  async openDrawing(drawing: FlatDrawing, network: Uint8Array) {
    const opened = (await started()).openDrawing(drawing, network);
    if (isFailure(opened)) return opened;
    return {};
  },
  async label(request: SegmentationRequest, width: number, height: number): Promise<TintedLabels | Failure> {
    const labelled = (await started()).label(request);
    if (isFailure(labelled)) return labelled;
    const tint = await createImageBitmap(tintOf(labelled.labels, width, height));
    return Comlink.transfer({ tint, bridges: labelled.bridges }, [tint]);
  },
  async understand(request: UnderstandingRequest) {
    return (await started()).understand(request);
  },
  async checkSegmentation(request: SegmentationRequest) {
    return (await started()).checkSegmentation(request);
  },
  async build(
    request: Omit<BuildRequest, 'drawing'>,
    drawing: ImageBitmap,
    progress: Progress,
  ): Promise<BuiltRelief | Failure> {
    let last = 0;
    const built = (await started()).build({ ...request, drawing: pixelsOf(drawing) }, (stage, done, energy) => {
      const now = performance.now();
      if (now - last < 50) return;
      last = now;
      progress(stage, done, energy);
    });
    return isFailure(built) ? built : Comlink.transfer(built, arraysOfRelief(built));
  },
  async importLayers(files: OutputFile[]) {
    return (await started()).importLayers(files);
  },
  async encodeLayers(scene: string, drawing: Texture) {
    return (await started()).encodeLayers(scene, drawing);
  },
  async surface(request: SurfaceRequest): Promise<Surface | Failure> {
    const surface = (await started()).surface(request);
    return isFailure(surface) ? surface : Comlink.transfer(surface, arraysOf(surface));
  },
  async dress(tolerance: number, inkWidth: number, drawing: ImageBitmap): Promise<Dressed | Failure> {
    const made = (await started()).dress(tolerance, inkWidth, pixelsOf(drawing));
    return isFailure(made) ? made : handedOver({ surface: made.surface, picture: await pictureOf(made) });
  },
  async encode(...arguments_: Parameters<ReliefService['encode']>) {
    return (await started()).encode(...arguments_);
  },
  async solid(options: SolidOptions, drawing: ImageBitmap): Promise<Solid | Failure> {
    const made = (await started()).solid(options, pixelsOf(drawing));
    if (isFailure(made)) return made;
    const { rgba, width, height, ...solid } = made;
    return handedOver({ ...solid, picture: await pictureOf({ rgba, width, height }) });
  },
  async encodeSolid(...arguments_: Parameters<ReliefService['encodeSolid']>) {
    return (await started()).encodeSolid(...arguments_);
  },
  async map(...arguments_: Parameters<ReliefService['map']>) {
    return (await started()).map(...arguments_);
  },
};

export type EngineEndpoint = typeof endpoint;

Comlink.expose(endpoint);
