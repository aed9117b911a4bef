#include "relief/pipeline/build_relief.h"

#include <utility>

#include "relief/pipeline/relief_session.h"

namespace relievo {

Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context) {
  ReliefSession session(ReliefSession::Use::one);
  if (Status status = session.update(scene, options, context); !status) return status.error();
  return std::move(session).take();
}

}  // namespace relievo
