import * as Comlink from 'comlink';
import { type BuiltRelief, type Failure, isFailure, type OutputFile, type Progress, type Surface, type Texture } from './messages';
import { type BuildRequest, ReliefService, type SurfaceRequest } from './relief_service';

/** Every array of a surface, to be handed over instead of copied. */
function arraysOf(surface: Surface): ArrayBuffer[] {
  return [surface.positions, surface.normals, surface.uvs, surface.triangles].map((array) => array.buffer);
}

function arraysOfRelief({ surface, overlays }: BuiltRelief): ArrayBuffer[] {
  const lines = [overlays.joins, overlays.equal, overlays.above, overlays.ramps].map((array) => array.buffer);
  return [...arraysOf(surface), ...lines];
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
  async importPicture(picture: Texture) {
    return (await started()).importPicture(picture);
  },
  async build(
    request: BuildRequest,
    progress: Progress,
  ): Promise<BuiltRelief | Failure> {
    let last = 0;
    const built = (await started()).build(request, (stage, done, energy) => {
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
  async surface(request: SurfaceRequest): Promise<Surface | Failure> {
    const surface = (await started()).surface(request);
    return isFailure(surface) ? surface : Comlink.transfer(surface, arraysOf(surface));
  },
  async encode(...arguments_: Parameters<ReliefService['encode']>) {
    return (await started()).encode(...arguments_);
  },
  async map(...arguments_: Parameters<ReliefService['map']>) {
    return (await started()).map(...arguments_);
  },
};

export type EngineEndpoint = typeof endpoint;

Comlink.expose(endpoint);
