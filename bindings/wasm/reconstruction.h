#pragma once

#include <emscripten/val.h>

#include <string>

#include "relievo/session.h"

namespace relievo::wasm {

/// A scene with its relief, for surfaces, files and maps. A build reuses the results of the last
/// one (see Session). Every call returns a plain object with arrays that the caller owns, or
/// {error} if it fails (see failure).
class Reconstruction {
 public:
  /// Builds a scene, the text of a scene file. `options` has all of {method, vertices, edge, rho,
  /// alpha0, lambdaBnd, lambdaShift, glue}. Calls `progress(stage, fraction, energy)`, whose energy
  /// is undefined except by the non-linear method. Returns {nodes, faces, equalities, inequalities,
  /// active, maxViolation, overlapWorst, converged, energy, times: {stage: ms}, warnings}.
  emscripten::val build(const std::string& scene, const emscripten::val& options,
                        const emscripten::val& progress);

  /// Returns {positions, normals, uvs, triangles, colors, parts: [{id, firstTriangle,
  /// triangleCount, hiddenCount}]}; see Model and hidden_colours. `tolerance` is that of the rim,
  /// px. `field` is "relief", "inflation" or "shift"; see keep_field.
  emscripten::val surface(const std::string& visibility, double tolerance,
                          const std::string& field) const;

  /// Returns {surface, rgba, width, height}: the surface of whole parts as in files, and the
  /// picture on it (finish_model). The surface has `ink`, {positions, uvs, triangles}, if contours
  /// are drawn. `ink_width`: factor for their width; 0: none are drawn.
  emscripten::val dressed(double tolerance, double ink_width) const;

  /// Returns {joins, equal, above, below, ramps}; see MeshLines.
  emscripten::val overlays() const;

  /// Sets the drawing, which may be reduced, for the colours of surfaces. The format is that of
  /// set_texture.
  void set_shown(const emscripten::val& rgba, int width, int height);

  /// Sets the drawing for files: 4 bytes per pixel, straight alpha. An empty array removes it.
  void set_texture(const emscripten::val& rgba, int width, int height);

  /// Returns {files: [{name, bytes}]}, the model as "glb", "obj", "ply", "stl", "usdz" or "html".
  /// The bytes are those of the command line. `ink_width`: as of dressed, in files that hold
  /// shells.
  emscripten::val encode(const std::string& format, const std::string& name, double size_mm,
                         double ink_width);

  /// Makes a closed solid. `options` may have those of SolidOptions, by name, except `mirror`.
  /// Returns {surface, size: [mm, mm, mm], volume, pieces, findings: [{trouble, part, measure,
  /// enough}], rgba, width, height}: a surface in mm that starts at x = y = 0 and lies around z =
  /// 0, its picture, and the findings of check_print.
  emscripten::val solid(const emscripten::val& options) const;

  /// Returns {files} of a closed solid; see encode. For "3mf", they are the files of the package.
  emscripten::val encode_solid(const std::string& format, const std::string& name,
                               const emscripten::val& options, double ink_width);

  /// Returns {bytes}, the "normal", "depth" or "part" map as a PNG file, `side` px on the longer
  /// side.
  emscripten::val map(const std::string& kind, int side, bool green_down);

 private:
  Session session_;
  Drawing texture_;
  Drawing shown_;
};

}  // namespace relievo::wasm
