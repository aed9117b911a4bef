import createCore, { type Reconstruction, type RelievoModule } from './relievo.mjs';
import {
  type BuildOptions, type EngineError, type ExportFormat, type Failure, type Field, type MapKind,
  type OutputFile, type Progress, type Report, type SolidFacts, type SolidFormat, type SolidOptions,
  type Surface, type SvgImport, type Visibility, errorText, isFailure,
} from './messages.js';

export type {
  BuildOptions, ExportFormat, Field, MapKind, OutputFile, PartRun, Progress, Report, SolidFacts, SolidFormat,
  SolidOptions, Surface, SvgImport, Visibility,
} from './messages.js';

/** The error that every call throws if it fails. */
export class RelievoError extends Error {
  readonly code: EngineError['code'];
  /** The place, for a person: the path of a key of the scene, the id of a part, the name of an option, or empty. */
  readonly where: string;
  /** The item of the scene at fault, if there is one. */
  readonly culprit: EngineError['culprit'];

  constructor(error: EngineError) {
    super(errorText(error));
    this.name = 'RelievoError';
    this.code = error.code;
    this.where = error.where;
    this.culprit = error.culprit;
  }
}

/** Returns a result, or throws its error. */
function unwrap<T extends object>(result: T | Failure): T {
  if (isFailure(result)) throw new RelievoError(result.error);
  return result;
}

const defaultBuild: BuildOptions = {
  method: 'approximate', vertices: 40000, edge: 0, rho: 0.25, alpha0: 0, lambdaBnd: 0.01, lambdaShift: 1,
  glue: true,
};

/** Returns `base` with the values of `changes`. Throws if a name is unknown. */
function merged<T extends object>(base: T, changes: Partial<T>): T {
  for (const name of Object.keys(changes))
    if (!(name in base))
      throw new RelievoError({
        code: 'usage', message: `there is no such option; the options are ${Object.keys(base).join(', ')}`, where: name,
      });
  return { ...base, ...changes };
}

/** The relief of a scene, which may be rebuilt after changes. Call `free` to release its memory. */
export class Relief {
  readonly #core: Reconstruction;
  #options = defaultBuild;
  #report!: Report;

  /** @internal */
  constructor(core: Reconstruction, scene: string, options: Partial<BuildOptions>, progress?: Progress) {
    this.#core = core;
    this.rebuild(scene, options, progress);
  }

  /** The report of the last build. */
  get report(): Report {
    return this.#report;
  }

  /** Rebuilds the relief. Options that are not given keep their values; unchanged stages are not computed again. */
  rebuild(scene: string, options: Partial<BuildOptions> = {}, progress: Progress = () => undefined): Report {
    this.#options = merged(this.#options, options);
    this.#report = unwrap(this.#core.build(scene, this.#options, progress));
    return this.#report;
  }

  /** Sets the drawing for files to be encoded: four bytes per pixel, straight alpha. An empty array removes it. */
  setTexture(rgba: Uint8Array, width: number, height: number): void {
    this.#core.setTexture(rgba, width, height);
  }

  /** Returns the surface in px of the canvas. Its rim is exact to `tolerance` px. */
  surface(visibility: Visibility = 'orbit', tolerance = 0.25, field: Field = 'relief'): Surface {
    return unwrap(this.#core.surface(visibility, tolerance, field));
  }

  /** Encodes the model. The first file is `name` with the extension of the format. */
  encode(format: ExportFormat, name: string, sizeMm = 100): OutputFile[] {
    return unwrap(this.#core.encode(format, name, sizeMm)).files;
  }

  /** Makes a closed solid. Returns its volume, number of pieces and size, and its surface in mm. */
  solid(options: SolidOptions = {}): SolidFacts & { surface: Surface } {
    return unwrap(this.#core.solid(options));
  }

  /** Encodes a closed solid. For '3mf', returns the files of the package, which the caller zips. */
  encodeSolid(format: SolidFormat, name: string, options: SolidOptions = {}): OutputFile[] {
    return unwrap(this.#core.encodeSolid(format, name, options)).files;
  }

  /** Returns a map of the front view as a PNG file, `longest` px on the longer side. */
  map(kind: MapKind, longest = 2048, greenDown = false): Uint8Array {
    return unwrap(this.#core.map(kind, longest, greenDown)).bytes;
  }

  /** Releases the memory. Nothing may be called afterwards. */
  free(): void {
    this.#core.delete();
  }
}

/** The loaded core. */
export class Relievo {
  readonly #module: RelievoModule;

  /** @internal */
  constructor(module: RelievoModule) {
    this.#module = module;
  }

  /** Reads a layered SVG drawing. Returns its scene, ready to be built, and warnings. */
  readSvg(bytes: Uint8Array): SvgImport {
    return unwrap(this.#module.importSvg(bytes));
  }

  /** Builds the relief of a scene, given as the text of a scene file. */
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

/** Reads relievo.wasm from the folder of this file. */
async function bytesBeside(): Promise<BufferSource> {
  const url = new URL('./relievo.wasm', import.meta.url);
  if (url.protocol === 'file:') return (await import('node:fs/promises')).readFile(url);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.href}: ${String(response.status)}`);
  return response.arrayBuffer();
}

/** Loads the core from `wasm`, or from relievo.wasm beside this file. */
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
