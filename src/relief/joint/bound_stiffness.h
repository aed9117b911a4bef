#pragma once

#include <Eigen/Core>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A node of B.
struct BoundMark {
  int part = -1;
  Point2 position;    ///< px
  double length = 0;  ///< of outline that it stands for, px

  int group() const { return part; }
};

/// How f on B resists a change, per lambda_shift, where nothing but equalities holds the heights,
/// corrected by what was measured: symmetric, a pure number on every mesh.
struct BoundStiffness {
  std::vector<BoundMark> marks;
  Eigen::MatrixXd K;  ///< #marks x #marks
};

/// That of a similar problem's B for what its marks can tell, long waves along B; for the others
/// that of the heights near B, `near`, #marks x #marks. Positive semi-definite where these are.
/// O(#B^2).
Eigen::MatrixXd with_known_waves(const BoundStiffness& known, const std::vector<BoundMark>& marks,
                                 const Eigen::MatrixXd& near);

}  // namespace relievo
