import * as Comlink from 'comlink';
import type { EngineEndpoint } from './engine_worker';
import type {
  BuiltRelief, Dressed, ExportFormat, Failure, Files, FileSettings, FlatDrawing, LayersImport, MapKind, OutputFile, Progress,
  SegmentationRequest, Solid, SolidFormat, SolidOptions, Surface, SvgImport, Texture, TintedLabels, Understanding, UnderstandingRequest,
  UnreadFile,
} from './messages';
import type { BuildRequest, SurfaceRequest } from './relief_service';

/**
 * The error of calls whose worker ended, because it was cancelled or because it crashed. A new worker has
 * taken its place.
 */
export class EngineStopped extends Error {
  constructor(readonly crashed: boolean, detail = '') {
    super(crashed ? `the engine stopped: ${detail}` : 'cancelled');
  }
}

interface RunningWorker {
  worker: Worker;
  remote: Comlink.Remote<EngineEndpoint>;
  ready: Promise<void>;
  stopped: Promise<never>;
  stop(reason: EngineStopped): void;
}

function startWorker(compiled: Promise<WebAssembly.Module>): RunningWorker {
  const worker = new Worker(new URL('./engine_worker.ts', import.meta.url), { type: 'module' });
  const remote = Comlink.wrap<EngineEndpoint>(worker);
  let stop: (reason: EngineStopped) => void = () => undefined;
  const stopped = new Promise<never>((_, reject) => {
    stop = reject;
  });
  stopped.catch(() => undefined);
  const ready = compiled.then((module) => remote.start(module));
  ready.catch(() => undefined);
  return { worker, remote, ready, stopped, stop };
}

/**
 * Runs the core in a worker. A call that is cancelled or whose worker crashes rejects with
 * EngineStopped, and a new worker starts. The page loses nothing, since it holds all documents itself.
 */
export class Engine {
  private running: RunningWorker;
  private calls = 0;

  constructor(private readonly compiled: Promise<WebAssembly.Module>) {
    this.running = startWorker(compiled);
    this.watch();
  }

  get busy(): boolean {
    return this.calls > 0;
  }

  /** Ends the running call at once. */
  cancel(): void {
    if (this.busy) this.restart(new EngineStopped(false));
  }

  importSvg(bytes: Uint8Array): Promise<SvgImport | Failure> {
    return this.call(async (remote) => await remote.importSvg(bytes));
  }

  departsFromPaint(bytes: Uint8Array, painting: Texture): Promise<{ departs: boolean } | Failure> {
    return this.call(async (remote) => await remote.departsFromPaint(bytes, painting));
  }

  unreadFile(bytes: Uint8Array): Promise<UnreadFile | null> {
    return this.call(async (remote) => await remote.unreadFile(bytes));
  }

  /** Opens a flat drawing; `network` holds the weights that the core perceives it with. */
  openDrawing(drawing: FlatDrawing, network: Uint8Array): Promise<object | Failure> {
    return this.call(async (remote) => await remote.openDrawing(drawing, network));
  }

  /** Computes the labels of strokes as a picture. `width` and `height` are those of the drawing. */
  label(request: SegmentationRequest, width: number, height: number): Promise<TintedLabels | Failure> {
    return this.call(async (remote) => await remote.label(request, width, height));
  }

  understand(request: UnderstandingRequest): Promise<Understanding | Failure> {
    return this.call(async (remote) => await remote.understand(request));
  }

  checkSegmentation(request: SegmentationRequest): Promise<object | Failure> {
    return this.call(async (remote) => await remote.checkSegmentation(request));
  }

  importLayers(files: OutputFile[]): Promise<LayersImport | Failure> {
    return this.call(async (remote) => await remote.importLayers(files));
  }

  encodeLayers(scene: string, drawing: Texture): Promise<{ bytes: Uint8Array } | Failure> {
    return this.call(async (remote) => await remote.encodeLayers(scene, drawing));
  }

  surface(request: SurfaceRequest): Promise<Surface | Failure> {
    return this.call(async (remote) => await remote.surface(request));
  }

  /** Returns the last build as exported files contain it; see ReliefService.dress. */
  dress(tolerance: number, inkWidth: number, drawing: ImageBitmap): Promise<Dressed | Failure> {
    return this.call(async (remote) => (await remote.dress(tolerance, inkWidth, drawing)) as Dressed | Failure);
  }

  /** Builds a relief; see BuildRequest. */
  build(request: Omit<BuildRequest, 'drawing'>, drawing: ImageBitmap, progress: Progress): Promise<BuiltRelief | Failure> {
    return this.call(async (remote) => await remote.build(request, drawing, Comlink.proxy(progress)));
  }

  encode(format: ExportFormat, name: string, settings: FileSettings, texture: Texture | null): Promise<Files | Failure> {
    return this.call(async (remote) => await remote.encode(format, name, settings, texture));
  }

  /** Makes a closed solid of the last build with `drawing`, at any size, as its texture. */
  solid(options: SolidOptions, drawing: ImageBitmap): Promise<Solid | Failure> {
    return this.call(async (remote) => (await remote.solid(options, drawing)) as Solid | Failure);
  }

  encodeSolid(format: SolidFormat, name: string, options: SolidOptions & Pick<FileSettings, 'inkWidth'>, texture: Texture): Promise<Files | Failure> {
    return this.call(async (remote) => await remote.encodeSolid(format, name, options, texture));
  }

  map(kind: MapKind, side: number, greenDown: boolean): Promise<{ bytes: Uint8Array } | Failure> {
    return this.call(async (remote) => await remote.map(kind, side, greenDown));
  }

  private async call<T>(work: (remote: Comlink.Remote<EngineEndpoint>) => Promise<T>): Promise<T> {
    const { remote, ready, stopped } = this.running;
    this.calls++;
    try {
      await Promise.race([ready, stopped]);
      return await Promise.race([work(remote), stopped]);
    } catch (error) {
      // A trap or a lack of memory leaves the module in an unknown state, so the worker is replaced.
      if (error instanceof EngineStopped) throw error;
      const reason = new EngineStopped(true, String(error));
      if (this.running.remote === remote) this.restart(reason);
      throw reason;
    } finally {
      this.calls--;
    }
  }

  private restart(reason: EngineStopped): void {
    const old = this.running;
    old.worker.terminate();
    this.running = startWorker(this.compiled);
    this.watch();
    old.stop(reason);
  }

  private watch(): void {
    const { worker } = this.running;
    worker.addEventListener('error', (event) => {
      if (this.running.worker === worker) this.restart(new EngineStopped(true, event.message));
    });
  }
}

/** Returns a function that loads a file when it is called first. A load that failed is tried again. */
export function loadOnce(url: string): () => Promise<Uint8Array> {
  let loaded: Promise<Uint8Array> | null = null;
  const load = async (): Promise<Uint8Array> => {
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`${url}: ${String(answer.status)}`);
    return new Uint8Array(await answer.arrayBuffer());
  };
  return () => {
    loaded ??= load().catch((error: unknown) => {
      loaded = null;
      throw error;
    });
    return loaded;
  };
}

/** Compiles the core once for all workers. */
export function compileCore(url: string): Promise<WebAssembly.Module> {
  return WebAssembly.compileStreaming(fetch(url));
}
