#include "kernel/solvers/anderson.h"

#include <Eigen/QR>

namespace relievo {

using Eigen::VectorXd;

VectorXd AndersonMixer::next(const VectorXd& F_x, const VectorXd& residual) {
  remember(F_x, residual);
  if (image_steps_.empty()) return F_x;
  const auto columns = static_cast<Eigen::Index>(image_steps_.size());
  Eigen::MatrixXd R(residual.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) R.col(k) = residual_steps_[k];
  const VectorXd weights = R.colPivHouseholderQr().solve(residual);
  VectorXd mixed = F_x;
  for (Eigen::Index k = 0; k < columns; ++k) mixed -= weights[k] * image_steps_[k];
  return mixed;
}

void AndersonMixer::remember(const VectorXd& F_x, const VectorXd& residual) {
  if (depth_ > 0 && last_image_.size() == F_x.size()) {
    image_steps_.push_back(F_x - last_image_);
    residual_steps_.push_back(residual - last_residual_);
    if (static_cast<int>(image_steps_.size()) > depth_) {
      image_steps_.erase(image_steps_.begin());
      residual_steps_.erase(residual_steps_.begin());
    }
  }
  last_image_ = F_x;
  last_residual_ = residual;
}

void AndersonMixer::restart() {
  image_steps_.clear();
  residual_steps_.clear();
  last_image_.resize(0);
  last_residual_.resize(0);
}

}  // namespace relievo
