#include "mbs/system/nearby_models.hpp"

#include <stdexcept>

namespace liesl {
namespace {

template <class G>
bool has_amplitudes(const Model<G>& model) {
  for (const auto& body : model.bodies)
    for (int k = 0; k < body->nodes(); ++k)
      if (body->kind(k) == NodeKind::Amplitudes) return true;
  return false;
}

/// With the weights of the penalties that the model has: they are no function of p.
template <class G>
Model<G> built(const Mechanism& mechanism, const Model<G>& of) {
  Model<G> model = Model<G>::build(mechanism, of.space);
  model.penalty = of.penalty;
  return model;
}

/// Do nodes move along the group, or are positions next to a frame of their body that does?
template <class G>
bool has_carriers(const Model<G>& model) {
  if (model.update != NodeUpdate::Screw) return false;
  for (const auto& body : model.bodies)
    for (int k = 0; k < body->nodes(); ++k)
      if (body->kind(k) == NodeKind::Position && body->kind(0) != NodeKind::Frame) return false;
  return true;
}

/// Do the nodes of a body go with its first frame? Next to positions, which have no other axes, a
/// frame that went along its own would strain what is between them by their difference.
template <class G>
bool go_together(const Body<G>& body) {
  for (int k = 0; k < body.nodes(); ++k)
    if (body.kind(k) == NodeKind::Position) return true;
  return false;
}

/// From the frame at rest of a node to that of a nearby model; of nodes that go together the way in
/// the axes of the first frame, and the turn.
template <class G>
G way_of(const Body<G>& body, const Body<G>& neighbour, int node, bool carried) {
  const auto k = static_cast<std::size_t>(node);
  G way = body.reference[k].inverse() * neighbour.reference[k];
  if (!carried) return way;
  if (body.kind(node) == NodeKind::Position) way = G::identity();
  way.x = body.reference[0].R.transpose() * (neighbour.reference[k].x - body.reference[k].x);
  return way;
}

/// The turn of a way alone.
template <class G>
G turn_of(const G& way) {
  G turn = way;
  turn.x.setZero();
  return turn;
}

/// Are the nodes at rest where they were, next to the first one?
template <class G>
bool same_shape(const Body<G>& a, const Body<G>& b) {
  for (std::size_t k = 1; k < a.reference.size(); ++k) {
    const G way = a.reference[0].inverse() * a.reference[k],
            there = b.reference[0].inverse() * b.reference[k];
    if (!(G::log(way.inverse() * there)).isZero(1e-14 * way.x.norm())) return false;
  }
  return true;
}

/// Are the same rows constraints, and the same ones left out as repeating others?
template <class G>
bool same_roles(const Model<G>& a, const Model<G>& b) {
  for (std::size_t c = 0; c < a.couplings.size(); ++c)
    for (std::size_t i = 0; i < a.couplings[c].rows.size(); ++i)
      if (a.couplings[c].rows[i].role != b.couplings[c].rows[i].role ||
          a.couplings[c].rows[i].row.kind() != b.couplings[c].rows[i].row.kind())
        return false;
  return true;
}

}  // namespace

template <FrameGroup G>
NearbyModels<G>::Neighbour::Neighbour(double of_p, const Mechanism& neighbour, const Model<G>& of)
    : weight(of_p), mechanism(neighbour), model(built(neighbour, of)), equations(model) {}

template <FrameGroup G>
NearbyModels<G>::NearbyModels(const NearbyMechanisms& mechanisms, const Model<G>& model)
    : model_(model) {
  if (has_amplitudes(model))
    throw std::invalid_argument(
        "by geometry there are no derivatives of bodies in floating frames, whose modes change "
        "with it: expected beams of another formalism, no reduced meshed parts");
  for (std::size_t i = 0; i < mechanisms.at->size(); ++i) {
    models_.push_back(
        std::make_unique<Neighbour>(mechanisms.weight(i), (*mechanisms.at)[i], model));
    const Model<G>& neighbour = models_.back()->model;
    if (neighbour.size() != model.size() || neighbour.constraints() != model.constraints() ||
        neighbour.rows() != model.rows() || !same_roles(neighbour, model))
      throw std::invalid_argument(
          "the joints repeat other rows at neighbouring values: expected a place where the number "
          "of independent rows does not change");
  }
  set_shapes();
  if (has_carriers(model)) {
    set_lift();
    return;
  }
  for (const auto& neighbour : models_)
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      strains_ = strains_ || !same_shape(*model.bodies[b], *neighbour->model.bodies[b]);
}

template <FrameGroup G>
void NearbyModels<G>::set_lift() {
  Eigen::VectorXd lift = Eigen::VectorXd::Zero(model_.size());
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const Body<G>& body = *model_.bodies[b];
    const int first = model_.first_node(static_cast<int>(b));
    const bool together = go_together(body);
    for (int k = 0; k < body.nodes(); ++k) {
      const bool carried = together && k > 0;
      carriers_.push_back(carried ? first : first + k);
      frames_.push_back(body.kind(k) == NodeKind::Frame);
      for (const auto& neighbour : models_) {
        const G way = way_of(body, *neighbour->model.bodies[b], k, carried);
        neighbour->moved.push_back(way);
        typename G::Tangent xi = G::log(carried ? turn_of(way) : way);
        if (carried) xi.template head<G::space_dim>() = way.x;
        lift.template segment<G::dim>(G::dim * (first + k)) += neighbour->weight * xi;
      }
    }
  }
  if (!lift.isZero(0)) lift_ = std::move(lift);
}

template <FrameGroup G>
void NearbyModels<G>::set_shapes() {
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    std::vector<NearbyBody<G>> nearby;
    for (const auto& neighbour : models_)
      nearby.push_back({neighbour->weight, neighbour->model.bodies[b].get()});
    auto forces = model_.bodies[b]->by_shape(nearby);
    if (!forces) continue;
    const int body = static_cast<int>(b);
    shapes_.push_back({body, std::move(forces), model_.bodies[b]->make_workspace()});
    for (const auto& neighbour : models_) neighbour->equations.leave_out(body);
  }
}

template <FrameGroup G>
void NearbyModels<G>::add_shapes(const State<G>& s, const LoadLevel& level, bool lifted,
                                 Eigen::VectorXd& r_p) const {
  if (shapes_.empty()) return;
  typename Model<G>::Vector dgravity = Model<G>::Vector::Zero();
  for (const auto& neighbour : models_)
    dgravity += neighbour->weight * level.factor * neighbour->model.gravity_at(level.t);
  for (const Shape& shape : shapes_) {
    const int first = model_.first_node(shape.body), n = model_.bodies[shape.body]->nodes();
    Eigen::MatrixXd d = Eigen::MatrixXd::Zero(G::dim * n, 3);
    for (int k = 0; lifted && k < n; ++k) {
      const NodeDirection of = direction(s, s.vdot, first + k);
      d.middleRows<G::dim>(G::dim * k) << of.eta, of.v, of.rate;
    }
    BodyState<G> state = model_.body_state(s, shape.body);
    state.work = shape.work.get();
    shape.forces->add(state, {d.col(0).data(), d.col(1).data(), d.col(2).data()},
                      level.factor * model_.gravity_at(level.t), dgravity,
                      r_p.data() + G::dim * first);
  }
}

template <FrameGroup G>
void NearbyModels<G>::add(const State<G>& s, const Eigen::VectorXd& previous,
                          const LoadLevel& level, Eigen::VectorXd& r_p,
                          Eigen::VectorXd& phi_p) const {
  for (const auto& neighbour : models_) {
    neighbour->equations.evaluate(s, previous, level);
    r_p += neighbour->weight * neighbour->equations.r;
    phi_p += neighbour->weight * neighbour->equations.phi;
  }
  add_shapes(s, level, false, r_p);
}

/// eta = xi, ad(v) xi, ad(rate) xi; where a node is carried, those of a point that is fixed to its
/// carrier, and of its own turn.
template <FrameGroup G>
auto NearbyModels<G>::direction(const State<G>& s, const Eigen::VectorXd& rates, int node) const
    -> NodeDirection {
  constexpr int sd = G::space_dim;
  using Tangent = typename G::Tangent;
  const int carrier = carriers_[static_cast<std::size_t>(node)];
  const auto of = [](const Eigen::VectorXd& x, int k) -> Tangent {
    return x.template segment<G::dim>(G::dim * k);
  };
  const Tangent xi = of(lift_, node);
  if (carrier == node) return {xi, G::ad(of(s.v, node)) * xi, G::ad(of(rates, node)) * xi};
  const Shift shift = shift_of(s, rates, node, xi.template head<sd>());
  Tangent turn = xi;
  turn.template head<sd>().setZero();
  NodeDirection out{turn, G::ad(of(s.v, node)) * turn, G::ad(of(rates, node)) * turn};
  out.eta.template head<sd>() += shift.x;
  out.v.template head<sd>() += shift.v;
  out.rate.template head<sd>() += shift.vdot;
  return out;
}

/// Of a frame vdot is the rate of R^T x', of a position R^T x''.
template <FrameGroup G>
auto NearbyModels<G>::shift_of(const State<G>& s, const Eigen::VectorXd& rates, int node,
                               const Vector& xi) const -> Shift {
  using Tangent = typename G::Tangent;
  constexpr int sd = G::space_dim;
  const int from = G::dim * carriers_[static_cast<std::size_t>(node)], at = G::dim * node;
  const CarriedRates<G> carried(s.v.template segment<G::dim>(from),
                                rates.template segment<G::dim>(from), xi);
  const SquareMatrix<sd> R = s.H[static_cast<std::size_t>(node)].R.transpose() *
                             s.H[static_cast<std::size_t>(from / G::dim)].R;
  Shift shift{R * xi, R * carried.v, R * carried.vdot};
  if (frames_[static_cast<std::size_t>(node)]) {
    Tangent turning = s.v.template segment<G::dim>(at), along = Tangent::Zero();
    turning.template head<sd>().setZero();
    along.template head<sd>() = shift.v;
    shift.vdot -= (G::ad(turning) * along).template head<sd>();
  }
  return shift;
}

template <FrameGroup G>
void NearbyModels<G>::lift(const Neighbour& neighbour, const State<G>& s, State<G>& lifted) const {
  constexpr int sd = G::space_dim;
  using Tangent = typename G::Tangent;
  for (std::size_t k = 0; k < s.H.size(); ++k) {
    const auto at = G::dim * static_cast<Eigen::Index>(k);
    const bool carried = carriers_[k] != static_cast<int>(k);
    const G way = carried ? turn_of(neighbour.moved[k]) : neighbour.moved[k];
    lifted.H[k] = s.H[k] * way;
    Tangent v = s.v.template segment<G::dim>(at), vdot = s.vdot.template segment<G::dim>(at);
    if (carried) {
      const Shift shift = shift_of(s, s.vdot, static_cast<int>(k), neighbour.moved[k].x);
      lifted.H[k].x += s.H[k].R * shift.x;
      v.template head<sd>() += shift.v;
      vdot.template head<sd>() += shift.vdot;
    }
    const auto Ad = way.AdInv();
    lifted.v.template segment<G::dim>(at) = Ad * v;
    lifted.vdot.template segment<G::dim>(at) = Ad * vdot;
  }
}

template <FrameGroup G>
void NearbyModels<G>::add_lifted(const State<G>& s, const Eigen::VectorXd& previous,
                                 const LoadLevel& level, Eigen::VectorXd& r_p,
                                 Eigen::VectorXd& phi_p) const {
  State<G> lifted = s;
  for (const auto& neighbour : models_) {
    lift(*neighbour, s, lifted);
    neighbour->equations.evaluate(lifted, previous, level);
    r_p += neighbour->weight * neighbour->equations.r;
    phi_p += neighbour->weight * neighbour->equations.phi;
  }
  add_shapes(s, level, true, r_p);
}

template <FrameGroup G>
State<G> NearbyModels<G>::seen_by(const Neighbour& neighbour, const State<G>& s) {
  State<G> out = s;
  neighbour.equations.observe(s, s.rows, out.rows);
  neighbour.model.complete(out);
  return out;
}

template class NearbyModels<SE2>;
template class NearbyModels<SE3>;

}  // namespace liesl
