import * as Comlink from 'comlink';
import { type BuiltRelief, type Failure, isFailure, type Texture } from './messages';
import { type BuildRequest, ReliefService } from './relief_service';

/** Every array of a result, to be handed over instead of copied. */
function arraysOf(built: BuiltRelief): ArrayBuffer[] {
  const { surface, overlays } = built;
  return [
    surface.positions, surface.normals, surface.uvs, surface.triangles,
    overlays.joins, overlays.equal, overlays.above, overlays.ramps,
  ].map((array) => array.buffer);
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
    progress: (stage: string, done: number) => void,
  ): Promise<BuiltRelief | Failure> {
    let last = 0;
    const built = (await started()).build(request, (stage, done) => {
      const now = performance.now();
      if (now - last < 50) return;
      last = now;
      progress(stage, done);
    });
    return isFailure(built) ? built : Comlink.transfer(built, arraysOf(built));
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
