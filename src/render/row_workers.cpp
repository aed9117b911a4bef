#include "render/row_workers.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace relievo {

Status run_rows(int rows, int threads, const RunContext& context,
                const std::function<void(int row)>& work) {
  if (threads <= 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::atomic<int> next{0};
  const auto take_rows = [&](bool reports) {
    for (int row = next++; row < rows && !context.cancelled(); row = next++) {
      work(row);
      if (reports) context.report("render", static_cast<double>(row + 1) / rows);
    }
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < std::min(threads, rows); ++i) helpers.emplace_back(take_rows, false);
  take_rows(true);
  for (std::thread& helper : helpers) helper.join();
  if (context.cancelled()) return interrupted_error();
  return Done{};
}

}  // namespace relievo
