/// @file
/// Derivatives of meshed parts whose nodes all move by the nodes at rest.

#include "mbs/bodies/continuum.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

}  // namespace

/// Numbers of the mesh and its masses are polynomials of its nodes, which the differences of fourth
/// order that the weights are have exactly; so are positions at rest where p is a length. What is
/// no polynomial, the forces of the cells and of the averaged ports, is differentiated.
template <FrameGroup G>
class ContinuumBody<G>::ByShape final : public ShapeDerivative<G> {
 public:
  ByShape(const ContinuumBody& body, const std::vector<NearbyBody<G>>& nearby);
  void add(const BodyState<G>& s, const StateDirection& d, const Vector& gravity,
           const Vector& dgravity, double* r) const override;

 private:
  using Rotation = Eigen::Matrix<double, rd, 1>;
  /// Where nodes of the mesh are and how they move, inertial, or what that changes by.
  struct Motion {
    Points x, v, a;
    explicit Motion(int n) : x(sd, n), v(sd, n), a(sd, n) {}
  };
  Motion change(const BodyState<G>& s, const StateDirection& d) const;
  void add_cell(int e, const Motion& by, Room& room, Points& df) const;
  void add_to_nodes(const G* H, const double* eta, const Points& f, const Points& df,
                    double* r) const;

  const ContinuumBody& body_;
  Points rest_, arm_;
  VectorXd stiff_;
  Eigen::SparseMatrix<double> mass_;
  std::vector<typename Cell::Variation> cells_;
  std::vector<typename AveragedPort<G>::Variation> averaged_;
};

template <FrameGroup G>
ContinuumBody<G>::ByShape::ByShape(const ContinuumBody& body,
                                   const std::vector<NearbyBody<G>>& nearby)
    : body_(body),
      rest_(Points::Zero(sd, body.mesh_nodes())),
      arm_(rest_),
      stiff_(VectorXd::Zero(body.stiff_.size())),
      mass_(0 * body.mass_) {
  std::vector<std::vector<std::pair<double, const AveragedPort<G>*>>> ports(body.averaged_.size());
  for (const auto& [weight, other] : nearby) {
    const ContinuumBody& at = *of(*other);
    rest_ += weight * at.rest_;
    arm_ += weight * at.arm_;
    stiff_ += weight * at.stiff_;
    mass_ += weight * at.mass_;
    for (std::size_t p = 0; p < ports.size(); ++p) ports[p].emplace_back(weight, &at.averaged_[p]);
  }
  typename Cell::Positions nodes, change;
  for (int e = 0; e < body.cells_.cols(); ++e) {
    body.gather(e, body.rest_, nodes);
    body.gather(e, rest_, change);
    cells_.push_back(body.cell(e).variation(nodes, change));
  }
  for (std::size_t p = 0; p < ports.size(); ++p)
    averaged_.push_back(body.averaged_[p].variation(ports[p]));
}

/// Of x = x_P + R s, v = R y with y = u + w x s, a = R z with z = u' + w' x s + w x y.
template <FrameGroup G>
auto ContinuumBody<G>::ByShape::change(const BodyState<G>& s, const StateDirection& d) const
    -> Motion {
  Motion by(body_.mesh_nodes());
  for (int i = 0; i < body_.mesh_nodes(); ++i) {
    const int k = body_.node_of(i);
    const auto at = [k](const double* of) { return Eigen::Map<const Tangent>(of + dim * k); };
    const auto u = [&at](const double* of) -> Vector { return at(of).template head<sd>(); };
    const auto w = [&at](const double* of) -> Rotation { return at(of).template tail<rd>(); };
    Vector dx = u(d.eta), dy = u(d.v), dz = u(d.vdot);
    if (body_.held(i)) {
      const Vector arm = body_.arm_.col(i), darm = arm_.col(i), y = body_.local_velocity(s, i),
                   z = body_.local_acceleration(s, i);
      const Rotation turned = w(d.eta);
      dx += darm + turn<G>(arm) * turned;
      dy += turn<G>(darm) * w(s.v) + turn<G>(arm) * w(d.v);
      dz += turn<G>(darm) * w(s.vdot) + turn<G>(arm) * w(d.vdot) + turn<G>(dy) * w(s.v) +
            turn<G>(y) * w(d.v) + turn<G>(z) * turned;
      dy += turn<G>(y) * turned;
    }
    by.x.col(i) = s.H[k].R * dx;
    by.v.col(i) = s.H[k].R * dy;
    by.a.col(i) = s.H[k].R * dz;
  }
  return by;
}

/// df += what the forces of a cell change by. @pre room.x, and room.v with damping
template <FrameGroup G>
void ContinuumBody<G>::ByShape::add_cell(int e, const Motion& by, Room& room, Points& df) const {
  const Cell& cell = body_.cell(e);
  typename Cell::Positions dx, dv;
  body_.gather(e, by.x, dx);
  body_.stress_of(e, room, false);  // room.at, room.E, room.stress
  const auto& of_cell = cells_[static_cast<std::size_t>(e)];
  const VectorXd dE = 0.5 * cell.rate_variation(room.at, room.at, dx, dx, of_cell);
  VectorXd dstress = body_.stiff_[e] * cell.stress_variation(room.E, dE, of_cell);
  if (body_.damping_ > 0) {
    body_.gather(e, by.v, dv);
    const VectorXd drate = cell.rate_variation(room.at, room.rates, dx, dv, of_cell);
    dstress += body_.viscosity(e) * cell.linear_variation(room.rate, drate, of_cell);
  }
  if (stiff_[e] != 0) dstress += stiff_[e] / body_.stiff_[e] * room.stress;
  room.forces.setZero(sd, body_.cells_.rows());
  cell.add_force_variation(room.at, room.stress, dx, dstress, of_cell, room.forces);
  for (int c = 0; c < body_.cells_.rows(); ++c) df.col(body_.cells_(c, e)) += room.forces.col(c);
}

/// On held nodes [R^T f; s x R^T f].
template <FrameGroup G>
void ContinuumBody<G>::ByShape::add_to_nodes(const G* H, const double* eta, const Points& f,
                                             const Points& df, double* r) const {
  for (int i = 0; i < body_.mesh_nodes(); ++i) {
    const int k = body_.node_of(i);
    const Vector local = H[k].R.transpose() * f.col(i);
    Vector change = H[k].R.transpose() * df.col(i);
    Eigen::Map<Tangent> out(r + dim * k);
    if (body_.held(i)) {
      change -= turn<G>(local) * Eigen::Map<const Tangent>(eta + dim * k).template tail<rd>();
      out.template tail<rd>() += turn<G>(arm_.col(i)).transpose() * local +
                                 turn<G>(body_.arm_.col(i)).transpose() * change;
    }
    out.template head<sd>() += change;
  }
}

template <FrameGroup G>
void ContinuumBody<G>::ByShape::add(const BodyState<G>& s, const StateDirection& d,
                                    const Vector& gravity, const Vector& dgravity,
                                    double* r) const {
  body_.in_room(s, [&](Room& room) {
    Motion by = change(s, d);
    Points f, df = Points::Zero(sd, body_.mesh_nodes());
    body_.internal_forces(s, room, f, nullptr);
    for (int e = 0; e < body_.cells_.cols(); ++e) add_cell(e, by, room, df);
    body_.inertia_forces(s, gravity, room, room.f);
    f += room.f;
    df += (by.a.colwise() - dgravity) * body_.mass_ + room.a * mass_;
    add_to_nodes(s.H, d.eta, f, df, r);
    for (std::size_t p = 0; p < averaged_.size(); ++p)
      body_.averaged_[p].add_variation(s, d, gravity, dgravity, averaged_[p], r);
  });
}

template <FrameGroup G>
bool ContinuumBody<G>::same_but_for_nodes(const ContinuumBody& other) const {
  const auto& a = shapes_[0].material();
  const auto& b = other.shapes_[0].material();
  const auto same_size = [](const auto& x, const auto& y) {
    return x.rows() == y.rows() && x.cols() == y.cols();
  };
  return same_size(cells_, other.cells_) && cells_ == other.cells_ && node_of_ == other.node_of_ &&
         damping_ == other.damping_ && thickness_ == other.thickness_ && a.E == b.E &&
         a.nu == b.nu && shapes_[0].law() == other.shapes_[0].law() &&
         averaged_.size() == other.averaged_.size();
}

template <FrameGroup G>
std::unique_ptr<ShapeDerivative<G>> ContinuumBody<G>::by_shape(
    const std::vector<NearbyBody<G>>& nearby) const {
  for (const auto& [weight, body] : nearby) {
    const ContinuumBody* other = of(*body);
    if (!other || !same_but_for_nodes(*other)) return nullptr;
  }
  return std::make_unique<ByShape>(*this, nearby);
}

#define LIESL_INSTANTIATE(G)                                                      \
  template bool ContinuumBody<G>::same_but_for_nodes(const ContinuumBody&) const; \
  template std::unique_ptr<ShapeDerivative<G>> ContinuumBody<G>::by_shape(        \
      const std::vector<NearbyBody<G>>&) const;
LIESL_INSTANTIATE(SE2)
LIESL_INSTANTIATE(SE3)
#undef LIESL_INSTANTIATE

}  // namespace liesl
