#include "solid/compress_heights.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/gradient.h"
#include "kernel/operators/laplacian.h"

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Limits of the compression.
constexpr double steepest = 3;         ///< limit of slopes; small slopes hardly change
constexpr double highest_step = 0.3;   ///< limit of steps, of the wanted depth
constexpr double kept_by_large = 0.3;  ///< share of an even compression that large forms keep
constexpr int halvings = 7;            ///< of the range of sizes of forms that keep their slopes
constexpr double unused_mass = 1e-12;  ///< least diagonal stiffness, for points without triangles
constexpr double least_area = 1e-9;    ///< px^2, least area of triangles that have slopes

/// Returns the difference between the greatest and the least height of the triangles.
double depth_of(const Model& model, const VectorXd& z) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::array<int, 3>& t : model.triangles)
    for (const int v : t) {
      low = std::min(low, z[v]);
      high = std::max(high, z[v]);
    }
  return high - low;
}

/// Returns the triangles that have an area as seen from the front.
std::vector<std::array<int, 3>> broad_triangles(const Model& model) {
  std::vector<std::array<int, 3>> broad;
  for (const std::array<int, 3>& t : model.triangles) {
    const Point3 a = model.positions[t[0]];
    const Point3 ab = model.positions[t[1]] - a;
    const Point3 ac = model.positions[t[2]] - a;
    if (ab.x * ac.y - ab.y * ac.x > least_area) broad.push_back(t);
  }
  return broad;
}

/// Bounds a value smoothly by `limit`; small values hardly change.
double limited(double value, double limit) { return value / (1 + std::abs(value) / limit); }

class Compression {
 public:
  Compression(double share, const relief::VisibleSheet& sheet, const FlatMesh& mesh)
      : sheet_(sheet), share_(share) {
    const Model& model = sheet.model;
    heights_.resize(static_cast<Index>(model.positions.size()));
    for (Index v = 0; v < heights_.size(); ++v) heights_[v] = model.positions[v].z;
    target_ = share * depth_of(model, heights_);
    mass_ = lumped_mass(mesh);
    matrix_ = stiffness_matrix(mesh);
    std::vector<Point2> slopes = face_gradients(mesh, {heights_.data(), model.positions.size()});
    for (Point2& slope : slopes) slope = 1 / (1 + norm(slope) / steepest) * slope;
    load_ = divergence_load(mesh, slopes);
    add_steps();
  }

  /// Computes the heights: the largest forms that keep their slopes are as large as the depth
  /// allows.
  Result<VectorXd> run() {
    double low = std::log(1e-3);
    double high = std::log(10.0);
    const double size = std::sqrt(mass_.sum());
    VectorXd best = share_ * heights_;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      VectorXd z;
      if (!solve(size * std::exp(middle), z))
        return Error{ErrorCode::internal, "the depth cannot be compressed", "--height"};
      const bool fits = depth_of(sheet_.model, z) <= target_;
      (fits ? low : high) = middle;
      if (fits) best = std::move(z);
    }
    return best;
  }

 private:
  void add_steps() {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int a, int b) {
      if (a == b) return;
      const double step = limited(heights_[a] - heights_[b], highest_step * target_);
      entries.insert(entries.end(), {{a, a, 1}, {b, b, 1}, {a, b, -1}, {b, a, -1}});
      load_[a] += step;
      load_[b] -= step;
    };
    for (const relief::SheetStep& step : sheet_.steps) {
      add(step.first.front().vertex, step.second.front().vertex);
      add(step.first.back().vertex, step.second.back().vertex);
    }
    SparseMatrix steps(matrix_.rows(), matrix_.cols());
    steps.setFromTriplets(entries.begin(), entries.end());
    matrix_ = (matrix_ + steps).eval();
  }

  /// Minimises the integral of |grad z - slopes|^2 + (z - kept h)^2 / form^2, plus the squared
  /// misfit of the steps; kept = kept_by_large * share.
  bool solve(double form, VectorXd& z) {
    SparseMatrix screened = matrix_;
    VectorXd right = load_;
    for (Index v = 0; v < mass_.size(); ++v) {
      const double weight = std::max(mass_[v] / (form * form), unused_mass);
      screened.coeffRef(v, v) += weight;
      right[v] += weight * kept_by_large * share_ * heights_[v];
    }
    if (!analysed_ && !factor_.analyse(screened)) return false;
    analysed_ = true;
    if (!factor_.factorise(screened)) return false;
    z = factor_.solve(right);
    return true;
  }

  const relief::VisibleSheet& sheet_;
  double share_;
  double target_ = 0;  ///< px
  VectorXd heights_;
  VectorXd mass_;
  VectorXd load_;
  SparseMatrix matrix_;
  SparseCholesky factor_;
  bool analysed_ = false;
};

void set_heights(double share, const VectorXd& z, const FlatMesh& mesh,
                 relief::VisibleSheet& sheet) {
  Model& model = sheet.model;
  const size_t count = model.positions.size();
  const std::vector<Point2> slopes = node_gradients(mesh, {z.data(), count});
  for (size_t v = 0; v < count; ++v) {
    const double height = z[static_cast<Index>(v)];
    if (v < sheet.back.size())
      sheet.back[v].z = height - share * (model.positions[v].z - sheet.back[v].z);
    model.positions[v].z = height;
    model.normals[v] = normalized({-slopes[v].x, -slopes[v].y, 1});
  }
}

}  // namespace

Status compress_heights(double share, relief::VisibleSheet& sheet) {
  std::vector<Point2> places;
  for (const Point3 p : sheet.model.positions) places.push_back({p.x, p.y});
  const std::vector<std::array<int, 3>> triangles = broad_triangles(sheet.model);
  const FlatMesh mesh{places, triangles};
  const auto z = Compression(share, sheet, mesh).run();
  if (!z) return z.error();
  set_heights(share, *z, mesh, sheet);
  return Done{};
}

}  // namespace relievo
