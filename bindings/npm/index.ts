import createCore, { type Reconstruction, type RelievoModule } from './relievo.mjs';
import {
  type BuildOptions, type EngineError, type ExportFormat, type Failure, type Field, type MapKind,
  type OutputFile, type Progress, type Report, type SolidFacts, type SolidFormat, type SolidOptions,
  type Surface, type SvgImport, type Visibility, isFailure, told,
} from './messages.js';

export type {
  BuildOptions, ExportFormat, Field, MapKind, OutputFile, PartRun, Progress, Report, SolidFacts, SolidFormat,
  SolidOptions, Surface, SvgImport, Visibility,
} from './messages.js';

/** What cannot be done, and its culprit. */
export class RelievoError extends Error {
  readonly code: EngineError['code'];
  /** Path of a key of the scene, id of a part, name of an option, or empty. */
  readonly where: string;

  constructor(error: EngineError) {
    super(told(error));
    this.name = 'RelievoError';
    this.code = error.code;
    this.where = error.where;
  }
}

function taken<T extends object>(result: T | Failure): T {
  if (isFailure(result)) throw new RelievoError(result.error);
  return result;
}

const usualBuild: BuildOptions = {
  method: 'approximate', vertices: 40000, edge: 0, rho: 0.25, alpha0: 0, lambdaBnd: 0.01, lambdaShift: 1,
  glue: true,
};

/** `usual` with what is given; a name that there is not is refused. */
function settled<T extends object>(usual: T, given: Partial<T>): T {
  for (const name of Object.keys(given))
    if (!(name in usual))
      throw new RelievoError({
        code: 'usage', message: `there is no such option; there are ${Object.keys(usual).join(', ')}`, where: name,
      });
  return { ...usual, ...given };
}

/** The relief of a scene, which may change. Holds memory until it is freed. */
export class Relief {
  readonly #core: Reconstruction;
  #options = usualBuild;
  #report!: Report;

  /** @internal */
  constructor(core: Reconstruction, scene: string, options: Partial<BuildOptions>, progress?: Progress) {
    this.#core = core;
    this.rebuild(scene, options, progress);
  }

  /** Of the last build. */
  get report(): Report {
    return this.#report;
  }

  /** Brings the relief up to date; options that are not named stay. Computes only what has changed. */
  rebuild(scene: string, options: Partial<BuildOptions> = {}, progress: Progress = () => undefined): Report {
    this.#options = settled(this.#options, options);
    this.#report = taken(this.#core.build(scene, this.#options, progress));
    return this.#report;
  }

  /** Pixels of the drawing for files to come: four bytes each, straight alpha; none where empty. */
  setTexture(rgba: Uint8Array, width: number, height: number): void {
    this.#core.setTexture(rgba, width, height);
  }

  /** The surface in px of the canvas, its rim exact to `tolerance` px. */
  surface(visibility: Visibility = 'orbit', tolerance = 0.25, field: Field = 'relief'): Surface {
    return taken(this.#core.surface(visibility, tolerance, field));
  }

  /** The files of the model, the first of which is `name` with the format's ending. */
  encode(format: ExportFormat, name: string, sizeMm = 100): OutputFile[] {
    return taken(this.#core.encode(format, name, sizeMm)).files;
  }

  /** Volume, pieces and size of a closed solid, and its surface in mm. */
  solid(options: SolidOptions = {}): SolidFacts & { surface: Surface } {
    return taken(this.#core.solid(options));
  }

  /** Its files; as '3mf' the files of its package, to be zipped. */
  encodeSolid(format: SolidFormat, name: string, options: SolidOptions = {}): OutputFile[] {
    return taken(this.#core.encodeSolid(format, name, options)).files;
  }

  /** A map of the front view as a PNG file, `longest` px on the longer side. */
  map(kind: MapKind, longest = 2048, greenDown = false): Uint8Array {
    return taken(this.#core.map(kind, longest, greenDown)).bytes;
  }

  /** Gives its memory back; it is of no use any more. */
  free(): void {
    this.#core.delete();
  }
}

/** The core. */
export class Relievo {
  readonly #module: RelievoModule;

  /** @internal */
  constructor(module: RelievoModule) {
    this.#module = module;
  }

  /** The scene of a layered SVG drawing, to be built, and what should be known of it. */
  readSvg(bytes: Uint8Array): SvgImport {
    return taken(this.#module.importSvg(bytes));
  }

  /** The relief of the text of a scene file. */
  build(scene: string, options: Partial<BuildOptions> = {}, progress?: Progress): Relief {
    const core = new this.#module.Reconstruction();
    try {
      return new Relief(core, scene, options, progress);
    } catch (error) {
      core.delete();
      throw error;
    }
  }
}

async function bytesBeside(): Promise<BufferSource> {
  const url = new URL('./relievo.wasm', import.meta.url);
  if (url.protocol === 'file:') return (await import('node:fs/promises')).readFile(url);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.href}: ${String(response.status)}`);
  return response.arrayBuffer();
}

/** Loads the core, from relievo.wasm beside this file or from its bytes. */
export async function load(wasm?: BufferSource): Promise<Relievo> {
  const compiled = await WebAssembly.compile(wasm ?? await bytesBeside());
  const module = await createCore({
    instantiateWasm(imports, ready) {
      void WebAssembly.instantiate(compiled, imports).then(ready);
      return {};
    },
  });
  return new Relievo(module);
}
