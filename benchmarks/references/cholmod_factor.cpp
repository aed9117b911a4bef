#include "benchmarks/references/cholmod_factor.h"

#include <cholmod.h>

namespace relievo::benchmarks {

struct CholmodFactor::Implementation {
  SparseMatrix matrix;
  cholmod_common common{};
  cholmod_sparse view{};
  cholmod_factor* factor = nullptr;
};

CholmodFactor::CholmodFactor(const SparseMatrix& lower, bool simplicial)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  self.matrix = lower;
  cholmod_start(&self.common);
  self.common.supernodal = simplicial ? CHOLMOD_SIMPLICIAL : CHOLMOD_AUTO;
  self.common.nmethods = 1;
  self.common.method[0].ordering = CHOLMOD_AMD;
  self.view.nrow = static_cast<size_t>(lower.rows());
  self.view.ncol = static_cast<size_t>(lower.cols());
  self.view.nzmax = static_cast<size_t>(lower.nonZeros());
  self.view.p = self.matrix.outerIndexPtr();
  self.view.i = self.matrix.innerIndexPtr();
  self.view.x = self.matrix.valuePtr();
  self.view.stype = -1;
  self.view.itype = CHOLMOD_INT;
  self.view.xtype = CHOLMOD_REAL;
  self.view.dtype = CHOLMOD_DOUBLE;
  self.view.sorted = 1;
  self.view.packed = 1;
  self.factor = cholmod_analyze(&self.view, &self.common);
}

CholmodFactor::~CholmodFactor() {
  cholmod_free_factor(&implementation_->factor, &implementation_->common);
  cholmod_finish(&implementation_->common);
}

bool CholmodFactor::factorise() {
  Implementation& self = *implementation_;
  cholmod_factorize(&self.view, self.factor, &self.common);
  return self.common.status == CHOLMOD_OK;
}

}  // namespace relievo::benchmarks
