#pragma once

#include <string>
#include <vector>

#include "understanding/scene/propose_scene.h"

namespace relievo::cli {

/// Formats the report of `relievo segment` as JSON: the parts and how they were completed, the
/// depth order and the joins with their confidence, relations, tilts, times and warnings.
std::string write_segment_report(const std::string& input, const understanding::Proposal& proposal,
                                 double milliseconds);

}  // namespace relievo::cli
