#pragma once

#include <Eigen/Core>
#include <vector>

namespace relievo {

/// Accelerates a fixed-point iteration x = F(x) by Anderson's method (type II): the next point
/// combines the last ones so that their residuals F(x) - x, or what is measured of them by some
/// linear map, cancel as far as possible in the Euclidean norm (Walker and Ni 2011). Depth 0 is the
/// plain iteration.
class AndersonMixer {
 public:
  explicit AndersonMixer(int depth) : depth_(depth) {}

  /// The point to try after x, given F(x) and what is measured of its residual.
  /// O(#x depth + #residual depth^2).
  Eigen::VectorXd next(const Eigen::VectorXd& F_x, const Eigen::VectorXd& residual);

  /// Forgets the points seen so far.
  void restart();

 private:
  void remember(const Eigen::VectorXd& F_x, const Eigen::VectorXd& residual);

  int depth_;
  Eigen::VectorXd last_image_;
  Eigen::VectorXd last_residual_;
  std::vector<Eigen::VectorXd> image_steps_;
  std::vector<Eigen::VectorXd> residual_steps_;
};

}  // namespace relievo
