#include "relief/session/build_relief.h"

#include <utility>

#include "relief/session/relief_session.h"

namespace relievo::relief {
namespace {

void drop_shift(Relief& relief) {
  Ordering& ordering = relief.ordering;
  for (size_t n = 0; n < ordering.h.size(); ++n) ordering.h[n] -= ordering.g[n];
  ordering.g.assign(ordering.g.size(), 0);
  ordering.grad_g.assign(ordering.grad_g.size(), {0, 0});
  ordering.creases = {};
}

/// Sets f to 1 px everywhere. A surface without inflation has no normals.
void drop_inflation(Relief& relief) {
  relief.inflation.u.assign(relief.inflation.u.size(), 1);
  relief.inflation.grad_u.assign(relief.inflation.grad_u.size(), {0, 0});
  relief.ordering.h = relief.ordering.g;
  for (double& h : relief.ordering.h) h += 1;
}

}  // namespace

Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context) {
  ReliefSession session(ReliefSession::Use::one);
  if (Status status = session.update(scene, options, context); !status) return status.error();
  return std::move(session).take();
}

void keep_field(Relief& relief, Field field) {
  if (field == Field::inflation) drop_shift(relief);
  if (field == Field::shift) drop_inflation(relief);
}

}  // namespace relievo::relief
