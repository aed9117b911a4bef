#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relievo/result.h"

namespace relievo::relief {

/// Which way round two parts lie, seen against their order.
enum class Sense {
  usual,
  swapped,  ///< the part in front in the order lies behind
  mixed,    ///< one here, the other there
};

/// How the faces over each base triangle lie there, where relations "below" put parts behind
/// others against their order.
struct LocalOrder {
  std::vector<int> faces;  ///< #F, by triangle, back to front; empty: all in the order of parts
  std::vector<int> place;  ///< #F, of each face in `faces`; or empty

  bool is_usual() const { return faces.empty(); }
};

/// The base vertices along a run, in its direction.
std::vector<int> run_vertices(const Loops& loops, const LoopRun& run);

/// Where two parts of a relation "below" overlap, every triangle takes the sense of what lies
/// nearest to it of the upper part's outline, by steps from triangle to triangle: behind at the
/// relation's ranges, in front elsewhere. So what is in front changes halfway between a range and
/// the rest, and an overlap whose outline is all "below" lies behind as a whole. `runs` has one for
/// each relation of the scene, loop -1 where it has none. Fails with contradiction, naming both
/// relations, where ranges put a part behind another and in front of it, or of one that covers
/// that, at more than a common end. O(T) for each pair of parts that are related so.
Result<LocalOrder> find_local_order(const SheetMesh& mesh, const Scene& scene,
                                    const std::vector<LoopRun>& runs);

/// How two parts lie around a base vertex; usual where no triangle there is covered by both.
Sense sense_at(const SheetMesh& mesh, const LocalOrder& order, int vertex, int lower, int upper);

}  // namespace relievo::relief
