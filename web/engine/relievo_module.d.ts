/** The module that Emscripten makes of bindings/wasm. */
declare module '#relievo' {
  import type { Failure, Files, Overlays, PictureImport, Report, SvgImport, Surface } from './messages';
  import type { BuildOptions, ExportFormat, MapKind, Visibility } from './messages';

  export interface Reconstruction {
    build(scene: string, options: BuildOptions, progress: (stage: string, done: number) => void): Report | Failure;
    surface(visibility: Visibility, tolerance: number): Surface | Failure;
    overlays(): Overlays | Failure;
    setTexture(rgba: Uint8Array, width: number, height: number): void;
    encode(format: ExportFormat, name: string, sizeMm: number): Files | Failure;
    map(kind: MapKind, side: number, greenDown: boolean): { bytes: Uint8Array } | Failure;
    delete(): void;
  }

  export interface RelievoModule {
    importSvg(bytes: Uint8Array): SvgImport | Failure;
    importPicture(rgba: Uint8Array, width: number, height: number): PictureImport | Failure;
    Reconstruction: new () => Reconstruction;
  }

  export default function createRelievo(options: {
    instantiateWasm(
      imports: WebAssembly.Imports,
      ready: (instance: WebAssembly.Instance) => void,
    ): object;
  }): Promise<RelievoModule>;
}
