#pragma once

namespace relievo::benchmarks {

/// The sizes that are run: those of the paper, and 5k to `largest` vertices.
struct Extent {
  int largest = 160000;
};

void register_stages(const Extent& extent);
void register_references(const Extent& extent);
void register_joint(const Extent& extent);
void register_edits();

}  // namespace relievo::benchmarks
