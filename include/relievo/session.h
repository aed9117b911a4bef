#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "relievo/image.h"
#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/options.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "relievo/solid.h"

namespace relievo {

/// Sizes, quality and times of a build.
struct BuildReport {
  size_t vertices = 0;
  size_t faces = 0;
  int equalities = 0;        ///< number of vertices fixed to the height of another
  int inequalities = 0;      ///< number of pairs of vertices kept in order
  int active = 0;            ///< number of these pairs that touch
  double max_violation = 0;  ///< greatest violation of a pair's order, px
  double worst_overlap = 0;  ///< greatest height by which a hidden face comes out in front, px
  double energy = 0;         ///< of the non-linear method, in scene units
  bool converged = true;     ///< whether the non-linear method did
  std::map<std::string, double> milliseconds;  ///< by stage
  std::vector<std::string> warnings;
};

/// The annotations of a scene on its mesh, as segments of edges in canvas px.
struct MeshLines {
  std::vector<float> joins;  ///< S x 4: x0 y0 x1 y1
  std::vector<float> equal;  ///< S x 4: outlines fixed to the height of the part behind
  std::vector<float> above;  ///< S x 4: outlines kept in front of or behind another part
  std::vector<float> below;  ///< S x 4: outlines kept so against the order of parts
  std::vector<float> ramps;  ///< S x 6: x0 y0 x1 y1, then alpha [P eq 9] at both ends
};

/// The relief of a scene that may change. A build starts from the previous one and computes only
/// the stages whose input has changed. Not for several threads at once.
class Session {
 public:
  Session();
  ~Session();
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;

  /// Builds the relief of a scene. Errors: `bad_input`, `contradiction` (both name the part, join
  /// or relation), `limit`, `usage` for options out of range, `interrupted`; after an error there
  /// is no relief until a build succeeds.
  Result<BuildReport> build(const Scene& scene, const BuildOptions& options = {},
                            const RunContext& context = {});

  /// Builds again from nothing if the last build started from another one. The numbers then equal
  /// those of a new session to the last bit; before, they do up to round-off. Errors: as build.
  Status make_exact(const RunContext& context = {});

  /// Returns the surface of a field, unfinished: export_model finishes it for files. Errors:
  /// `usage` if there is no relief or an option is out of range, `limit`, `interrupted`.
  Result<Model> model(const ModelOptions& options = {}, Field field = Field::relief,
                      const RunContext& context = {}) const;

  /// Returns height, normal and part of every pixel of the front view, `longest` px on the longer
  /// side. Errors: as model.
  Result<ReliefMaps> maps(int longest, const RunContext& context = {}) const;

  /// Makes a closed solid of the surface seen from the front, `drawing` on it. Errors: as model,
  /// and `usage` if size, thickness and margin leave no room.
  Result<Solid> solid(const SolidOptions& options = {}, const Drawing& drawing = {},
                      const RunContext& context = {}) const;

  /// Returns the annotations on the mesh of the approximate method. Error: `usage` if there is no
  /// relief.
  Result<MeshLines> lines() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace relievo
