#include "research/rivals/rival.h"

#include <algorithm>
#include <array>

#include "research/rivals/entem.h"
#include "research/rivals/ink_and_ray.h"
#include "research/rivals/stacked_parts.h"

namespace relievo::research {
namespace {

constexpr std::array<Rival, 6> all_rivals = {{
    {"relievo", "Dvorožňák et al. 2018, as changed here", reconstruct_ours},
    {"pillows", "none: layers inflated one by one", reconstruct_pillows},
    {"firm-ends", "Dvorožňák et al. 2020, Monster Mash", reconstruct_with_firm_ends},
    {"parabolic", "Yeh et al. 2017, Jayaraman et al. 2018", reconstruct_parabolic},
    {"ink-and-ray", "Sýkora et al. 2014", reconstruct_ink_and_ray},
    {"entem", "Entem et al. 2015", reconstruct_entem},
}};

}  // namespace

Result<relief::LayeredMesh> layer_for_rivals(const Scene& scene, relief::LayerOptions layers,
                                             const RunContext& context) {
  layers.attach = false;
  layers.glue = false;
  return relief::layer_parts(scene, layers, context);
}

std::span<const Rival> rivals() { return all_rivals; }

const Rival* find_rival(std::string_view name) {
  const auto found = std::find_if(all_rivals.begin(), all_rivals.end(),
                                  [&](const Rival& rival) { return name == rival.name; });
  return found == all_rivals.end() ? nullptr : &*found;
}

}  // namespace relievo::research
