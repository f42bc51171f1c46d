#include "mbs/solvers/joint_system.hpp"

#include <cmath>

namespace liesl {
namespace {

constexpr double kPoint = 1e-15;        // of mass times length^2: no inertia at all
constexpr double kPointInertia = 1e-8;  // what is put in its place in the iteration matrix
constexpr double kShared = 1e-10;  // of S, where penalised rows that repeat others share forces

/// Of increments, whose sum does not overflow; less work than allFinite, in every iteration.
bool finite(const Eigen::VectorXd& x) { return std::isfinite(x.sum()); }

/// 0, or for a rigid body without inertia about some axis a small one: what holds the body can act
/// on it through the inverse of its matrix then. The residual has none of it, so that the solution
/// is that of the point mass.
template <FrameGroup G>
double point_inertia(const Body<G>& body, double length) {
  if (body.nodes() > 1 || body.elements() > 0) return 0;
  typename G::Matrix M = body.mass().D[0];
  M.template topRightCorner<G::dim, G::rotation_dim>() /= length;
  M.template bottomLeftCorner<G::rotation_dim, G::dim>() /= length;
  const Eigen::VectorXd values = linalg::symmetric_eigenvalues(M);
  const double mass = body.total_mass();
  return values[0] > kPoint * mass ? 0 : kPointInertia * mass * length * length;
}

/// The values of a matrix of the same form, without allocation (an assignment of empty sparse
/// matrices allocates).
template <int N>
void take_values(BodyMatrix<N>& to, const BodyMatrix<N>& from) {
  if (to.is_sparse())
    to.sparse.coeffs() = from.sparse.coeffs();
  else if (to.is_dense())
    to.dense = from.dense;
  else
    static_cast<typename BodyMatrix<N>::Chain&>(to) = from;
}

}  // namespace

template <FrameGroup G>
JointSystem<G>::JointSystem(const Model<G>& model) : model_(model) {
  const size_t n = model.bodies.size();
  bodies_.resize(n);
  sides_.resize(n);
  factorizations_.assign(n, 0);
  for (size_t b = 0; b < n; ++b) {
    scratch_.push_back(model.bodies[b]->mass());
    point_inertia_.push_back(point_inertia(*model.bodies[b], model.length));
    const int columns = dim * static_cast<int>(model.coupled_nodes[b].size());
    bodies_[b].X.setZero(model.bodies[b]->size(), columns);
    bodies_[b].F.setZero(columns, columns);
    bodies_[b].joint_force.setZero(columns);
  }
  int rows = 0;
  for (size_t c = 0; c < model.couplings.size(); ++c) {
    const auto& coupling = model.couplings[c];
    const int index = static_cast<int>(c);
    if (coupling.a.body >= 0) sides_[coupling.a.body].push_back({index, 0, coupling.a.slot});
    if (coupling.b.body >= 0) sides_[coupling.b.body].push_back({index, dim, coupling.b.slot});
    first_.push_back(coupling.continued ? first_.back() : rows);
    if (!coupling.continued) rows += coupling.active;
  }
  S_.setZero(rows, rows);
  rhs_.setZero(rows);
  int nodes = 0;
  for (const auto& coupled : model.coupled_nodes) {
    first_node_.push_back(nodes);
    nodes += static_cast<int>(coupled.size());
  }
  X_.setZero(dim * nodes, dim * nodes);
  join_ = joined_ = X_;
  G_.setZero(X_.rows(), model.constraints());
  exact_S_.setZero(model.constraints(), model.constraints());
  exact_rhs_.setZero(model.constraints());
  z_.setZero(X_.rows());
  force_ = z_;
  solution_.setZero(rows);
  cholesky_.factor(Eigen::MatrixXd::Identity(rows, rows));  // takes the memory
  lu_.factor(Eigen::MatrixXd::Identity(rows, rows));
}

template <FrameGroup G>
bool JointSystem<G>::factor(TangentWeights w, double stiffness) {
  weights_ = w;
  exact_ = false;
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Body<G>& body = *model_.bodies[b];
    scratch_[b].set_sum(w.mass, body.mass(), stiffness * (1 + w.damping * body.damping()),
                        body.stiffness());
    if (!factor_body(static_cast<int>(b), scratch_[b])) return false;
  }
  return true;
}

template <FrameGroup G>
bool JointSystem<G>::factor_exact(const IterationMatrix<G>& S) {
  exact_ = true;
  for (size_t b = 0; b < bodies_.size(); ++b) {
    take_values(scratch_[b], S.body(static_cast<int>(b)));
    if (!factor_body(static_cast<int>(b), scratch_[b])) return false;
  }
  X_.setZero();
  for (size_t index = 0; index < model_.couplings.size(); ++index) {
    const auto& c = model_.couplings[index];
    const auto& Y = S.coupling(static_cast<int>(index));
    const PortOf<G>* ports[] = {&c.a, &c.b};
    for (int p = 0; p < 2; ++p)
      for (int q = 0; q < 2; ++q)
        if (ports[p]->body >= 0 && ports[q]->body >= 0)
          X_.template block<dim, dim>(place(*ports[p]), place(*ports[q])) +=
              Y.template block<dim, dim>(dim * p, dim * q);
  }
  join();
  rates_.resize(0, 0);
  if (!S.damped()) return true;
  rates_.setZero(model_.constraints(), X_.cols());
  for (size_t index = 0; index < model_.couplings.size(); ++index) {
    const auto& c = model_.couplings[index];
    const auto& rate = S.rate(static_cast<int>(index));
    auto rows = rates_.middleRows(c.first_constraint, c.constraints);
    if (c.a.body >= 0) rows.template middleCols<dim>(place(c.a)) += rate.template leftCols<dim>();
    if (c.b.body >= 0) rows.template middleCols<dim>(place(c.b)) += rate.template rightCols<dim>();
  }
  return true;
}

/// I + F X and (I + F X)^-1 F, all coupled nodes together.
template <FrameGroup G>
void JointSystem<G>::join() {
  const auto n = X_.rows();
  if (n == 0) return;
  join_.setIdentity();
  joined_.setZero();
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const int first = dim * first_node_[b], size = static_cast<int>(bodies_[b].F.rows());
    joined_.block(first, first, size, size) = bodies_[b].F;
    join_.middleRows(first, size).noalias() += bodies_[b].F * X_.middleRows(first, size);
  }
  join_lu_.factor(join_);
  for (int column = 0; column < n; ++column) {
    force_ = joined_.col(column);
    join_lu_.solve(force_, z_);
    joined_.col(column) = z_;
  }
}

template <FrameGroup G>
bool JointSystem<G>::factor_body(int body, BodyMatrix<dim>& A) {
  BodyFactor& f = bodies_[body];
  if (point_inertia_[body] > 0)
    A.D[0].diagonal().template tail<G::rotation_dim>().array() +=
        weights_.mass * point_inertia_[body];
  ++factorizations_[body];
  if (!f.lu.factor(A)) return false;
  const auto& nodes = model_.coupled_nodes[body];
  f.X.setZero();
  for (size_t slot = 0; slot < nodes.size(); ++slot)
    for (int i = 0; i < dim; ++i) {
      const int column = dim * static_cast<int>(slot) + i;
      f.X(dim * nodes[slot] + i, column) = 1;
      f.lu.solve(f.X.col(column).data(), model_.bodies[body]->size());
    }
  for (size_t slot = 0; slot < nodes.size(); ++slot)
    f.F.template middleRows<dim>(dim * static_cast<int>(slot)) =
        f.X.template middleRows<dim>(dim * nodes[slot]);
  return true;
}

template <FrameGroup G>
double JointSystem<G>::tangent_stiffness(const Equations<G>& eq, int coupling, int row) const {
  return eq.couplings[coupling].slope[row] +
         weights_.damping * model_.couplings[coupling].rows[row].law.damping;
}

/// S = sum over bodies of B E^T A^-1 E B^T, + compliance on the diagonal of springs and dampers.
template <FrameGroup G>
void JointSystem<G>::assemble(const Equations<G>& eq, bool compliant) {
  S_.setZero();
  using Compliance = Eigen::Matrix<double, dim, dim>;
  for (size_t b = 0; b < bodies_.size(); ++b)
    for (const Side& i : sides_[b]) {
      const int mi = model_.couplings[i.coupling].active;
      const auto Bi = eq.couplings[i.coupling].B.template middleCols<dim>(i.column).topRows(mi);
      for (const Side& j : sides_[b]) {
        if (first_[j.coupling] > first_[i.coupling]) continue;
        const int mj = model_.couplings[j.coupling].active;
        const auto Bj = eq.couplings[j.coupling].B.template middleCols<dim>(j.column).topRows(mj);
        const Compliance F = bodies_[b].F.template block<dim, dim>(dim * i.slot, dim * j.slot);
        for (int column = 0; column < mj; ++column) {
          const Eigen::Matrix<double, dim, 1> x = F.lazyProduct(Bj.row(column).transpose());
          S_.col(first_[j.coupling] + column).segment(first_[i.coupling], mi).noalias() +=
              Bi.lazyProduct(x);
        }
      }
    }
  for (size_t c = 0; c < model_.couplings.size(); ++c) {
    const auto& coupling = model_.couplings[c];
    for (int i = coupling.constraints; i < coupling.active; ++i) {
      const int row = first_[c] + i;
      const double stiffness = tangent_stiffness(eq, static_cast<int>(c), i);
      if (compliant && stiffness != 0) {
        S_(row, row) += 1 / stiffness;
      } else {
        S_.row(row).setZero();
        S_.col(row).setZero();
        S_(row, row) = 1;
      }
    }
  }
  if (model_.penalty.form != ConstraintForm::Multipliers) add_compliance(eq, compliant);
}

/// In a step that of the penalties; where positions, velocities or accelerations are made
/// consistent so little that a few solutions are exact, and rows that repeat others share what they
/// carry.
template <FrameGroup G>
void JointSystem<G>::add_compliance(const Equations<G>& eq, bool compliant) {
  const double little = kShared * S_.diagonal().maxCoeff();
  for (size_t k = 0; k < model_.couplings.size(); ++k) {
    const auto& c = model_.couplings[k];
    for (int i = 0; i < c.constraints && !c.continued; ++i)
      S_(first_[k] + i, first_[k] + i) +=
          compliant ? eq.compliance[c.first_constraint + i] / damped(eq) : little;
  }
}

template <FrameGroup G>
bool JointSystem<G>::solve(const Equations<G>& eq, Eigen::VectorXd& delta, Eigen::VectorXd& dlambda,
                           bool compliant) {
  delta = eq.r;
  for (size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].lu.solve(delta.data() + dim * model_.first_node(static_cast<int>(b)),
                        model_.bodies[b]->size());
  if (exact_) return solve_exact(eq, delta, dlambda);
  if (rhs_.size() > 0) {
    assemble(eq, compliant);
    for (size_t c = 0; c < model_.couplings.size(); ++c) {
      const auto& coupling = model_.couplings[c];
      auto rhs = rhs_.segment(first_[c], coupling.active);
      if (!coupling.continued) {
        rhs.setZero();
        rhs.head(coupling.constraints) =
            eq.phi.segment(coupling.first_constraint, coupling.constraints);
        if (compliant && eq.damping > 0) rhs.head(coupling.constraints) /= damped(eq);
      }
      const auto& B = eq.couplings[c].B;
      if (coupling.a.body >= 0)
        rhs -= B.topRows(coupling.active)
                   .template leftCols<dim>()
                   .lazyProduct(delta.template segment<dim>(dim * coupling.a.node));
      if (coupling.b.body >= 0)
        rhs -= B.topRows(coupling.active)
                   .template rightCols<dim>()
                   .lazyProduct(delta.template segment<dim>(dim * coupling.b.node));
      for (int i = coupling.constraints; i < coupling.active; ++i)
        if (!compliant || tangent_stiffness(eq, static_cast<int>(c), i) == 0) rhs[i] = 0;
    }
    if (cholesky_.factor(S_)) {
      cholesky_.solve_in_place(rhs_);
    } else {
      S_.template triangularView<Eigen::StrictlyUpper>() = S_.transpose();
      lu_.factor(S_);
      lu_.solve(rhs_, solution_);
      rhs_.swap(solution_);
    }
    if (!finite(rhs_)) return false;
    for (auto& body : bodies_) body.joint_force.setZero();
    for (size_t b = 0; b < bodies_.size(); ++b)
      for (const Side& i : sides_[b]) {
        const int active = model_.couplings[i.coupling].active;
        bodies_[b].joint_force.template segment<dim>(dim * i.slot) +=
            eq.couplings[i.coupling]
                .B.topRows(active)
                .template middleCols<dim>(i.column)
                .transpose()
                .lazyProduct(rhs_.segment(first_[i.coupling], active));
      }
    add_joint_forces(delta);
    for (size_t c = 0; c < model_.couplings.size(); ++c) {
      const auto& coupling = model_.couplings[c];
      dlambda.segment(coupling.first_constraint, coupling.constraints) =
          rhs_.segment(first_[c], coupling.constraints);
    }
  }
  delta = -delta;
  return finite(delta);
}

template <FrameGroup G>
void JointSystem<G>::add_joint_forces(Eigen::VectorXd& delta) const {
  for (size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].X.cols() > 0)
      delta.segment(dim * model_.first_node(static_cast<int>(b)), model_.bodies[b]->size())
          .noalias() += bodies_[b].X * bodies_[b].joint_force;
}

/// The rows of the constraints, B G and B w with G = (I + F X)^-1 F B^T, w = -(I + F X)^-1 E^T A^-1
/// r.
template <FrameGroup G>
void JointSystem<G>::assemble_exact(const Equations<G>& eq) {
  G_.setZero();
  exact_S_.setZero();
  exact_S_.diagonal() = eq.compliance;
  exact_rhs_ = eq.phi;
  each_side(eq, [this](int first, const auto& B, int node) {
    G_.middleCols(first, B.rows()).noalias() +=
        joined_.template middleCols<dim>(node).lazyProduct(B.transpose());
  });
  each_side(eq, [this](int first, const auto& B, int node) {
    exact_S_.middleRows(first, B.rows()).noalias() +=
        B.lazyProduct(G_.template middleRows<dim>(node));
    exact_rhs_.segment(first, B.rows()) += B.lazyProduct(z_.template segment<dim>(node));
  });
  if (rates_.size() == 0) return;
  exact_S_.noalias() += rates_ * G_;
  exact_rhs_.noalias() += rates_ * z_;
}

/// @pre delta = A^-1 r
template <FrameGroup G>
bool JointSystem<G>::solve_exact(const Equations<G>& eq, Eigen::VectorXd& delta,
                                 Eigen::VectorXd& dlambda) {
  for (size_t b = 0; b < bodies_.size(); ++b)
    for (size_t slot = 0; slot < model_.coupled_nodes[b].size(); ++slot)
      force_.template segment<dim>(dim * (first_node_[b] + static_cast<int>(slot))) =
          -delta.template segment<dim>(
              dim * (model_.first_node(static_cast<int>(b)) + model_.coupled_nodes[b][slot]));
  if (force_.size() > 0) join_lu_.solve(force_, z_);
  if (dlambda.size() > 0) {
    assemble_exact(eq);
    exact_lu_.factor(exact_S_);
    exact_lu_.solve(exact_rhs_, dlambda);
    z_.noalias() -= G_ * dlambda;
  }
  force_.noalias() = X_ * z_;
  each_side(eq, [&](int first, const auto& B, int node) {
    force_.template segment<dim>(node) +=
        B.transpose().lazyProduct(dlambda.segment(first, B.rows()));
  });
  for (size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].joint_force = force_.segment(dim * first_node_[b], bodies_[b].joint_force.size());
  add_joint_forces(delta);
  delta = -delta;
  return finite(delta) && finite(dlambda);
}

template class JointSystem<SE2>;
template class JointSystem<SE3>;

}  // namespace liesl
