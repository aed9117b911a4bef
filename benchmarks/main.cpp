#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "benchmarks/suites.h"

// Usage: relievo_benchmark [--largest=VERTICES] [options of Google Benchmark]

namespace {

/// The references run on one thread, as they are compared; their libraries read this once, at the
/// start.
void restart_with_one_thread(char** argv) {
  if (std::getenv("OMP_THREAD_LIMIT") != nullptr) return;
  setenv("OMP_THREAD_LIMIT", "1", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  execv("/proc/self/exe", argv);
}

}  // namespace

int main(int argc, char** argv) {
  restart_with_one_thread(argv);
  relievo::benchmarks::Extent extent;
  const char* largest = "--largest=";
  if (argc > 1 && std::strncmp(argv[1], largest, std::strlen(largest)) == 0) {
    extent.largest = std::atoi(argv[1] + std::strlen(largest));
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  relievo::benchmarks::register_stages(extent);
  relievo::benchmarks::register_references(extent);
  relievo::benchmarks::register_edits();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
