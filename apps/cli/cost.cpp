#include "apps/cli/cost.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "apps/cli/messages.h"

namespace relievo::cli {
namespace {

/// Memory of a build: at least, and in addition for each vertex by the approximate method, MB.
constexpr double base_mb = 90;
constexpr double vertex_mb = 0.002;

/// Time for each vertex of a large mesh by the approximate method on one slow processor, s.
constexpr double vertex_seconds = 1.3e-5;
constexpr double nonlinear_factor = 4;
constexpr double long_seconds = 10;

/// Reads the kB in the line of a /proc file that begins with `key`, as MB; `otherwise` if none
/// does.
double megabytes_in(const char* name, const std::string& key, double otherwise) {
  std::ifstream file(name);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1024;
  return otherwise;
}

}  // namespace

double free_mb() {
  const double free = megabytes_in("/proc/meminfo", "MemAvailable:", 4096);
  struct rlimit limit {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return free;
  const double allowed = static_cast<double>(limit.rlim_cur) / (1 << 20);
  return std::clamp(allowed - megabytes_in("/proc/self/status", "VmSize:", 0), 0.0, free);
}

double least_mb(double vertices) { return base_mb + vertex_mb * vertices; }

Status check_cost(const relief::ReliefOptions& options) {
  if (options.layers.edge_length > 0) return Done{};
  const double vertices = options.layers.vertex_budget;
  // This process has mapped most of the base already.
  const double needed = least_mb(vertices) - base_mb;
  const double free = free_mb();
  if (needed > free)
    return Error{ErrorCode::limit,
                 std::to_string(options.layers.vertex_budget) + " vertices need about " +
                     std::to_string(std::lround(needed)) + " MB of memory and " +
                     std::to_string(std::lround(free)) + " MB are free; use fewer --vertices",
                 ""};
  const double seconds =
      vertices * vertex_seconds * (options.method == Method::nonlinear ? nonlinear_factor : 1);
  if (seconds > long_seconds)
    print_note("this takes about " + std::to_string(std::lround(seconds)) + " s and " +
               std::to_string(std::lround(needed)) + " MB; use fewer --vertices to be quicker");
  return Done{};
}

}  // namespace relievo::cli
