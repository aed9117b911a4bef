import * as Comlink from 'comlink';
import { ModelRenderer } from './model_renderer';
import { type Renderer, SoftwareRenderer } from './software_renderer';

/** A renderer for a canvas, by the processor alone where there are no graphics. `lost`: they are gone. */
function start(canvas: OffscreenCanvas, lost: () => void): Renderer & Comlink.ProxyMarked {
  try {
    const renderer = new ModelRenderer(canvas);
    canvas.addEventListener('webglcontextlost', () => lost());
    return Comlink.proxy(renderer);
  } catch {
    return Comlink.proxy(new SoftwareRenderer(canvas));
  }
}

export type StartRenderer = typeof start;

Comlink.expose(start);
