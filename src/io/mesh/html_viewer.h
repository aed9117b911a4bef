#pragma once

#include <string_view>

namespace relievo {

/// Returns the page around its data. `vertices` are interleaved positions, normals and texture
/// coordinates as single precision numbers, `triangles` 32-bit indices, both base64; `picture` is a
/// data URL or empty, `ink` the number of indices at the end that are lines without light, seen
/// from one side, and `filter` the way to sample it, if that is not "LINEAR".
constexpr std::string_view viewer_head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
html, body { margin: 0; height: 100%; background: #e8e6e3; overflow: hidden }
canvas { width: 100%; height: 100%; display: block; touch-action: none; cursor: grab }
p { position: absolute; left: 1em; bottom: 0; color: #555; font: 14px sans-serif; pointer-events: none }
</style>
)";

constexpr std::string_view viewer_script = R"(
"use strict";
const canvas = document.querySelector("canvas");
const gl = canvas.getContext("webgl", { antialias: true });
const hint = document.querySelector("p");
if (!gl || !gl.getExtension("OES_element_index_uint"))
  hint.textContent = "This browser cannot show 3D models: WebGL is missing.";
else show();

function unpack(base64, Type) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

function compile(type, source) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  return shader;
}

function link() {
  const program = gl.createProgram();
  gl.attachShader(program, compile(gl.VERTEX_SHADER, `
    attribute vec3 position; attribute vec3 normal; attribute vec2 uv;
    uniform vec4 turn; uniform vec3 view;
    varying vec3 n; varying vec2 st;
    vec3 turned(vec3 p) {
      vec3 q = vec3(turn.x * p.x + turn.y * p.z, p.y, turn.x * p.z - turn.y * p.x);
      return vec3(q.x, turn.z * q.y - turn.w * q.z, turn.w * q.y + turn.z * q.z);
    }
    void main() {
      vec3 p = turned(position);
      n = turned(normal); st = uv;
      float w = 1.0 - 0.25 * p.z;
      gl_Position = vec4(p.xy * view.xy * view.z, -0.4 * p.z * w, w);
    }`));
  gl.attachShader(program, compile(gl.FRAGMENT_SHADER, `
    precision mediump float;
    uniform sampler2D picture; uniform float ink;
    varying vec3 n; varying vec2 st;
    void main() {
      vec3 m = normalize(n); if (!gl_FrontFacing) m = -m;
      float light = 0.55 + 0.15 * m.y + 0.45 * max(0.0, dot(m, normalize(vec3(-0.5, 0.6, 0.7))));
      gl_FragColor = vec4(texture2D(picture, st).rgb * mix(min(light, 1.15), 1.0, ink), 1.0);
    }`));
  gl.linkProgram(program);
  gl.useProgram(program);
  return program;
}

function show() {
  const program = link();
  const indices = unpack(model.triangles, Uint32Array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, unpack(model.vertices, Float32Array), gl.STATIC_DRAW);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  [["position", 3, 0], ["normal", 3, 12], ["uv", 2, 24]].forEach(([name, size, offset]) => {
    const at = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, 32, offset);
  });
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl[model.filter || "LINEAR"]);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl[model.filter || "LINEAR"]);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, 1, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array([214, 204, 190]));
  gl.enable(gl.DEPTH_TEST);
  gl.clearColor(0.91, 0.9, 0.89, 1);

  let yaw = 0.5, pitch = 0.15, zoom = 0.85;
  function draw() {
    const width = canvas.width = canvas.clientWidth * devicePixelRatio;
    const height = canvas.height = canvas.clientHeight * devicePixelRatio;
    const least = Math.min(width, height);
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniform4f(gl.getUniformLocation(program, "turn"), Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch));
    gl.uniform3f(gl.getUniformLocation(program, "view"), least / width, least / height, zoom);
    const lit = indices.length - model.ink;
    const ink = gl.getUniformLocation(program, "ink");
    gl.uniform1f(ink, 0);
    gl.disable(gl.CULL_FACE);
    gl.drawElements(gl.TRIANGLES, lit, gl.UNSIGNED_INT, 0);
    gl.uniform1f(ink, 1);
    gl.enable(gl.CULL_FACE);
    gl.drawElements(gl.TRIANGLES, indices.length - lit, gl.UNSIGNED_INT, 4 * lit);
  }
  const held = new Map();
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, event);
    hint.hidden = true;
  };
  canvas.onpointerup = canvas.onpointercancel = (event) => held.delete(event.pointerId);
  canvas.onpointermove = (event) => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const others = [...held.values()].filter((other) => other.pointerId !== event.pointerId);
    if (others.length > 0) {
      const far = (a) => Math.hypot(a.clientX - others[0].clientX, a.clientY - others[0].clientY);
      zoom = Math.min(20, Math.max(0.3, zoom * far(event) / Math.max(1, far(before))));
    } else {
      yaw += (event.clientX - before.clientX) / 150;
      pitch = Math.min(1.57, Math.max(-1.57, pitch + (event.clientY - before.clientY) / 150));
    }
    held.set(event.pointerId, event);
    draw();
  };
  canvas.onwheel = (event) => {
    event.preventDefault();
    zoom = Math.min(20, Math.max(0.3, zoom * Math.exp(-event.deltaY / 500)));
    draw();
  };
  addEventListener("resize", draw);
  const picture = new Image();
  picture.onload = () => {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, gl.RGB, gl.UNSIGNED_BYTE, picture);
    draw();
  };
  if (model.picture) picture.src = model.picture;
  draw();
}
)";

}  // namespace relievo
