#include "support/ipopt_qp.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#pragma GCC diagnostic pop

namespace relievo::testing {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using Vector = Eigen::Map<const Eigen::VectorXd>;

/// The quadratic program in Ipopt's terms.
class QpProgram : public Ipopt::TNLP {
 public:
  explicit QpProgram(const LinearlyConstrainedQp& qp) : qp_(qp) {}

  const std::optional<Eigen::VectorXd>& solution() const { return solution_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(qp_.b.size());
    m = static_cast<Index>(qp_.C.rows());
    jacobian_entries = static_cast<Index>(qp_.C.nonZeros());
    hessian_entries = 0;
    for (int j = 0; j < qp_.H.outerSize(); ++j)
      for (Entry entry(qp_.H, j); entry; ++entry) hessian_entries += entry.row() >= j;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* lower,
                       Number* upper) override {
    std::fill(x_lower, x_lower + n, -unlimited);
    std::fill(x_upper, x_upper + n, unlimited);
    for (Index i = 0; i < m; ++i) {
      lower[i] = qp_.lower[i];
      upper[i] = qp_.upper[i];
    }
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::fill(x, x + n, 0.0);
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    const Vector point(x, n);
    value = 0.5 * point.dot(qp_.H * point) - qp_.b.dot(point);
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    Eigen::Map<Eigen::VectorXd>(gradient, n) = qp_.H * Vector(x, n) - qp_.b;
    return true;
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* values) override {
    Eigen::Map<Eigen::VectorXd>(values, m) = qp_.C * Vector(x, n);
    return true;
  }

  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    Index k = 0;
    for (int j = 0; j < qp_.C.outerSize(); ++j)
      for (Entry entry(qp_.C, j); entry; ++entry, ++k) {
        if (values != nullptr) {
          values[k] = entry.value();
        } else {
          rows[k] = static_cast<Index>(entry.row());
          columns[k] = j;
        }
      }
    return true;
  }

  bool eval_h(Index, const Number*, bool, Number weight, Index, const Number*, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    Index k = 0;
    for (int j = 0; j < qp_.H.outerSize(); ++j)
      for (Entry entry(qp_.H, j); entry; ++entry) {
        if (entry.row() < j) continue;
        if (values != nullptr) {
          values[k] = weight * entry.value();
        } else {
          rows[k] = static_cast<Index>(entry.row());
          columns[k] = j;
        }
        ++k;
      }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn status, Index n, const Number* x, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    if (status == Ipopt::SUCCESS || status == Ipopt::STOP_AT_ACCEPTABLE_POINT)
      solution_ = Vector(x, n);
  }

 private:
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const LinearlyConstrainedQp& qp_;
  std::optional<Eigen::VectorXd> solution_;
};

}  // namespace

std::optional<Eigen::VectorXd> solve_by_ipopt(const LinearlyConstrainedQp& qp) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetStringValue("hessian_constant", "yes");
  application->Options()->SetNumericValue("tol", 1e-12);
  application->Options()->SetNumericValue("bound_relax_factor", 0);
  if (application->Initialize() != Ipopt::Solve_Succeeded) return std::nullopt;
  Ipopt::SmartPtr<QpProgram> program = new QpProgram(qp);
  application->OptimizeTNLP(program);
  return program->solution();
}

}  // namespace relievo::testing
