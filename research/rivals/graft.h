#pragma once

#include <cstdint>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::research {

/// A surface whose heights were changed where it was grafted.
struct Graft {
  std::vector<double> h;  ///< #N, px
  double residual = 0;    ///< most |(L M^-1 L h)_n| over grafted nodes / the scale of its terms
};

/// Nodes no farther along the joined surface from a join than `width` times its length: straight
/// distances to the nearest of its nodes, reached over edges; but for what is beside the rest of a
/// bump's outline. #N flags. O(edges log N).
std::vector<uint8_t> band_around_joins(const relief::LayeredMesh& mesh, double width);

/// Replaces the heights of `grafted` nodes by the solution of L M^-1 L h = 0 with all other nodes,
/// and those on outlines, held: the least bending of what is inside the surface, which continues
/// the heights and slopes around it. Sýkora et al. 2014, section on grafting; the discretisation is
/// our reading. Fails with internal where the system is singular, or interrupted.
Result<Graft> graft(const relief::LayeredMesh& mesh, const relief::Discretisation& discretisation,
                    const std::vector<double>& h, const std::vector<uint8_t>& grafted,
                    const RunContext& context = {});

}  // namespace relievo::research
