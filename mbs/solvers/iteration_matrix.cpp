#include "mbs/solvers/iteration_matrix.hpp"

#include <algorithm>

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/linalg/block_product.hpp"

namespace liesl {
namespace {

/// D_h of -[R^T f; R^T m]: what a dead load turns by in the frame that it acts on.
template <FrameGroup G>
typename G::Matrix dead_load_tangent(const G& H, const typename G::Tangent& wrench) {
  constexpr int sd = G::space_dim;
  typename G::Matrix D = weight_tangent<G>(H, wrench.template head<sd>());
  if constexpr (G::rotation_dim == 3)
    D.template bottomRightCorner<3, 3>() =
        weight_tangent<G>(H, wrench.template tail<3>()).template topRightCorner<3, 3>();
  return D;
}

}  // namespace

template <FrameGroup G>
IterationMatrix<G>::IterationMatrix(const Model<G>& model)
    : model_(model),
      A_(empty()),
      C_(empty()),
      M_(empty()),
      couplings_(model.couplings.size()),
      rates_(model.couplings.size()),
      assembly_(model.size() + model.constraints()),
      mass_(model.size()) {
  still_.setZero(model.size());
  for (size_t b = 0; b < model.bodies.size(); ++b)
    for (int k = 0; k < model.bodies[b]->nodes(); ++k)
      if (model.bodies[b]->kind(k) == NodeKind::Follower)
        followers_.push_back(model.first_node(static_cast<int>(b)) + k);
  for (const auto& body : model.bodies)
    prestress_.section.emplace_back(body->stresses(), G::Tangent::Zero());
  for (const auto& c : model.couplings) prestress_.force.push_back(Eigen::VectorXd::Zero(c.acting));
}

/// Matrices in the forms of the bodies.
template <FrameGroup G>
auto IterationMatrix<G>::empty() const -> BodyMatrices {
  BodyMatrices out;
  for (const auto& body : model_.bodies) {
    out.emplace_back(body->nodes());
    out.back().set_form(body->stiffness());
  }
  return out;
}

template <FrameGroup G>
void IterationMatrix<G>::take_prestress(const Equations<G>& eq, const State<G>& s) {
  for (auto& stress : prestress_.section)  // of an iteration that may have diverged
    std::fill(stress.begin(), stress.end(), G::Tangent::Zero());
  extrapolate_prestress(eq, s, still_);
}

template <FrameGroup G>
void IterationMatrix<G>::take_own_stress(const Equations<G>& eq) {
  own_stress_ = true;
  for (size_t c = 0; c < eq.couplings.size(); ++c) prestress_.force[c] = eq.couplings[c].force;
}

template <FrameGroup G>
void IterationMatrix<G>::extrapolate_prestress(const Equations<G>& eq, const State<G>& s,
                                               const Eigen::VectorXd& delta) {
  own_stress_ = false;
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    const int index = static_cast<int>(b);
    model_.bodies[b]->extrapolate_stress(model_.body_state(s, index),
                                         delta.data() + dim * model_.first_node(index),
                                         prestress_.section[b].data());
  }
  for (size_t c = 0; c < model_.couplings.size(); ++c) {
    const auto& coupling = model_.couplings[c];
    const auto& data = eq.couplings[c];
    for (int i = coupling.constraints; i < coupling.acting; ++i) {
      double stretch = 0;
      const auto B = data.B.row(i);
      if (coupling.a.body >= 0)
        stretch += B.template head<dim>().dot(delta.template segment<dim>(dim * coupling.a.node));
      if (coupling.b.body >= 0)
        stretch += B.template tail<dim>().dot(delta.template segment<dim>(dim * coupling.b.node));
      prestress_.force[c][i] = data.force[i] + data.slope[i] * stretch;
    }
  }
}

template <FrameGroup G>
void IterationMatrix<G>::linearise(const Equations<G>& eq, const State<G>& s,
                                   const LoadLevel& level, const RateTangents<G>* rates) {
  linearise_bodies(s, level, rates);
  for (const auto& load : model_.loads) linearise_load(load, s, level);
  damped_ = rates && eq.damping > 0;
  for (size_t c = 0; c < couplings_.size(); ++c)
    linearise_coupling(static_cast<int>(c), eq, s, rates);
}

template <FrameGroup G>
void IterationMatrix<G>::linearise_bodies(const State<G>& s, const LoadLevel& level,
                                          const RateTangents<G>* rates) {
  const typename Model<G>::Vector gravity = level.factor * model_.gravity_at(level.t);
  for (size_t b = 0; b < A_.size(); ++b) {
    const Body<G>& body = *model_.bodies[b];
    const BodyState<G> state = model_.body_state(s, static_cast<int>(b));
    const int first = model_.first_node(static_cast<int>(b));
    const auto* stress = own_stress_ ? nullptr : prestress_.section[b].data();
    if (!rates) {
      body.exact_tangent(state, gravity, {}, stress, A_[b]);
      continue;
    }
    body.exact_tangents(state, gravity, stress, A_[b], C_[b], M_[b]);
    A_[b].add_scaled_columns(C_[b], rates->v.data() + first);
    A_[b].add_scaled_columns(M_[b], rates->vdot.data() + first);
  }
}

/// Follower loads are constant in the local frames but for what elements make of spread ones; dead
/// ones turn against them.
template <FrameGroup G>
void IterationMatrix<G>::linearise_load(const Load<G>& load, const State<G>& s,
                                        const LoadLevel& level) {
  if (load.port.body < 0 || (load.follower && !load.spread)) return;
  const typename G::Tangent wrench = load_value(load.scale, level) * load.wrench;
  auto& A = A_[load.port.body];
  const int first = model_.first_node(load.port.body);
  if (!load.spread) {
    const auto& J = load.port.J;
    A.add_to_node(load.port.node - first,
                  J.transpose() * dead_load_tangent<G>(load.port.frame(s.H), wrench) * J);
    return;
  }
  if (load.share.size() > 0) {  // all of it follows the first node
    if (load.follower) return;
    const typename G::Matrix D = dead_load_tangent<G>(s.H[first], wrench);
    for (size_t i = 0; i < A.nodes.size(); ++i)
      A.dense.template block<dim, dim>(dim * static_cast<int>(i), 0).noalias() +=
          load.share.template middleRows<dim>(dim * A.nodes[i]) * D;
    return;
  }
  model_.bodies[load.port.body]->add_spread_curvature_tangent(model_.body_state(s, load.port.body),
                                                              {wrench, load.follower}, A);
  if (load.follower) return;
  for (int k = 0; k < A.blocks(); ++k) {
    const typename G::Matrix D = dead_load_tangent<G>(s.H[first + k], wrench);
    const auto& W = load.distribution;
    A.D[k] += W.D[k] * D;
    if (k > 0) A.U[k - 1] += W.U[k - 1] * D;
    if (k + 1 < A.blocks()) A.L[k] += W.L[k] * D;
  }
}

/// Sum over acting rows of f D^2(row) + B^T (k B + c v^T D^2(row)), and C = c B^T B.
template <FrameGroup G>
void IterationMatrix<G>::linearise_coupling(int index, const Equations<G>& eq, const State<G>& s,
                                            const RateTangents<G>* rates) {
  using Columns = Eigen::Matrix<double, 2 * dim, 1>;
  const auto& c = model_.couplings[index];
  const auto& B = eq.couplings[index].B;
  const auto& slope = eq.couplings[index].slope;
  const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
  Pair J = Pair::Zero();
  Columns v = Columns::Zero();
  if (c.a.body >= 0) {
    J.template topLeftCorner<dim, dim>() = c.a.J;
    v.template head<dim>() = c.a.J * s.v.template segment<dim>(dim * c.a.node);
  }
  if (c.b.body >= 0) {
    J.template bottomRightCorner<dim, dim>() = c.b.J;
    v.template tail<dim>() = c.b.J * s.v.template segment<dim>(dim * c.b.node);
  }
  Pair K = Pair::Zero(), C = Pair::Zero(), turned = Pair::Zero();
  bool damps = false;
  if (damped_) rates_[index].setZero(c.constraints, 2 * dim);
  for (int i = 0; i < c.acting; ++i) {
    const auto& e = c.rows[i];
    const typename Row<G>::Hessian hessian = e.row.hessian(motion);
    const bool constraint = e.role == Role::Constraint;
    turned +=
        (constraint ? s.lambda[c.first_constraint + i] : prestress_.force[index][i]) * hessian;
    if (constraint && damped_) rates_[index].row(i) = eq.damping * (v.transpose() * hessian * J);
    if (constraint) continue;
    const Columns row = B.row(i).transpose();
    K += slope[i] * row * row.transpose();
    if (e.law.damping == 0) continue;
    K += e.law.damping * row * (v.transpose() * hessian * J);
    C += e.law.damping * row * row.transpose();
    damps = true;
  }
  K += J.transpose() * turned * J;
  couplings_[index] = {K, C, damps};
  if (!rates) return;
  Pair V = Pair::Zero();
  if (c.a.body >= 0) V.template topLeftCorner<dim, dim>() = rates->v[c.a.node];
  if (c.b.body >= 0) V.template bottomRightCorner<dim, dim>() = rates->v[c.b.node];
  couplings_[index].A += C * V;
  if (damped_) rates_[index] += eq.damping * B.topRows(c.constraints) * V;
}

template <FrameGroup G>
auto IterationMatrix<G>::assemble(const Equations<G>& eq, const State<G>& s, const LoadLevel& level,
                                  const RateTangents<G>* rates) -> const Matrix& {
  linearise(eq, s, level, rates);
  assembly_.begin();
  for (size_t b = 0; b < A_.size(); ++b)
    add_body(A_[b], dim * model_.first_node(static_cast<int>(b)), assembly_);
  for (const int node : followers_)
    for (int i = 0; i < dim; ++i) assembly_.add(dim * node + i, dim * node + i, 1);
  for (size_t index = 0; index < couplings_.size(); ++index) {
    const auto& c = model_.couplings[index];
    each_block_of(c, couplings_[index].A, [&](int row, int column, const auto& block) {
      assembly_.add_block(row, column, block);
    });
    const auto& B = eq.couplings[index].B;
    for (int i = 0; i < c.constraints; ++i)
      for (const auto& [port, first] : {std::pair{&c.a, 0}, std::pair{&c.b, dim}})
        for (int j = 0; j < dim && port->body >= 0; ++j) {
          const int row = model_.size() + c.first_constraint + i, column = dim * port->node + j;
          assembly_.add(row, column, B(i, first + j) + (damped_ ? rates_[index](i, first + j) : 0));
          assembly_.add(column, row, B(i, first + j));
        }
  }
  if (model_.penalty.form != ConstraintForm::Multipliers)
    for (int i = 0; i < model_.constraints(); ++i)
      assembly_.add(model_.size() + i, model_.size() + i, -eq.compliance[i]);
  matrix_ = &assembly_.finish();
  return *matrix_;
}

template <FrameGroup G>
template <class F>
void IterationMatrix<G>::each_block_of(const Coupling<G>& c, const Pair& K, F f) const {
  const PortOf<G>* ports[] = {&c.a, &c.b};
  for (int p = 0; p < 2; ++p)
    for (int q = 0; q < 2; ++q)
      if (ports[p]->body >= 0 && ports[q]->body >= 0)
        f(dim * ports[p]->node, dim * ports[q]->node, K.template block<dim, dim>(dim * p, dim * q));
}

template <FrameGroup G>
auto IterationMatrix<G>::mass() -> const Matrix& {
  mass_.begin();
  for (size_t b = 0; b < M_.size(); ++b)
    add_body(M_[b], dim * model_.first_node(static_cast<int>(b)), mass_);
  return mass_.finish();
}

template <FrameGroup G>
void IterationMatrix<G>::add_bodies_product(const BodyMatrices& K, const Eigen::MatrixXd& x,
                                            bool transposed, Eigen::MatrixXd& y) const {
  for (size_t b = 0; b < K.size(); ++b) {
    const int first = dim * model_.first_node(static_cast<int>(b));
    if (const Matrix& A = K[b].sparse; K[b].is_sparse()) {
      const auto of_body = x.middleRows(first, A.cols());
      if (transposed)
        y.middleRows(first, A.rows()).noalias() += A.transpose() * of_body;
      else
        y.middleRows(first, A.rows()).noalias() += A * of_body;
      continue;
    }
    each_block(K[b], first, [&](int row, int column, const auto& block) {
      if (transposed)
        add_block_product(block.transpose(), x, row, y, column);
      else
        add_block_product(block, x, column, y, row);
    });
  }
}

template <FrameGroup G>
void IterationMatrix<G>::add_mass_product(const Eigen::MatrixXd& x, bool transposed,
                                          Eigen::MatrixXd& y) const {
  add_bodies_product(M_, x, transposed, y);
}

/// C of a coupling is symmetric.
template <FrameGroup G>
void IterationMatrix<G>::add_damping_product(const Eigen::MatrixXd& x, bool transposed,
                                             Eigen::MatrixXd& y) const {
  add_bodies_product(C_, x, transposed, y);
  for (size_t c = 0; c < couplings_.size(); ++c)
    if (couplings_[c].damps)
      each_block_of(model_.couplings[c], couplings_[c].C,
                    [&](int row, int column, const auto& block) {
                      add_block_product(block, x, column, y, row);
                    });
}

template class IterationMatrix<SE2>;
template class IterationMatrix<SE3>;

}  // namespace liesl
