#pragma once

#include <Eigen/Core>
#include <span>

#include "kernel/base/sparse_matrix.h"
#include "kernel/geometry/triangles.h"

namespace relievo {

/// Stiffness matrix L of Delta = -div grad for linear elements: L_ij = -(cot a + cot b) / 2,
/// constants in its kernel, positive semi-definite; both triangles are stored,
/// and the whole diagonal. #N x #N, does not change with the unit of length. [P eq 7] O(N + F).
SparseMatrix stiffness_matrix(const FlatMesh& mesh);

/// Lumped mass: a third of the areas around each node, #N. O(N + F).
Eigen::VectorXd lumped_mass(const FlatMesh& mesh);

/// Right-hand side of a source that is constant on each triangle: the integral of density times
/// the hat function of each node, #N. `density` has #F entries. O(N + F).
Eigen::VectorXd load_vector(const FlatMesh& mesh, std::span<const double> density);

/// The integral of field . gradient of each node's hat function, #N: L f where the field is the
/// gradient of f. `field` is constant on each triangle and has #F entries. O(N + F).
Eigen::VectorXd divergence_load(const FlatMesh& mesh, std::span<const Point2> field);

/// The lower triangle of T' A T on the pattern that A and T imply, zeros included. A is symmetric
/// with both triangles stored (#N x #N), T is #N x #M with few entries a row.
/// O(sum over the entries A_ij of the products of the lengths of rows i and j of T).
SparseMatrix galerkin_lower(const SparseMatrix& A, const SparseMatrix& T);

}  // namespace relievo
