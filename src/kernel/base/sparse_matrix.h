#pragma once

#include <Eigen/SparseCore>

namespace relievo {

/// A sparse matrix in compressed columns.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

}  // namespace relievo
