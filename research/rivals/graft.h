#pragma once

#include <cstdint>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::research {

/// The heights of a grafted surface.
struct Graft {
  std::vector<double> h;  ///< #N, px
  double residual = 0;  ///< maximum of |(L M^-1 L h)_n| over grafted nodes / the scale of its terms
};

/// Flags the nodes whose distance from a join, along the joined surface, is at most `width` times
/// its length. Distances are straight ones to the nearest node of the join that edges reach. Leaves
/// out nodes beside the rest of a bump's outline. #N flags. O(edges log N).
std::vector<uint8_t> band_around_joins(const relief::LayeredMesh& mesh, double width);

/// Replaces the heights of `grafted` nodes by the solution of L M^-1 L h = 0, where all other nodes
/// and those on outlines are fixed. It minimises bending inside the surface, and continues the
/// heights and slopes around it. Sýkora et al. 2014, section on grafting; the discretisation is our
/// reading. Errors: `internal` if the system is singular, `interrupted`.
Result<Graft> graft(const relief::LayeredMesh& mesh, const relief::Discretisation& discretisation,
                    const std::vector<double>& h, const std::vector<uint8_t>& grafted,
                    const RunContext& context = {});

}  // namespace relievo::research
