#pragma once

#include <Eigen/SparseCore>

namespace relievo {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

}  // namespace relievo
