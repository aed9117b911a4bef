#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "benchmarks/suites.h"
#include "kernel/base/workers.h"

// Usage: relievo_benchmark [--largest=VERTICES] [--threads=N] [options of Google Benchmark]

namespace {

/// Limits the libraries of the references to one thread. They read these variables once, at the
/// start.
void restart_with_one_thread(char** argv) {
  if (std::getenv("OMP_THREAD_LIMIT") != nullptr) return;
  setenv("OMP_THREAD_LIMIT", "1", 1);
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  execv("/proc/self/exe", argv);
}

/// Returns the value of the first argument and removes it if it is the option; else null.
const char* take_option(const char* option, int& argc, char**& argv) {
  if (argc < 2 || std::strncmp(argv[1], option, std::strlen(option)) != 0) return nullptr;
  const char* value = argv[1] + std::strlen(option);
  argv[1] = argv[0];
  ++argv;
  --argc;
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  restart_with_one_thread(argv);
  relievo::benchmarks::Extent extent;
  if (const char* largest = take_option("--largest=", argc, argv))
    extent.largest = std::atoi(largest);
  if (const char* threads = take_option("--threads=", argc, argv))
    relievo::set_worker_count(std::atoi(threads));
  relievo::benchmarks::register_stages(extent);
  relievo::benchmarks::register_references(extent);
  relievo::benchmarks::register_joint(extent);
  relievo::benchmarks::register_edits();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
