#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>

#include "relief/drawing/drawing.h"
#include "relief/pipeline/build_relief.h"

namespace relievo::wasm {

/// A scene with its relief, held for the worker that asks for surfaces, files and maps of it.
/// Every call returns a plain object, {error} where it failed (see failure), and arrays that the
/// caller owns. After a build that failed, the relief before it stays.
class Reconstruction {
 public:
  /// `scene` is the text of a scene file. `options`: {method, vertices, edge, rho, alpha0,
  /// lambdaBnd, literal, glue}, all there. `progress(stage, fraction, energy)`, the last
  /// undefined but of the non-linear method. Returns {nodes, faces,
  /// equalities, inequalities, active, rounds, maxViolation, overlapWorst, converged, energy,
  /// times: {stage: ms}, warnings}.
  emscripten::val build(const std::string& scene, const emscripten::val& options,
                        const emscripten::val& progress);

  /// {positions, normals, uvs, triangles, parts: [{id, firstTriangle, triangleCount}]}, see Model;
  /// `tolerance` is its rim's, px. `field`: "relief", "inflation" or "shift", see keep_field.
  emscripten::val surface(const std::string& visibility, double tolerance,
                          const std::string& field) const;

  /// {joins, equal, above, ramps}, see Overlays.
  emscripten::val overlays() const;

  /// Pixels of the drawing for files to come: 4 bytes a pixel, straight alpha. None where the
  /// array is empty.
  void set_texture(const emscripten::val& rgba, int width, int height);

  /// {files: [{name, bytes}]}: the model named `name` as "glb", "obj", "ply" or "stl", as the
  /// command line writes it.
  emscripten::val encode(const std::string& format, const std::string& name, double size_mm) const;

  /// {bytes}: the "normal", "depth" or "part" map, PNG, longest side `side` px.
  emscripten::val map(const std::string& kind, int side, bool green_down) const;

 private:
  Scene scene_;
  std::optional<Relief> relief_;
  double alpha0_ = 0.1;
  Drawing texture_;
};

}  // namespace relievo::wasm
