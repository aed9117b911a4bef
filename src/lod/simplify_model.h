#pragma once

#include <string>

#include "relievo/model.h"

namespace relievo {

/// Simplifies a model and its ink to about `triangles` triangles together. Edges are collapsed
/// where quadrics say that the surface changes least (libmeshoptimizer); vertices stay where they
/// are or vanish. Seams of the texture, borders of parts and outlines are collapsed along
/// themselves alone, for which more triangles may remain. A model that is small enough is returned
/// as it is. Precondition: the model is finished (see finish_model). O(n log n) for n triangles.
Model simplify_model(const Model& model, int triangles);

/// Unites all parts to one, called `id`: one mesh, one draw call. Precondition: as above.
Model unite_parts(Model model, const std::string& id);

}  // namespace relievo
