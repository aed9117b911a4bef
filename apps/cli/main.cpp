#include "apps/cli/program.h"

int main(int argc, char** argv) {
  return relievo::cli::run_program(argc, argv, relievo::cli::parse_arguments);
}
