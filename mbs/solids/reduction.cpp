#include "mbs/solids/reduction.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/linalg/symmetric_modes.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = SolidModel::Sparse;

VectorXd hertz(const VectorXd& lambda) {
  return lambda.cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi);
}

struct Basis {
  MatrixXd modes;
  VectorXd frequencies;
  bool converged = false;
};

/// [K_ii K_ib; K_bi K_bb] with b the ports: constraint modes -K_ii^-1 K_ib, modes of (K_ii, M_ii).
Basis craig_bampton(const SolidModel& model, const Sparse& K, const Sparse& M, int internal) {
  const int boundary = model.rigid_count() * model.ports(), inner = model.size() - boundary;
  if (boundary == 0) throw std::invalid_argument("Craig-Bampton modes need an interface");
  const Sparse K_ii = K.topLeftCorner(inner, inner), M_ii = M.topLeftCorner(inner, inner);
  const Sparse K_bi = K.bottomLeftCorner(boundary, inner);  // the lower triangle holds it
  Basis b;
  SparseCholesky factor;
  if (inner > 0 && !factor.factor(K_ii)) return b;
  SymmetricModes fixed{true, VectorXd(0), MatrixXd(inner, 0)};
  if (internal > 0) fixed = symmetric_modes(K_ii, M_ii, internal);
  if (!fixed.converged) return b;
  b.modes = MatrixXd::Zero(model.size(), boundary + internal);
  if (inner > 0) b.modes.topLeftCorner(inner, boundary) = -factor.solve(MatrixXd(K_bi.transpose()));
  b.modes.block(inner, 0, boundary, boundary).setIdentity();
  b.modes.topRightCorner(inner, internal) = fixed.phi;
  b.frequencies = hertz(fixed.lambda);
  b.converged = true;
  return b;
}

/// Orthonormal with respect to M in this order; directions that add nothing are dropped.
MatrixXd orthonormal(const MatrixXd& columns, const Sparse& M) {
  MatrixXd kept(columns.rows(), 0);
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    VectorXd c = columns.col(j);
    const double before = std::sqrt(c.dot(M.selfadjointView<Eigen::Lower>() * c));
    for (int pass = 0; pass < 2; ++pass)
      c -= kept * (kept.transpose() * (M.selfadjointView<Eigen::Lower>() * c)).eval();
    const double after = std::sqrt(c.dot(M.selfadjointView<Eigen::Lower>() * c));
    if (!(after > 1e-8 * before)) continue;
    kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
    kept.col(kept.cols() - 1) = c / after;
  }
  return kept;
}

Basis free_interface(const SolidModel& model, const VectorXd& v, int internal) {
  const Sparse K = model.stiffness(v), M = model.mass(v);
  const int rigid = model.rigid_count();
  const SymmetricModes free = symmetric_modes(K, M, internal, model.rigid_motions());
  Basis b;
  if (!free.converged) return b;
  MatrixXd unit = MatrixXd::Zero(model.size(), rigid * model.ports());
  unit.bottomRows(unit.cols()).setIdentity();
  SolidStatics statics(model, SolidSupport::relief(), {});
  statics.set_loads(unit);
  if (statics.solve(v) != SolidStatus::Solved) return b;
  MatrixXd all(model.size(), rigid + internal + unit.cols());
  all << model.rigid_motions(), free.phi, statics.q();
  b.modes = orthonormal(all, M);
  b.frequencies = hertz(free.lambda);
  b.converged = true;
  return b;
}

/// Elastic free-free modes of the mesh: eigenvalues and shapes (q).
SymmetricModes elastic_modes(const SolidModel& model, const VectorXd& v, int count) {
  return symmetric_modes(model.stiffness(v), model.mass(v), count, model.rigid_motions());
}

}  // namespace

ReducedSolid reduce(const SolidModel& model, const VectorXd& v, ReductionKind kind, int internal) {
  const Sparse K = model.stiffness(v), M = model.mass(v);
  const bool fixed = kind == ReductionKind::CraigBampton;
  Basis b = fixed ? craig_bampton(model, K, M, internal) : free_interface(model, v, internal);
  ReducedSolid r;
  r.converged = b.converged;
  if (!b.converged) return r;
  r.basis = std::move(b.modes);
  r.K = r.basis.transpose() * (K.selfadjointView<Eigen::Lower>() * r.basis);
  r.M = r.basis.transpose() * (M.selfadjointView<Eigen::Lower>() * r.basis);
  r.K = (0.5 * (r.K + r.K.transpose())).eval();
  r.M = (0.5 * (r.M + r.M.transpose())).eval();
  r.ports = fixed ? model.rigid_count() * model.ports() : 0;
  r.frequencies = std::move(b.frequencies);
  r.inertia = inertia_integrals(model, v, r.basis);
  return r;
}

namespace {

/// Scalar fields at a node: 1, x, y, z, then the components of phi_k.
/// @param u modes x freedoms  @param z 1, x, y, z stay zero for a `derivative`
void fields_at(const SolidMesh& mesh, int node, const MatrixXd& u, bool derivative,
               Eigen::Ref<VectorXd> z) {
  if (!derivative) {
    z[0] = 1;
    z.segment<3>(1) = mesh.nodes.col(node);
  }
  for (int a = 0; a < mesh.dim; ++a)
    for (Eigen::Index j = 0; j < u.rows(); ++j) z[4 + 3 * j + a] = u(j, mesh.dim * node + a);
}

/// At the nodes of cell e, by column.
void fields_in(const SolidMesh& mesh, int e, const MatrixXd& u, bool derivative, MatrixXd& Z) {
  for (int c = 0; c < mesh.nodes_per_cell(); ++c)
    fields_at(mesh, mesh.cells(c, e), u, derivative, Z.col(c));
}

/// From the integrals of products of two fields.
InertiaIntegrals by_name(const MatrixXd& G) {
  const Eigen::Index k = (G.rows() - 4) / 3;
  InertiaIntegrals I;
  I.mass = G(0, 0);
  I.first = G.block<3, 1>(1, 0);
  I.second = G.block<3, 3>(1, 1);
  I.mode.resize(3, k);
  for (Eigen::Index j = 0; j < k; ++j) {
    I.mode.col(j) = G.block<3, 1>(4 + 3 * j, 0);
    I.cross.push_back(G.block<3, 3>(1, 4 + 3 * j));
    for (Eigen::Index l = 0; l < k; ++l) I.product.push_back(G.block<3, 3>(4 + 3 * j, 4 + 3 * l));
  }
  return I;
}

}  // namespace

InertiaIntegrals inertia_integrals(const SolidModel& model, const VectorXd& v,
                                   const MatrixXd& modes) {
  const MatrixXd u = (model.T() * modes).transpose();
  const Eigen::Index fields = 4 + 3 * modes.cols();
  if (const Sparse* m = model.nodal_mass()) {
    MatrixXd Z = MatrixXd::Zero(fields, model.mesh().node_count());
    for (int i = 0; i < model.mesh().node_count(); ++i)
      fields_at(model.mesh(), i, u, false, Z.col(i));
    return by_name(Z * (*m * Z.transpose()).eval());
  }
  MatrixXd Z = MatrixXd::Zero(fields, model.mesh().nodes_per_cell()),
           G = MatrixXd::Zero(fields, fields);
  for (int e = 0; e < model.mesh().cell_count(); ++e) {
    if (v[e] == 0) continue;
    fields_in(model.mesh(), e, u, false, Z);
    G.noalias() += v[e] * Z * (model.cell(e).M * Z.transpose()).eval();
  }
  return by_name(G);
}

/// Product rule: dv Z M Z^T + v (dZ M Z^T + Z M dZ^T).
InertiaIntegrals inertia_integrals_derivative(const SolidModel& model, const VectorXd& v,
                                              const MatrixXd& modes, const VectorXd& dv,
                                              const MatrixXd& dmodes) {
  const MatrixXd u = (model.T() * modes).transpose(), du = (model.T() * dmodes).transpose();
  const Eigen::Index fields = 4 + 3 * modes.cols();
  MatrixXd Z = MatrixXd::Zero(fields, model.mesh().nodes_per_cell()), dZ = Z,
           half = MatrixXd::Zero(fields, fields);
  for (int e = 0; e < model.mesh().cell_count(); ++e) {
    if (v[e] == 0 && dv[e] == 0) continue;
    fields_in(model.mesh(), e, u, false, Z);
    fields_in(model.mesh(), e, du, true, dZ);
    half.noalias() += (v[e] * dZ + 0.5 * dv[e] * Z) * (model.cell(e).M * Z.transpose()).eval();
  }
  return by_name(half + half.transpose());
}

VectorXd free_frequencies(const SolidModel& model, const VectorXd& v, int count) {
  const SymmetricModes modes = elastic_modes(model, v, count);
  return modes.converged ? hertz(modes.lambda) : VectorXd();
}

VectorXd free_frequencies(const ReducedSolid& reduced, int rigid, int count) {
  const auto all = linalg::generalized_eigenvalues(reduced.K, reduced.M);
  if (!all) return {};
  return hertz(all->segment(rigid, std::min<Eigen::Index>(count, all->size() - rigid)));
}

FrequencyGradient free_frequency_gradient(const SolidModel& model, const VectorXd& v,
                                          const FractionGradient& dv, int count) {
  const SymmetricModes modes = elastic_modes(model, v, count);
  FrequencyGradient f;
  if (!modes.converged) return f;
  f.frequency = hertz(modes.lambda);
  f.gradient = MatrixXd::Zero(count, dv.cols());
  const MatrixXd u = model.T() * modes.phi;
  const int dim = model.mesh().dim, nodes = model.mesh().nodes_per_cell();
  MatrixXd phi(dim * nodes, count), component(nodes, count);
  for (int e = 0; e < dv.rows(); ++e) {
    FractionGradient::InnerIterator d(dv, e);
    if (!d) continue;
    for (int c = 0; c < nodes; ++c)
      phi.middleRows(dim * c, dim) = u.middleRows(model.freedom(e, c), dim);
    VectorXd change = model.law().slope(v[e]) *
                      phi.cwiseProduct(model.cell(e).K * phi).colwise().sum().transpose();
    for (int a = 0; a < dim; ++a) {
      for (int c = 0; c < nodes; ++c) component.row(c) = phi.row(dim * c + a);
      change -= modes.lambda.cwiseProduct(
          component.cwiseProduct(model.cell(e).M * component).colwise().sum().transpose());
    }
    for (; d; ++d) f.gradient.col(d.col()) += d.value() * change;
  }
  // df = d lambda / (8 pi^2 f)
  f.gradient = (8 * std::numbers::pi * std::numbers::pi * f.frequency).cwiseInverse().asDiagonal() *
               f.gradient;
  return f;
}

}  // namespace liesl
