import * as Comlink from 'comlink';
import { ModelRenderer } from './model_renderer';
import { type Renderer, SoftwareRenderer } from './software_renderer';

/**
 * Returns a renderer for a canvas, without 3D graphics if there are none. `lost` is called when the graphics
 * are lost.
 */
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
