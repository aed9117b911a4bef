/** The module that Emscripten builds from bindings/wasm. */
declare module '#relievo' {
  import type {
    Failure, Files, Labelled, LayersImport, OutputFile, Overlays, Report, SolidFacts, SvgImport, Surface,
    Texture, Understanding, UnreadFile,
  } from './messages';
  import type {
    BuildOptions, ExportFormat, Field, MapKind, Progress, SolidFormat, SolidOptions, Visibility,
  } from './messages';

  export interface Reconstruction {
    build(scene: string, options: BuildOptions, progress: Progress): Report | Failure;
    surface(visibility: Visibility, tolerance: number, field: Field): Surface | Failure;
    dressed(tolerance: number, inkWidth: number): (Texture & { surface: Surface }) | Failure;
    overlays(): Overlays | Failure;
    setShown(rgba: Uint8Array, width: number, height: number): void;
    setTexture(rgba: Uint8Array, width: number, height: number): void;
    encode(format: ExportFormat, name: string, sizeMm: number, inkWidth: number): Files | Failure;
    solid(options: SolidOptions): (SolidFacts & { surface: Surface; rgba: Uint8Array; width: number; height: number }) | Failure;
    encodeSolid(format: SolidFormat, name: string, options: SolidOptions, inkWidth: number): Files | Failure;
    map(kind: MapKind, side: number, greenDown: boolean): { bytes: Uint8Array } | Failure;
    delete(): void;
  }

  export interface Segmenter {
    openPng(file: Uint8Array, network: Uint8Array): object | Failure;
    openPixels(rgba: Uint8Array, width: number, height: number, network: Uint8Array): object | Failure;
    label(project: string, last: Uint8Array): Labelled | Failure;
    propose(project: string, last: Uint8Array, edited: string): Understanding | Failure;
    delete(): void;
  }

  export interface RelievoModule {
    importSvg(bytes: Uint8Array): SvgImport | Failure;
    departsFromPaint(bytes: Uint8Array, rgba: Uint8Array, width: number, height: number): { departs: boolean } | Failure;
    unreadFile(bytes: Uint8Array): UnreadFile | null;
    checkSegmentation(project: string, labels: Uint8Array): object | Failure;
    importLayers(files: OutputFile[]): LayersImport | Failure;
    encodeLayers(scene: string, rgba: Uint8Array, width: number, height: number): { bytes: Uint8Array } | Failure;
    Reconstruction: new () => Reconstruction;
    Segmenter: new () => Segmenter;
  }

  export default function createRelievo(options: {
    instantiateWasm(
      imports: WebAssembly.Imports,
      ready: (instance: WebAssembly.Instance) => void,
    ): object;
  }): Promise<RelievoModule>;
}
