#pragma once

#include <string>
#include <vector>

#include "understanding/scene/propose_scene.h"

namespace relievo::cli {

/// Formats the report of `relievo segment --report` (JSON): parts with how they were completed,
/// arrows of order with their confidence, joins, relations, tilts, times and warnings.
std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds);

}  // namespace relievo::cli
