#pragma once

#include <string>
#include <vector>

#include "understanding/scene/propose_scene.h"

namespace relievo::cli {

/// What `relievo segment --report` writes (JSON): parts with how they were completed, arrows of
/// order with their confidence, joins, relations, times and warnings.
std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds);

}  // namespace relievo::cli
