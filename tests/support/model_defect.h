#pragma once

#include <string>

#include "relievo/model.h"

namespace relievo::testing {

/// What every model must be, checked from its arrays alone: lengths that fit, finite numbers,
/// normals of unit length, corners that exist and differ, no face twice, no edge run through twice
/// the same way, every vertex used, parts that are disjoint runs. Empty where it is, else what it
/// is not.
std::string model_defect(const Model& model);

}  // namespace relievo::testing
