#include "mbs/solvers/static_system.hpp"

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/bodies/beam.hpp"

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
StaticSystem<G>::StaticSystem(const Model<G>& model)
    : model_(model), assembly_(model.size() + model.constraints()) {
  for (const auto& body : model.bodies) {
    K_.emplace_back(body->nodes());
    const auto& K = body->stiffness();
    if (K.is_dense()) K_.back().set_dense(K.nodes, K.dense);
    prestress_.section.emplace_back(body->elements(), G::Tangent::Zero());
  }
  for (const auto& c : model.couplings) prestress_.force.push_back(Eigen::VectorXd::Zero(c.acting));
}

template <FrameGroup G>
void StaticSystem<G>::take_prestress(const Equations<G>& eq, const State<G>& s) {
  extrapolate_prestress(eq, s, Eigen::VectorXd::Zero(model_.size()));
}

template <FrameGroup G>
void StaticSystem<G>::extrapolate_prestress(const Equations<G>& eq, const State<G>& s,
                                            const Eigen::VectorXd& delta) {
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
      prestress_.force[c][i] = data.force[i] + coupling.equations[i].law.stiffness * stretch;
    }
  }
}

template <FrameGroup G>
const typename StaticSystem<G>::Matrix& StaticSystem<G>::assemble(const Equations<G>& eq,
                                                                  const State<G>& s,
                                                                  const LoadLevel& level) {
  assembly_.begin();
  add_bodies(s, level);
  add_loads(s, level);
  for (size_t b = 0; b < K_.size(); ++b)
    add_body(K_[b], dim * model_.first_node(static_cast<int>(b)), assembly_);
  for (size_t c = 0; c < model_.couplings.size(); ++c) add_coupling(static_cast<int>(c), eq, s);
  matrix_ = &assembly_.finish();
  return *matrix_;
}

template <FrameGroup G>
void StaticSystem<G>::add_bodies(const State<G>& s, const LoadLevel& level) {
  const typename Model<G>::Vector gravity = level.factor * model_.gravity;
  for (size_t b = 0; b < K_.size(); ++b)
    model_.bodies[b]->exact_tangent(model_.body_state(s, static_cast<int>(b)), gravity, {},
                                    prestress_.section[b].data(), K_[b]);
}

/// Follower loads are constant in the local frames; dead ones turn against them.
template <FrameGroup G>
void StaticSystem<G>::add_loads(const State<G>& s, const LoadLevel& level) {
  for (const auto& load : model_.loads) {
    if (load.port.body < 0 || load.follower) continue;
    const typename G::Tangent wrench = load_value(load.scale, level) * load.wrench;
    if (!load.spread) {
      const auto& J = load.port.J;
      assembly_.add_block(dim * load.port.node, dim * load.port.node,
                          J.transpose() * dead_load_tangent<G>(load.port.frame(s.H), wrench) * J);
      continue;
    }
    auto& K = K_[load.port.body];
    const int first = model_.first_node(load.port.body);
    if (const auto* beam = dynamic_cast<const Beam<G>*>(model_.bodies[load.port.body].get()))
      for (int e = 0; e < beam->elements(); ++e)
        K.add_element(
            e, beam->element(e).spread_curvature_tangent(s.H[first + e], s.H[first + e + 1],
                                                         wrench.template head<G::space_dim>()));
    for (int k = 0; k < K.blocks(); ++k) {
      const typename G::Matrix D = dead_load_tangent<G>(s.H[first + k], wrench);
      const auto& W = load.distribution;
      K.D[k] += W.D[k] * D;
      if (k > 0) K.U[k - 1] += W.U[k - 1] * D;
      if (k + 1 < K.blocks()) K.L[k] += W.L[k] * D;
    }
  }
}

/// B, B^T and sum over acting rows of f D^2(row) + k B^T B.
template <FrameGroup G>
void StaticSystem<G>::add_coupling(int index, const Equations<G>& eq, const State<G>& s) {
  using Pair = Eigen::Matrix<double, 2 * dim, 2 * dim>;
  const auto& c = model_.couplings[index];
  const auto& B = eq.couplings[index].B;
  const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
  const int node[] = {dim * c.a.node, dim * c.b.node};
  const bool moves[] = {c.a.body >= 0, c.b.body >= 0};
  Pair K = Pair::Zero();
  for (int i = 0; i < c.acting; ++i) {
    const auto& e = c.equations[i];
    const bool constraint = e.role == Role::Constraint;
    const int multiplier = c.first_constraint + i;
    const double force = constraint ? s.lambda[multiplier] : prestress_.force[index][i];
    K += force * e.row.hessian(motion);
  }
  Pair J = Pair::Zero();
  J.template topLeftCorner<dim, dim>() = c.a.J;
  J.template bottomRightCorner<dim, dim>() = c.b.J;
  K = (J.transpose() * K * J).eval();
  for (int i = c.constraints; i < c.acting; ++i)
    K += c.equations[i].law.stiffness * B.row(i).transpose() * B.row(i);
  for (int p = 0; p < 2; ++p) {
    if (!moves[p]) continue;
    for (int q = 0; q < 2; ++q)
      if (moves[q])
        assembly_.add_block(node[p], node[q], K.template block<dim, dim>(dim * p, dim * q));
    for (int i = 0; i < c.constraints; ++i)
      for (int j = 0; j < dim; ++j) {
        const int row = model_.size() + c.first_constraint + i;
        assembly_.add(row, node[p] + j, B(i, dim * p + j));
        assembly_.add(node[p] + j, row, B(i, dim * p + j));
      }
  }
}

template class StaticSystem<SE2>;
template class StaticSystem<SE3>;

}  // namespace liesl
