#pragma once

#include "relief/model/drawn_model.h"

namespace relievo {

/// Gives what lies hidden behind other parts colours of its own, which the drawing does not have:
/// the picture is the drawing with patches (see hidden_patches) below it, texture coordinates are
/// those of the picture, vertices between what is seen and what is hidden are doubled, and nothing
/// counts as hidden any more. The same model where nothing is hidden. Paint goes on around the
/// rim (see extend_paint). Linear in pixels and triangles.
DrawnModel dress_hidden(Model model, Drawing drawing);

}  // namespace relievo
