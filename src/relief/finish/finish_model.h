#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// A model and the picture on it, which is empty if there is none.
struct DrawnModel {
  Model model;
  Drawing drawing;
};

/// Finishes a surface for files and pictures: of whole parts, inked rims are narrowed
/// (narrow_inked_rims); paint continues over rims and hidden faces get colours (dress_hidden).
/// Returns a model that is not `unfinished` as it is. Linear in pixels and triangles.
DrawnModel finish_model(Model model, Drawing drawing);

/// Finishes the rims alone, for a view that colours hidden faces itself (hidden_colours): texture
/// coordinates and the size of the drawing stay. Linear in pixels and triangles.
DrawnModel finish_rims(Model model, Drawing drawing);

}  // namespace relievo::relief
