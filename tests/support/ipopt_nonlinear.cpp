#include "support/ipopt_nonlinear.h"

#include <algorithm>
#include <cmath>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#pragma GCC diagnostic pop

namespace relievo::testing {
namespace {

using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;
using Triplet = Eigen::Triplet<double>;

constexpr double unlimited = 1e20;

/// Unknowns p, then g.
class NonlinearTnlp : public Ipopt::TNLP {
 public:
  NonlinearTnlp(const NonlinearProgram& program, const NonlinearPoint& start)
      : program_(program), start_(start), unknowns_(static_cast<Index>(program.node.size())) {
    inner_ = VectorXd::Zero(program.mass.size());
    for (int i = 0; i < unknowns_; ++i)
      if (!on_bound(program, i)) inner_[program.node[i]] = 1 / program.mass[program.node[i]];
    biharmonic_ = program.L * inner_.asDiagonal() * program.L;
    entries_ = hessian(start, 1, VectorXd::Ones(static_cast<Eigen::Index>(program.pairs.size())));
  }

  const std::optional<NonlinearPoint>& solution() const { return solution_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = unknowns_ + static_cast<Index>(program_.row.size());
    m = static_cast<Index>(program_.pairs.size());
    jacobian_entries = 0;
    for (const relief::DepthPair& pair : program_.pairs)
      jacobian_entries += 2 + (program_.row[pair.lower] >= 0) + (program_.row[pair.upper] >= 0);
    hessian_entries = static_cast<Index>(entries_.size());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* lower,
                       Number* upper) override {
    std::fill(x_lower, x_lower + unknowns_, 0.0);
    std::fill(x_lower + unknowns_, x_lower + n, -unlimited);
    std::fill(x_upper, x_upper + n, unlimited);
    std::fill(lower, lower + m, 0.0);
    for (Index k = 0; k < m; ++k) upper[k] = program_.pairs[k].equal ? 0.0 : unlimited;
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy(start_.p.begin(), start_.p.end(), x);
    std::copy(start_.g.begin(), start_.g.end(), x + unknowns_);
    return n == unknowns_ + start_.g.size();
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    value = energy(program_, point(x, n));
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* values) override {
    const NonlinearPoint slope = gradient(program_, point(x, n));
    std::copy(slope.p.begin(), slope.p.end(), values);
    std::copy(slope.g.begin(), slope.g.end(), values + unknowns_);
    return true;
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* values) override {
    const VectorXd h = heights(program_, point(x, n));
    for (Index k = 0; k < m; ++k)
      values[k] = h[program_.pairs[k].upper] - h[program_.pairs[k].lower];
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    Index entry = 0;
    const auto add = [&](Index pair, Index column, double value) {
      if (values != nullptr) {
        values[entry] = value;
      } else {
        rows[entry] = pair;
        columns[entry] = column;
      }
      ++entry;
    };
    const NonlinearPoint here = values != nullptr ? point(x, n) : start_;
    for (Index k = 0; k < m; ++k)
      for (const double side : {-1.0, 1.0}) {
        const int node = side < 0 ? program_.pairs[k].lower : program_.pairs[k].upper;
        add(k, unknowns_ + node, side);
        const int i = program_.row[node];
        if (i >= 0) add(k, i, side * root_slope(program_, here, i));
      }
    return true;
  }

  bool eval_h(Index n, const Number* x, bool, Number weight, Index m, const Number* lambda, bool,
              Index count, Index* rows, Index* columns, Number* values) override {
    if (values != nullptr) {
      const VectorXd multipliers = Eigen::Map<const VectorXd>(lambda, m);
      const std::vector<Triplet> now = hessian(point(x, n), weight, multipliers);
      for (Index k = 0; k < count; ++k) values[k] = now[k].value();
      return true;
    }
    for (Index k = 0; k < count; ++k) {
      rows[k] = entries_[k].row();
      columns[k] = entries_[k].col();
    }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn status, Index n, const Number* x, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    if (status == Ipopt::SUCCESS || status == Ipopt::STOP_AT_ACCEPTABLE_POINT)
      solution_ = point(x, n);
  }

 private:
  NonlinearPoint point(const Number* x, Index n) const {
    return {Eigen::Map<const VectorXd>(x, unknowns_).cwiseMax(0),
            Eigen::Map<const VectorXd>(x + unknowns_, n - unknowns_)};
  }

  /// du/dp.
  double chain(const NonlinearPoint& at, int i) const {
    return program_.sign[program_.node[i]] * (on_bound(program_, i) ? 2 * at.p[i] : 1);
  }

  /// The lower triangle of the Lagrangian's second derivatives, always in the same order.
  std::vector<Triplet> hessian(const NonlinearPoint& at, double weight,
                               const VectorXd& lambda) const {
    std::vector<Triplet> entries;
    const VectorXd u = squares(program_, at.p);
    const VectorXd force = program_.L * inner_.cwiseProduct(program_.L * u - program_.load);
    using Entry = Eigen::SparseMatrix<double>::InnerIterator;
    for (int j = 0; j < biharmonic_.outerSize(); ++j)
      for (Entry entry(biharmonic_, j); entry; ++entry) {
        const int a = program_.row[entry.row()];
        const int b = program_.row[j];
        if (a >= b && b >= 0)
          entries.emplace_back(a, b, 2 * weight * entry.value() * chain(at, a) * chain(at, b));
      }
    for (int i = 0; i < unknowns_; ++i) {
      const int n = program_.node[i];
      if (!on_bound(program_, i)) continue;
      entries.emplace_back(
          i, i,
          2 * weight *
              (2 * program_.sign[n] * force[n] + program_.lambda_bnd * program_.bound_mass[n]));
    }
    for (int j = 0; j < program_.A.outerSize(); ++j)
      for (Entry entry(program_.A, j); entry; ++entry)
        if (entry.row() >= j)
          entries.emplace_back(unknowns_ + static_cast<int>(entry.row()), unknowns_ + j,
                               2 * weight * program_.lambda_shift * entry.value());
    add_roots(at, lambda, entries);
    return entries;
  }

  void add_roots(const NonlinearPoint& at, const VectorXd& lambda,
                 std::vector<Triplet>& entries) const {
    for (size_t k = 0; k < program_.pairs.size(); ++k)
      for (const double side : {-1.0, 1.0}) {
        const int node = side < 0 ? program_.pairs[k].lower : program_.pairs[k].upper;
        const int i = program_.row[node];
        if (i < 0 || on_bound(program_, i)) continue;
        entries.emplace_back(i, i,
                             -side * lambda[static_cast<Eigen::Index>(k)] *
                                 root_slope(program_, at, i) / (2 * at.p[i]));
      }
  }

  const NonlinearProgram& program_;
  const NonlinearPoint& start_;
  Index unknowns_;
  VectorXd inner_;  ///< 1 / mass at free nodes
  Eigen::SparseMatrix<double> biharmonic_;
  std::vector<Triplet> entries_;
  std::optional<NonlinearPoint> solution_;
};

}  // namespace

std::optional<NonlinearPoint> solve_joint_by_ipopt(const NonlinearProgram& program,
                                                   const NonlinearPoint& start) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetIntegerValue("max_iter", 300);
  application->Options()->SetNumericValue("tol", 1e-10);
  application->Options()->SetNumericValue("bound_relax_factor", 0);
  if (application->Initialize() != Ipopt::Solve_Succeeded) return std::nullopt;
  Ipopt::SmartPtr<NonlinearTnlp> tnlp = new NonlinearTnlp(program, start);
  application->OptimizeTNLP(tnlp);
  return tnlp->solution();
}

}  // namespace relievo::testing
