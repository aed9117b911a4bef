#pragma once

#include <Eigen/Core>
#include <span>

#include "kernel/base/sparse_matrix.h"
#include "kernel/geometry/triangles.h"

namespace relievo {

/// Computes the stiffness matrix of -div grad for linear elements, #N x #N [P eq 7]:
///   L_ij = -(cot a + cot b) / 2, a and b the angles opposite to edge ij;  L_ii = -sum_j L_ij.
/// It is positive semi-definite, with constants in its kernel, and does not depend on the unit of
/// length. Both triangles and the whole diagonal are stored. O(N + F).
SparseMatrix stiffness_matrix(const FlatMesh& mesh);

/// Computes the lumped mass: a third of the area of the triangles around each node, #N, in squared
/// units of the positions. O(N + F).
Eigen::VectorXd lumped_mass(const FlatMesh& mesh);

/// Computes the load of a source that is constant on each triangle: the integral of density times
/// the hat function of each node, #N. `density` has #F entries. O(N + F).
Eigen::VectorXd load_vector(const FlatMesh& mesh, std::span<const double> density);

/// Computes the integral of field . grad(hat function) for each node, #N. It is L f where the field
/// is the gradient of f. `field` has #F entries, constant on each triangle. O(N + F).
Eigen::VectorXd divergence_load(const FlatMesh& mesh, std::span<const Point2> field);

/// Computes the lower triangle of T' A T, #M x #M, on the pattern that A and T imply, zeros
/// included. A is symmetric with both triangles stored (#N x #N); T is #N x #M with few entries a
/// row. O(sum over the entries A_ij of the products of the lengths of rows i and j of T).
SparseMatrix galerkin_lower(const SparseMatrix& A, const SparseMatrix& T);

}  // namespace relievo
