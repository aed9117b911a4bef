#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace relievo {

/// What the tasks of a factor made of a right-hand side, in the order of elimination.
struct ForwardSweep {
  std::vector<uint64_t> version;  ///< of each task when it was solved
  Eigen::VectorXd b;
  Eigen::VectorXd y;      ///< L^-1 b on the columns of the tasks
  Eigen::MatrixXd above;  ///< what each task contributes to the columns above, one column each
};

}  // namespace relievo
