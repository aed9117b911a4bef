#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

namespace relievo::testing {

/// Minimise 1/2 x'Hx - b'x subject to lower <= C x <= upper. All of H is stored.
struct LinearlyConstrainedQp {
  Eigen::SparseMatrix<double> H;
  Eigen::VectorXd b;
  Eigen::SparseMatrix<double> C;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
};

/// An upper limit that Ipopt takes as absent.
constexpr double unlimited = 1e20;

/// Solves by Ipopt's interior point method; nothing if it does not converge.
std::optional<Eigen::VectorXd> solve_by_ipopt(const LinearlyConstrainedQp& qp);

}  // namespace relievo::testing
