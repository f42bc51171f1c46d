#include "mbs/solvers/plane_stability.hpp"

#include <cmath>

#include "mbs/linalg/constrained_modes.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/inertia.hpp"

namespace liesl {
namespace {

constexpr double kBalanced = 1e-3;     // of the forces: what multipliers may leave
constexpr double kIndependent = 1e-7;  // what is left of a unit row that others span

/// Rows of B that are independent of those before them.
std::vector<int> independent_rows(const Eigen::MatrixXd& B) {
  std::vector<int> rows;
  std::vector<Eigen::VectorXd> basis;
  for (int i = 0; i < B.rows(); ++i) {
    Eigen::VectorXd row = B.row(i);
    const double norm = row.norm();
    if (norm < kIndependent) continue;
    row /= norm;
    for (int pass = 0; pass < 2; ++pass)
      for (const Eigen::VectorXd& q : basis) row -= q.dot(row) * q;
    if (row.norm() < kIndependent) continue;
    basis.push_back(row.normalized());
    rows.push_back(i);
  }
  return rows;
}

/// Gives the rows of a coupling in space the values that the same ones have in the plane.
void take_rows(const Coupling<SE2>& from, const Eigen::VectorXd& values, const Coupling<SE3>& to,
               Eigen::VectorXd& out) {
  for (std::size_t i = 0; i < to.rows.size(); ++i)
    for (std::size_t k = 0; k < from.rows.size(); ++k) {
      const CouplingRow<SE2>& a = from.rows[k];
      const CouplingRow<SE3>& b = to.rows[i];
      if (a.row.kind() == b.row.kind() && a.coordinate == b.coordinate && a.force == b.force)
        out[to.first_row + static_cast<int>(i)] = values[from.first_row + static_cast<int>(k)];
    }
}

/// The mechanism as it would be in space: chains of segments are beams there.
Mechanism in_space(Mechanism m) {
  if (m.formalism == Formalism::Segments) m.formalism = Formalism::SE3;
  for (BodySpec& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind); beam && beam->as == BeamModel::Segments)
      beam->as = BeamModel::AsFormalism;
  return m;
}

}  // namespace

PlaneStability::PlaneStability(const Mechanism& mechanism, const Model<SE2>& model)
    : plane_(model),
      view_(mechanism, model),
      model_(Model<SE3>::build(in_space(mechanism), {})),
      s_(model_.initial_state()),
      equations_(model_),
      matrix_(model_) {
  for (std::size_t b = 0; b < plane_.bodies.size(); ++b) {
    const int nodes = plane_.bodies[b]->nodes();
    frames_only_ = frames_only_ && nodes == model_.bodies[b]->nodes();
    for (int k = 0; frames_only_ && k < nodes; ++k)
      frames_only_ = plane_.bodies[b]->kind(k) == NodeKind::Frame;
  }
  if (frames_only_) out_of_plane_ = out_of_plane();
}

bool PlaneStability::take(const State<SE2>& s) {
  s_.t = s.t;
  for (std::size_t b = 0; b < plane_.bodies.size(); ++b) {
    const int body = static_cast<int>(b), first = plane_.first_node(body);
    for (int k = 0; k < plane_.bodies[b]->nodes(); ++k) {
      const int node = first + k;
      s_.H[static_cast<std::size_t>(node)] = view_.node(s.H.data(), body, k);
      s_.v.segment<6>(6 * node) = view_.local(s.v.segment<3>(3 * node), body, k);
      s_.vdot.segment<6>(6 * node) = view_.local(s.vdot.segment<3>(3 * node), body, k);
    }
  }
  for (const Coupling<SE3>& to : model_.couplings)
    for (const Coupling<SE2>& from : plane_.couplings)
      if (from.name == to.name && from.continued == to.continued)
        take_rows(from, s.rows, to, s_.rows);
  equations_.observe(s_, s_.rows, s_.rows);
  return find_multipliers();
}

/// Least squares of r + B^T lambda. @returns whether they balance the forces
bool PlaneStability::find_multipliers() {
  s_.lambda.setZero();
  equations_.evaluate(s_, s_.rows, {s_.t, 1});
  const int n = model_.size(), m = model_.constraints();
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(m, n);
  for (std::size_t i = 0; i < model_.couplings.size(); ++i) {
    const auto& c = model_.couplings[i];
    const auto& rows = equations_.couplings[i].B;
    for (int k = 0; k < c.constraints; ++k) {
      auto row = B.row(c.first_constraint + k);
      if (c.a.body >= 0) row.segment<6>(6 * c.a.node) += rows.row(k).head<6>();
      if (c.b.body >= 0) row.segment<6>(6 * c.b.node) += rows.row(k).tail<6>();
    }
  }
  const Eigen::VectorXd r = equations_.r;
  if (m > 0) s_.lambda = -linalg::LDLT(Eigen::MatrixXd(B * B.transpose())).solve(B * r);
  const Eigen::VectorXd left = r + B.transpose() * s_.lambda;
  return left.allFinite() && left.norm() <= kBalanced * equations_.scale() + equations_.round_off();
}

void PlaneStability::take_rates() {
  const auto n = static_cast<std::size_t>(model_.nodes());
  rates_.v.resize(n);
  rates_.vdot.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    rates_.v[k] = SE3::ad(s_.v.segment<6>(at));
    rates_.vdot[k] = SE3::ad(s_.vdot.segment<6>(at));
  }
}

Eigen::SparseMatrix<double> PlaneStability::out_of_plane() const {
  Eigen::SparseMatrix<double> N(model_.size(), model_.size() / 2);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t b = 0; b < plane_.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    for (int k = 0; k < plane_.bodies[b]->nodes(); ++k) {
      const int node = plane_.first_node(body) + k;
      const Vec3 directions[] = {view_.local(SE2::Tangent(0, 0, 1), body, k).tail<3>(),
                                 view_.local(SE2::Tangent(1, 0, 0), body, k).head<3>(),
                                 view_.local(SE2::Tangent(0, 1, 0), body, k).head<3>()};
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          entries.emplace_back(6 * node + (j == 0 ? 0 : 3) + i, 3 * node + j, directions[j][i]);
    }
  }
  N.setFromTriplets(entries.begin(), entries.end());
  return N;
}

std::optional<double> PlaneStability::growth(const State<SE2>& s) {
  if (!frames_only_ || !take(s)) return {};
  take_rates();
  matrix_.take_own_stress(equations_);
  const Eigen::SparseMatrix<double> A = matrix_.assemble(equations_, s_, {s_.t, 1}, &rates_);
  const int n = model_.size(), m = model_.constraints();
  const Eigen::SparseMatrix<double>& N = out_of_plane_;
  const Eigen::SparseMatrix<double> K = N.transpose() * A.topLeftCorner(n, n) * N,
                                    B = A.bottomLeftCorner(m, n) * N;
  const auto rows = independent_rows(Eigen::MatrixXd(B));
  const auto free = static_cast<int>(N.cols()), held = static_cast<int>(rows.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < K.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it; ++it)
      entries.emplace_back(it.row(), it.col(), it.value());
  const Eigen::SparseMatrix<double> Bt = B.transpose();
  for (int i = 0; i < held; ++i)
    for (Eigen::SparseMatrix<double>::InnerIterator it(Bt, rows[static_cast<std::size_t>(i)]); it;
         ++it) {
      entries.emplace_back(free + i, it.row(), it.value());
      entries.emplace_back(it.row(), free + i, it.value());
    }
  Eigen::SparseMatrix<double> saddle(free + held, free + held);
  saddle.setFromTriplets(entries.begin(), entries.end());
  if (negative_on_null_space(saddle, free) == 0) return 0;  // the signs take less than the modes
  const Eigen::SparseMatrix<double> M = N.transpose() * matrix_.mass() * N;
  const ConstrainedModes modes = constrained_modes(saddle, M, 1);
  if (!modes.converged) return {};
  if (modes.lambda.size() == 0 || modes.lambda[0] >= 0) return 0;
  return std::sqrt(-modes.lambda[0]);
}

}  // namespace liesl
