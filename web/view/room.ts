import type { Lines, Surface } from '../engine/messages';
import { type Mat4, placed, scaledTo } from './room_place';

const vertexSource = `#version 300 es
in vec3 position;
in vec3 normal;
in vec2 uv;
in vec3 color;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
out vec3 facing;
out vec2 place;
out vec3 own;
void main() {
  facing = normal;
  place = uv;
  own = color;
  gl_Position = projection * view * model * vec4(position, 1.0);
}`;

/** Soft light from the upper left, as in a room. */
const fragmentSource = `#version 300 es
precision highp float;
in vec3 facing;
in vec2 place;
in vec3 own;
uniform sampler2D drawing;
uniform bool hidden;
uniform bool lit;
out vec4 result;
void main() {
  float light = lit ? 0.62 + 0.42 * max(0.0, dot(normalize(facing), normalize(vec3(-0.45, 0.6, 0.66)))) : 1.0;
  vec3 paint = hidden ? own : texture(drawing, place).rgb;
  result = vec4(light * paint, 1.0);
}`;

/** Distance of the model in front of the eyes or the hand, m. */
const reach = 0.7;

/** Draws a model in a WebXR session. */
class RoomModel {
  private readonly program: WebGLProgram;
  private readonly uniform: (name: string) => WebGLUniformLocation | null;
  private readonly body: WebGLVertexArrayObject;
  private readonly lines: WebGLVertexArrayObject | null;

  constructor(private readonly gl: WebGL2RenderingContext, private readonly surface: Surface, drawing: TexImageSource) {
    this.program = this.link();
    this.uniform = (name) => gl.getUniformLocation(this.program, name);
    this.body = this.loaded(surface);
    this.fill('normal', surface.normals, 3, gl.FLOAT);
    this.fill('color', surface.colors, 3, gl.UNSIGNED_BYTE);
    this.lines = surface.ink ? this.loaded(surface.ink) : null;
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, drawing);
    gl.generateMipmap(gl.TEXTURE_2D);
  }

  draw(place: Mat4, view: XRView): void {
    const { gl } = this;
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    gl.uniformMatrix4fv(this.uniform('model'), false, place);
    gl.uniformMatrix4fv(this.uniform('view'), false, view.transform.inverse.matrix);
    gl.uniformMatrix4fv(this.uniform('projection'), false, view.projectionMatrix);
    gl.bindVertexArray(this.body);
    gl.uniform1i(this.uniform('lit'), 1);
    gl.disable(gl.CULL_FACE);
    for (const { firstTriangle, triangleCount, hiddenCount } of this.surface.parts) {
      const seen = triangleCount - hiddenCount;
      this.run(false, firstTriangle, seen);
      this.run(true, firstTriangle + seen, hiddenCount);
    }
    const { ink } = this.surface;
    if (!ink) return;
    gl.bindVertexArray(this.lines);
    gl.uniform1i(this.uniform('lit'), 0);
    gl.enable(gl.CULL_FACE);
    this.run(false, 0, ink.triangles.length / 3);
  }

  /** Returns the places, texture coordinates and triangles of a mesh. */
  private loaded({ positions, uvs, triangles }: Lines): WebGLVertexArrayObject {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.fill('position', positions, 3, gl.FLOAT);
    this.fill('uv', uvs, 2, gl.FLOAT);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    return array;
  }

  private run(hidden: boolean, first: number, count: number): void {
    const { gl } = this;
    gl.uniform1i(this.uniform('hidden'), hidden ? 1 : 0);
    gl.drawElements(gl.TRIANGLES, 3 * count, gl.UNSIGNED_INT, 12 * first);
  }

  private link(): WebGLProgram {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertexSource], [gl.FRAGMENT_SHADER, fragmentSource]] as const) {
      const shader = gl.createShader(kind);
      if (!shader) throw new Error('no graphics');
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? 'no graphics');
    return program;
  }

  private fill(name: string, values: Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>, size: number, type: number): void {
    const { gl } = this;
    const at = gl.getAttribLocation(this.program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, type, type === gl.UNSIGNED_BYTE, 0, 0);
  }
}

interface RoomContent {
  readonly surface: Surface;
  readonly drawing: TexImageSource;
  /** Longest side, mm. */
  readonly sizeMm: number;
}

/**
 * Shows a model at its real size in front of the viewer. A tap or a trigger moves it. Resolves when the
 * session ends.
 */
export async function showInRoom(session: XRSession, { surface, drawing, sizeMm }: RoomContent): Promise<void> {
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { xrCompatible: true });
  if (!gl) throw new Error('no graphics');
  const ended = new Promise<void>((resolve) => session.addEventListener('end', () => resolve(), { once: true }));
  const layer = new XRWebGLLayer(session, gl);
  await session.updateRenderState({ baseLayer: layer });
  const space = await session.requestReferenceSpace('local');
  const model = new RoomModel(gl, surface, drawing);
  const size = scaledTo(surface.positions, sizeMm / 1000);
  let place: Mat4 | null = null;
  session.addEventListener('select', ({ frame, inputSource }) => {
    const aimed = frame.getPose(inputSource.targetRaySpace, space);
    if (aimed) place = placed(size, aimed.transform.matrix, reach);
  });
  const draw = (_time: number, frame: XRFrame): void => {
    session.requestAnimationFrame(draw);
    const pose = frame.getViewerPose(space);
    if (!pose) return;
    place ??= placed(size, pose.transform.matrix, reach);
    gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const view of pose.views) {
      const port = layer.getViewport(view);
      if (!port) continue;
      gl.viewport(port.x, port.y, port.width, port.height);
      model.draw(place, view);
    }
  };
  session.requestAnimationFrame(draw);
  await ended;
  gl.getExtension('WEBGL_lose_context')?.loseContext();
}
