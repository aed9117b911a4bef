#include "relief/layers/loop_runs.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace relievo {
namespace {

/// Where a run of samples lies in the spliced loop: among the occurrences of its ends, the pair
/// whose length fits best.
LoopRun locate_run(const SplicedCurves& spliced, const CurveRun& run) {
  if (run.curve < 0) return {};
  const std::vector<int>& loop = spliced.loops[run.curve];
  const int first = spliced.image[run.curve][run.first];
  const int last = spliced.image[run.curve][run.last];
  const int n = static_cast<int>(loop.size());
  LoopRun best;
  double best_gap = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    if (loop[i] != first) continue;
    double length = 0;
    for (int edges = 1; edges < n; ++edges) {
      length += distance(spliced.points[loop[(i + edges - 1) % n]],
                         spliced.points[loop[(i + edges) % n]]);
      if (loop[(i + edges) % n] != last) continue;
      const double gap = std::abs(length - run.length);
      if (gap < best_gap) {
        best_gap = gap;
        best = {run.curve, i, edges, run.reversed};
      }
    }
  }
  return best;
}

}  // namespace

std::vector<LoopRun> locate_runs(const SplicedCurves& spliced, const std::vector<CurveRun>& runs) {
  std::vector<LoopRun> located;
  for (const CurveRun& run : runs) located.push_back(locate_run(spliced, run));
  return located;
}

Result<std::vector<JoinPath>> join_paths(const Scene& scene, const SplicedCurves& spliced,
                                         const std::vector<LoopRun>& runs) {
  std::vector<JoinPath> paths;
  for (size_t j = 0; j < scene.joins.size(); ++j) {
    const Join& join = scene.joins[j];
    JoinPath path;
    path.upper = join.upper;
    path.lower = join.lower;
    path.name = "joins[" + std::to_string(j) + "] (\"" + scene.parts[join.upper].id + "\" to \"" +
                scene.parts[join.lower].id + "\")";
    if (runs[j].loop < 0)
      return Error{ErrorCode::bad_input, "the outline collapses along the join; use a finer mesh",
                   path.name};
    path.loop = runs[j].loop;
    path.position = runs[j].position;
    const std::vector<int>& loop = spliced.loops[path.loop];
    for (int i = 0; i <= runs[j].edges; ++i)
      path.vertices.push_back(loop[(path.position + i) % loop.size()]);
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace relievo
