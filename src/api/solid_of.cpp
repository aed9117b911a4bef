#include "api/solid_of.h"

#include <utility>

#include "relief/surface/assemble_limbs.h"
#include "relief/surface/assemble_model.h"
#include "solid/make_solid.h"

namespace relievo {

Result<Solid> solid_of(const relief::Relief& relief, const Scene& scene, const Drawing& drawing,
                       const SolidOptions& options, const RunContext& context) {
  const relief::SolvedSurface surface{relief.layers, relief.inflation, relief.ordering, scene};
  auto sheet = relief::assemble_visible_sheet(surface, {}, context);
  if (!sheet) return sheet.error();
  const auto limbs = relief::assemble_limbs(surface, options.mirror, context);
  if (!limbs) return limbs.error();
  return make_solid(std::move(*sheet), *limbs, drawing, options);
}

}  // namespace relievo
