#include "relief/pipeline/build_relief.h"

#include <chrono>

namespace relievo {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    last_ = now;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context) {
  if (Status status = validate(scene); !status) return status.error();
  Relief relief;
  Stopwatch watch;
  auto layers = layer_parts(scene, options.layers, context);
  if (!layers) return layers.error();
  relief.layers = std::move(*layers);
  relief.times.push_back({"mesh", watch.lap()});
  auto inflation = inflate(relief.layers, scene, options.inflation, context);
  if (!inflation) return inflation.error();
  relief.inflation = std::move(*inflation);
  relief.times.push_back({"inflate", watch.lap()});
  auto ordering = order_depth(relief.layers, relief.inflation, scene, options.ordering, context);
  if (!ordering) return ordering.error();
  relief.ordering = std::move(*ordering);
  relief.times.push_back({"order", watch.lap()});
  return relief;
}

}  // namespace relievo
