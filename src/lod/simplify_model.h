#pragma once

#include "relievo/model.h"

namespace relievo {

/// The model with at most so many triangles, as far as that goes: edges are collapsed where
/// quadrics say that the surface changes least (libmeshoptimizer). Vertices stay where they are or
/// vanish; seams of the texture, borders of parts and outlines are collapsed along themselves
/// alone, and what needs more triangles for them keeps more. Precondition: nothing of it is hidden
/// (see dress_hidden). The same model where it is small enough. O(n log n) for n triangles.
Model simplify_model(const Model& model, int triangles);

/// All parts as one, named by the first: one mesh, one draw call. Precondition: as above.
Model unite_parts(Model model);

}  // namespace relievo
