/** The module that Emscripten makes of bindings/wasm. */
declare module '#relievo' {
  import type { Failure, Files, LayersImport, OutputFile, Overlays, PictureImport, Report, SvgImport, Surface } from './messages';
  import type { BuildOptions, ExportFormat, Field, MapKind, Progress, Visibility } from './messages';

  export interface Reconstruction {
    build(scene: string, options: BuildOptions, progress: Progress): Report | Failure;
    surface(visibility: Visibility, tolerance: number, field: Field): Surface | Failure;
    overlays(): Overlays | Failure;
    setTexture(rgba: Uint8Array, width: number, height: number): void;
    encode(format: ExportFormat, name: string, sizeMm: number): Files | Failure;
    map(kind: MapKind, side: number, greenDown: boolean): { bytes: Uint8Array } | Failure;
    delete(): void;
  }

  export interface RelievoModule {
    importSvg(bytes: Uint8Array): SvgImport | Failure;
    importPicture(rgba: Uint8Array, width: number, height: number): PictureImport | Failure;
    importLayers(files: OutputFile[]): LayersImport | Failure;
    Reconstruction: new () => Reconstruction;
  }

  export default function createRelievo(options: {
    instantiateWasm(
      imports: WebAssembly.Imports,
      ready: (instance: WebAssembly.Instance) => void,
    ): object;
  }): Promise<RelievoModule>;
}
