// SPDX-License-Identifier: MIT
#include "sparse_cholesky.hpp"

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <new>
#include <string>

#include "stickslip/data/input_error.hpp"

namespace stickslip::analytic {
namespace {

// Silent: what fails is seen in what is returned.
struct Common : cholmod_common {
  Common() {
    cholmod_start(this);
    print = 0;
    final_ll = 1;
    quick_return_if_not_posdef = 1;
  }
  ~Common() { cholmod_finish(this); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
};

template <class Pointer>
Pointer allocated(Pointer pointer) {
  if (pointer == nullptr) throw std::bad_alloc();
  return pointer;
}

// A right side in memory of somebody else, for CHOLMOD to read or write.
cholmod_dense dense(const double* values, std::size_t rows, std::size_t columns) {
  cholmod_dense result{};
  result.nrow = result.d = rows;
  result.ncol = columns;
  result.nzmax = rows * columns;
  result.x = const_cast<double*>(values);
  result.xtype = CHOLMOD_REAL;
  result.dtype = CHOLMOD_DOUBLE;
  return result;
}

}  // namespace

struct SparseMatrix::Handle {
  Common common;
  cholmod_sparse* matrix{};
};

SparseMatrix::SparseMatrix(int rows, std::span<const data::MatrixEntry> entries)
    : handle_(std::make_unique<Handle>()) {
  const auto size = static_cast<std::size_t>(rows);
  const auto count = static_cast<std::size_t>(
      std::ranges::count_if(entries, [](const auto& entry) { return entry.row >= entry.column; }));
  cholmod_triplet* triplet =
      allocated(cholmod_allocate_triplet(size, size, count, -1, CHOLMOD_REAL, &handle_->common));
  for (const auto& [row, column, value] : entries) {
    if (row < column) continue;
    static_cast<int*>(triplet->i)[triplet->nnz] = row;
    static_cast<int*>(triplet->j)[triplet->nnz] = column;
    static_cast<double*>(triplet->x)[triplet->nnz++] = value;
  }
  handle_->matrix = cholmod_triplet_to_sparse(triplet, count, &handle_->common);
  cholmod_free_triplet(&triplet, &handle_->common);
  allocated(handle_->matrix);
}

SparseMatrix::~SparseMatrix() { cholmod_free_sparse(&handle_->matrix, &handle_->common); }

int SparseMatrix::rows() const { return static_cast<int>(handle_->matrix->nrow); }

std::vector<double> SparseMatrix::operator*(std::span<const double> x) const {
  std::vector<double> result(x.size());
  const std::size_t size = handle_->matrix->nrow;
  cholmod_dense from = dense(x.data(), size, x.size() / size),
                to = dense(result.data(), size, x.size() / size);
  double one[2] = {1.0, 0.0}, zero[2] = {};
  cholmod_sdmult(handle_->matrix, 0, one, zero, &from, &to, &handle_->common);
  return result;
}

struct SparseCholesky::Handle {
  Common common;
  cholmod_factor* factor{};

  std::vector<double> solve(int system, std::span<const double> b) {
    const cholmod_dense right = dense(b.data(), factor->n, b.size() / factor->n);
    cholmod_dense* solution =
        allocated(cholmod_solve(system, factor, const_cast<cholmod_dense*>(&right), &common));
    const auto* values = static_cast<const double*>(solution->x);
    std::vector<double> result(values, values + b.size());
    cholmod_free_dense(&solution, &common);
    return result;
  }
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix) : handle_(std::make_unique<Handle>()) {
  constexpr double most_bytes = 2e9;
  handle_->factor = allocated(cholmod_analyze(matrix.handle_->matrix, &handle_->common));
  const double bytes = handle_->common.lnz * sizeof(double);
  if (bytes > most_bytes) {
    cholmod_free_factor(&handle_->factor, &handle_->common);
    throw data::FieldError("model.stiffness_matrix",
                           "a matrix whose factors take " + data::shortest_text(bytes / 1e9) + " GB",
                           "one with factors of at most " + data::shortest_text(most_bytes / 1e9) + " GB");
  }
  cholmod_factorize(matrix.handle_->matrix, handle_->factor, &handle_->common);
}

SparseCholesky::~SparseCholesky() { cholmod_free_factor(&handle_->factor, &handle_->common); }

bool SparseCholesky::is_positive_definite() const { return handle_->factor->minor == handle_->factor->n; }

double SparseCholesky::least_pivot() const { return cholmod_rcond(handle_->factor, &handle_->common); }

std::vector<double> SparseCholesky::solve(std::span<const double> b) const {
  return handle_->solve(CHOLMOD_A, b);
}

std::vector<double> SparseCholesky::to_factor(std::span<const double> b) const {
  return handle_->solve(CHOLMOD_L, handle_->solve(CHOLMOD_P, b));
}

std::vector<double> SparseCholesky::from_factor(std::span<const double> y) const {
  return handle_->solve(CHOLMOD_Pt, handle_->solve(CHOLMOD_Lt, y));
}

}  // namespace stickslip::analytic
