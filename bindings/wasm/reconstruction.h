#pragma once

#include <emscripten/val.h>

#include <string>

#include "relievo/session.h"

namespace relievo::wasm {

/// A scene with its relief, held for the worker that asks for surfaces, files and maps of it. A
/// build goes on from the last one (see Session). Every call returns a plain object, {error}
/// where it failed (see failure), and arrays that the caller owns.
class Reconstruction {
 public:
  /// `scene` is the text of a scene file. `options`: {method, vertices, edge, rho, alpha0,
  /// lambdaBnd, lambdaShift, glue}, all there. `progress(stage, fraction, energy)`, the last
  /// undefined but of the non-linear method. Returns {nodes, faces,
  /// equalities, inequalities, active, rounds, maxViolation, overlapWorst, converged, energy,
  /// times: {stage: ms}, warnings}.
  emscripten::val build(const std::string& scene, const emscripten::val& options,
                        const emscripten::val& progress);

  /// {positions, normals, uvs, triangles, colors, parts: [{id, firstTriangle, triangleCount,
  /// hiddenCount}]}, see Model and hidden_colours; `tolerance` is its rim's, px. `field`: "relief",
  /// "inflation" or "shift", see keep_field.
  emscripten::val surface(const std::string& visibility, double tolerance,
                          const std::string& field) const;

  /// {surface, rgba, width, height}: the surface of orbit with finished rims, and the drawing set as
  /// texture, with paint that continues over them (finish_rims).
  emscripten::val dressed(double tolerance) const;

  /// {joins, equal, above, ramps}, see Overlays.
  emscripten::val overlays() const;

  /// Pixels of the drawing, however small, for the colours of surfaces to come; likewise.
  void set_shown(const emscripten::val& rgba, int width, int height);

  /// Pixels of the drawing for files to come: 4 bytes a pixel, straight alpha. None where the
  /// array is empty.
  void set_texture(const emscripten::val& rgba, int width, int height);

  /// {files: [{name, bytes}]}: the model named `name` as "glb", "obj", "ply", "stl", "usdz" or
  /// "html", as the command line writes it, to the last bit.
  emscripten::val encode(const std::string& format, const std::string& name, double size_mm);

  /// A closed solid of what is built. `options`: those of SolidOptions that are not as usual, by
  /// their names; limbs cannot be mirrored here. Returns {surface, size: [mm, mm, mm], volume,
  /// pieces, findings: [{trouble, part, measure, enough}], rgba, width, height}: a surface in mm,
  /// from x = y = 0 on and around z = 0, its picture, and what check_print finds.
  emscripten::val solid(const emscripten::val& options) const;

  /// {files}: such a solid, likewise; as "3mf" the files of its package.
  emscripten::val encode_solid(const std::string& format, const std::string& name,
                               const emscripten::val& options);

  /// {bytes}: the "normal", "depth" or "part" map, PNG, longest side `side` px, likewise.
  emscripten::val map(const std::string& kind, int side, bool green_down);

 private:
  Session session_;
  Drawing texture_;
  Drawing shown_;
};

}  // namespace relievo::wasm
