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

/// What came out of a build.
struct BuildReport {
  size_t vertices = 0;
  size_t faces = 0;
  int equalities = 0;        ///< vertices held at the height of another
  int inequalities = 0;      ///< pairs of vertices kept in order
  int active = 0;            ///< of these, those that touch
  double max_violation = 0;  ///< worst of all pairs, px
  double worst_overlap = 0;  ///< by how much a hidden face comes out in front at most, px
  double energy = 0;         ///< of the non-linear method, in scene units
  bool converged = true;     ///< likewise
  std::map<std::string, double> milliseconds;  ///< by stage
  std::vector<std::string> warnings;
};

/// Where the annotations of a scene lie on its mesh, as segments of edges in canvas px.
struct MeshLines {
  std::vector<float> joins;  ///< S x 4: x0 y0 x1 y1
  std::vector<float> equal;  ///< likewise: outlines whose height is that of the part behind
  std::vector<float> above;  ///< likewise: outlines held apart from another part, either side
  std::vector<float> below;  ///< likewise: those that are so against the order of parts
  std::vector<float> ramps;  ///< S x 6: x0 y0 x1 y1, then alpha [P eq 9] at both ends
};

/// The relief of a scene, which may change: a build goes on from the one before and computes only
/// what depends on what has changed. Not for several threads at once.
class Session {
 public:
  Session();
  ~Session();
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;

  /// Brings the relief up to date. Errors: `bad_input`, `contradiction` (both name the part, join
  /// or relation), `limit`, `usage` for options out of range, `interrupted`; then there is no
  /// relief until a build succeeds.
  Result<BuildReport> build(const Scene& scene, const BuildOptions& options = {},
                            const RunContext& context = {});

  /// Builds again from nothing where the last build went on from another one. The numbers are then
  /// those of a new session to the last bit, as before up to round-off. Errors: as build.
  Status make_exact(const RunContext& context = {});

  /// The surface, or another field's. Error: `usage` where there is no relief; `limit`.
  Result<Model> model(const ModelOptions& options = {}, Field field = Field::relief,
                      const RunContext& context = {}) const;

  /// Height, normal and part of every pixel of the front view, `longest` px on the longer side.
  /// Errors: likewise.
  Result<ReliefMaps> maps(int longest, const RunContext& context = {}) const;

  /// A closed solid of what the front shows, `drawing` on it. Errors: likewise; `usage` where an
  /// option is out of range, or where size, thickness and margin leave no room.
  Result<Solid> solid(const SolidOptions& options = {}, const Drawing& drawing = {},
                      const RunContext& context = {}) const;

  /// What holds where on the outlines of the approximate method. Error: likewise.
  Result<MeshLines> lines() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace relievo
