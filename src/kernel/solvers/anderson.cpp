#include "kernel/solvers/anderson.h"

#include <Eigen/QR>

namespace relievo {

using Eigen::VectorXd;

VectorXd AndersonMixer::next(const VectorXd& x, const VectorXd& F_x) {
  const VectorXd residual = F_x - x;
  remember(x, residual);
  if (x_steps_.empty()) return F_x;
  const auto columns = static_cast<Eigen::Index>(x_steps_.size());
  Eigen::MatrixXd R(residual.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) R.col(k) = residual_steps_[k];
  const VectorXd weights = R.colPivHouseholderQr().solve(residual);
  VectorXd mixed = F_x;
  for (Eigen::Index k = 0; k < columns; ++k)
    mixed -= weights[k] * (x_steps_[k] + residual_steps_[k]);
  return mixed;
}

void AndersonMixer::remember(const VectorXd& x, const VectorXd& residual) {
  if (depth_ > 0 && last_x_.size() == x.size()) {
    x_steps_.push_back(x - last_x_);
    residual_steps_.push_back(residual - last_residual_);
    if (static_cast<int>(x_steps_.size()) > depth_) {
      x_steps_.erase(x_steps_.begin());
      residual_steps_.erase(residual_steps_.begin());
    }
  }
  last_x_ = x;
  last_residual_ = residual;
}

void AndersonMixer::restart() {
  x_steps_.clear();
  residual_steps_.clear();
  last_x_.resize(0);
  last_residual_.resize(0);
}

}  // namespace relievo
