#pragma once

#include <cstdint>

#include "relievo/scene.h"

namespace relievo::testing {

/// A reproducible scene of the ugliest drawings: outlines that coincide, touch, cross themselves,
/// have specks, slivers and tangles; tiny and huge parts; many joins between the same parts,
/// touching, nested and crossing; relations and ranges that contradict each other. All but a few
/// are valid.
Scene ugly_scene(uint64_t seed);

}  // namespace relievo::testing
