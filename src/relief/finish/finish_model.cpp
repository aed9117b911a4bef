#include "relief/finish/finish_model.h"

#include <utility>

#include "relief/finish/dress_hidden.h"
#include "relief/finish/ink_rims.h"

namespace relievo::relief {
namespace {

/// Narrows the rims of whole parts: where parts end in walls, ink does not reach far down.
void narrow_rims(Model& model, const Drawing& drawing) {
  if (model.unfinished == Visibility::orbit) narrow_inked_rims(model, drawing);
}

}  // namespace

DrawnModel finish_model(Model model, Drawing drawing) {
  if (!model.unfinished) return {std::move(model), std::move(drawing)};
  narrow_rims(model, drawing);
  model.unfinished.reset();
  return dress_hidden(std::move(model), std::move(drawing));
}

DrawnModel finish_rims(Model model, Drawing drawing) {
  narrow_rims(model, drawing);
  extend_paint(model, drawing.rgba);
  return {std::move(model), std::move(drawing)};
}

}  // namespace relievo::relief
