#pragma once

namespace relievo::benchmarks {

/// Which sizes are run: the paper's and 5k to `largest` vertices.
struct Extent {
  int largest = 160000;
};

void register_stages(const Extent& extent);
void register_references(const Extent& extent);
void register_joint(const Extent& extent);
void register_edits();

}  // namespace relievo::benchmarks
