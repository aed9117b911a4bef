#include "apps/cli/program.h"
#include "research/compare/compare_arguments.h"

int main(int argc, char** argv) {
  return relievo::cli::run_program(argc, argv, relievo::research::parse_compare);
}
