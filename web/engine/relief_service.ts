import createRelievo, { type Reconstruction, type RelievoModule, type Segmenter } from '#relievo';
import {
  type BuildOptions,
  type BuiltRelief,
  type ExportFormat,
  type Field,
  type FileSettings,
  type Failure,
  type Files,
  type FlatDrawing,
  type LayersImport,
  type OutputFile,
  type Progress,
  type Surface,
  isFailure,
  type Labelled,
  type MapKind,
  type SegmentationRequest,
  type SolidFormat,
  type SolidOptions,
  type SvgImport,
  type Texture,
  type Understanding,
  type UnderstandingRequest,
  type UnreadFile,
  type Visibility,
} from './messages';

export interface SurfaceRequest {
  visibility: Visibility;
  /** Largest deviation from the exact surface, px. */
  tolerance: number;
  field: Field;
}

export interface BuildRequest extends SurfaceRequest {
  /** A small version of the drawing, for the colours of hidden surfaces; null: all white. */
  drawing: Texture | null;
  scene: string;
  options: BuildOptions;
}

const noTexture: Texture = { rgba: new Uint8Array(), width: 0, height: 0 };

/** One instance of the core. It runs in the worker, and under Node in tests. */
export class ReliefService {
  private readonly reconstruction: Reconstruction;
  private readonly segmenter: Segmenter;

  private constructor(private readonly module: RelievoModule) {
    this.reconstruction = new module.Reconstruction();
    this.segmenter = new module.Segmenter();
  }

  static async start(compiled: WebAssembly.Module): Promise<ReliefService> {
    const module = await createRelievo({
      instantiateWasm(imports, ready) {
        void WebAssembly.instantiate(compiled, imports).then(ready);
        return {};
      },
    });
    return new ReliefService(module);
  }

  importSvg(bytes: Uint8Array): SvgImport | Failure {
    return this.module.importSvg(bytes);
  }

  /** Tells whether the shapes of an SVG drawing are not those that are painted. */
  departsFromPaint(bytes: Uint8Array, painting: Texture): { departs: boolean } | Failure {
    return this.module.departsFromPaint(bytes, painting.rgba, painting.width, painting.height);
  }

  /** Says what a file is that could not be opened; null if there is nothing to say. */
  unreadFile(bytes: Uint8Array): UnreadFile | null {
    return this.module.unreadFile(bytes);
  }

  /** Opens a flat drawing for scribbling. `network` holds the weights that it is perceived with. */
  openDrawing(drawing: FlatDrawing, network: Uint8Array): object | Failure {
    if ('png' in drawing) return this.segmenter.openPng(drawing.png, network);
    const { rgba, width, height } = drawing.pixels;
    return this.segmenter.openPixels(rgba, width, height, network);
  }

  label({ project, labels }: SegmentationRequest): Labelled | Failure {
    return this.segmenter.label(project, labels);
  }

  understand({ project, labels, edited }: UnderstandingRequest): Understanding | Failure {
    return this.segmenter.propose(project, labels, edited);
  }

  checkSegmentation({ project, labels }: SegmentationRequest): object | Failure {
    return this.module.checkSegmentation(project, labels);
  }

  importLayers(files: OutputFile[]): LayersImport | Failure {
    return this.module.importLayers(files);
  }

  /** Encodes the parts of a scene as layers of a Photoshop document. The texture covers the scene's canvas. */
  encodeLayers(scene: string, { rgba, width, height }: Texture): { bytes: Uint8Array } | Failure {
    return this.module.encodeLayers(scene, rgba, width, height);
  }

  build(request: BuildRequest, progress: Progress): BuiltRelief | Failure {
    const report = this.reconstruction.build(request.scene, request.options, progress);
    if (isFailure(report)) return report;
    const { rgba, width, height } = request.drawing ?? noTexture;
    this.reconstruction.setShown(rgba, width, height);
    const surface = this.surface(request);
    if (isFailure(surface)) return surface;
    const overlays = this.reconstruction.overlays();
    return isFailure(overlays) ? overlays : { report, surface, overlays };
  }

  /** Returns the surface of the last build for another field or tolerance. */
  surface({ visibility, tolerance, field }: SurfaceRequest): Surface | Failure {
    return this.reconstruction.surface(visibility, tolerance, field);
  }

  /**
   * Returns the last build as exported files contain it: contours are lines of their own, and the picture
   * continues around rims and behind parts. `inkWidth`: factor for the width of contours; 0: none are drawn.
   */
  dress(tolerance: number, inkWidth: number, texture: Texture) {
    this.reconstruction.setTexture(texture.rgba, texture.width, texture.height);
    return this.reconstruction.dressed(tolerance, inkWidth);
  }

  encode(format: ExportFormat, name: string, { sizeMm, inkWidth }: FileSettings, texture: Texture | null): Files | Failure {
    const drawn = texture ?? noTexture;
    this.reconstruction.setTexture(drawn.rgba, drawn.width, drawn.height);
    return this.reconstruction.encode(format, name, sizeMm, inkWidth);
  }

  /** Makes a closed solid of the last build, with its texture; `texture` is the drawing. */
  solid(options: SolidOptions, texture: Texture) {
    this.reconstruction.setTexture(texture.rgba, texture.width, texture.height);
    return this.reconstruction.solid(options);
  }

  /** Encodes that solid as a file or, for 3MF, as the files of its package. */
  encodeSolid(format: SolidFormat, name: string, options: SolidOptions & Pick<FileSettings, 'inkWidth'>, texture: Texture): Files | Failure {
    const { inkWidth, ...solid } = options;
    this.reconstruction.setTexture(texture.rgba, texture.width, texture.height);
    return this.reconstruction.encodeSolid(format, name, solid, inkWidth);
  }

  map(kind: MapKind, side: number, greenDown: boolean): { bytes: Uint8Array } | Failure {
    return this.reconstruction.map(kind, side, greenDown);
  }
}
