#include "mbs/system/response_value.hpp"

#include <cmath>

#include "mbs/system/energy.hpp"

namespace liesl {

int components(const ResponseSpec& r, bool planar) {
  switch (r.kind) {
    case ResponseKind::Position:
    case ResponseKind::Velocity:
    case ResponseKind::AngularVelocity:
    case ResponseKind::Displacement:
      return r.axis ? 1 : 3;
    case ResponseKind::Deflection:
      return planar || r.everywhere ? 1 : 2;
    default:
      return 1;
  }
}

const char* name_of(ResponseKind kind) {
  switch (kind) {
    case ResponseKind::Position:
      return "position";
    case ResponseKind::Velocity:
      return "velocity";
    case ResponseKind::AngularVelocity:
      return "angular_velocity";
    case ResponseKind::Displacement:
      return "displacement";
    case ResponseKind::Deflection:
      return "deflection";
    case ResponseKind::Elongation:
      return "elongation";
    case ResponseKind::Coordinate:
      return "coordinate";
    case ResponseKind::JointForce:
      return "joint_force";
    case ResponseKind::SectionForce:
      return "section_force";
    case ResponseKind::Stress:
      return "stress";
    case ResponseKind::Energy:
      return "energy";
    case ResponseKind::Compliance:
      return "compliance";
  }
  return "";
}

const char* unit(const ResponseSpec& r, const Mechanism& mechanism) {
  switch (r.kind) {
    case ResponseKind::Velocity:
      return "m/s";
    case ResponseKind::AngularVelocity:
      return "rad/s";
    case ResponseKind::JointForce:
      return "N";
    case ResponseKind::SectionForce:
      return r.component < 3 ? "N" : "N m";
    case ResponseKind::Stress:
      return "Pa";
    case ResponseKind::Energy:
    case ResponseKind::Compliance:
      return "J";
    case ResponseKind::Coordinate: {
      const JointType type = mechanism.joints[r.joint].type;
      const bool slides = type == JointType::Prismatic ||
                          (type == JointType::Cylindrical && r.coordinate == 0) ||
                          (type == JointType::Planar && r.coordinate < 2);
      return slides ? "m" : "rad";
    }
    default:
      return "m";
  }
}

Eigen::Vector2d chord_offset(const std::vector<SE3>& nodes, double s) {
  const int n = static_cast<int>(nodes.size()) - 1;
  const int e = std::min(n - 1, static_cast<int>(s * n + 1e-9));
  const double inside = s * n - e;
  Vec3 point = nodes[e].x;
  if (inside > 1e-9) {
    const SE3::Tangent d = SE3::log(nodes[e].inverse() * nodes[e + 1]);
    point = (nodes[e] * SE3::exp(inside * d)).x;
  }
  const Vec3 chord = (nodes[n].x - nodes[0].x).normalized();
  Vec3 y = nodes[0].R.col(1);
  y = (y - y.dot(chord) * chord).normalized();
  const Vec3 offset = point - nodes[0].x;
  return {offset.dot(y), offset.dot(chord.cross(y))};
}

template <FrameGroup G>
ResponseValues<G>::ResponseValues(const Mechanism& mechanism, const Model<G>& model)
    : mechanism_(mechanism), model_(model), view_(mechanism, model) {}

template <FrameGroup G>
std::vector<SE3> ResponseValues<G>::nodes(const G* H, int body) const {
  std::vector<SE3> frames;
  for (int k = 0; k < model_.bodies[body]->nodes(); ++k) frames.push_back(view_.node(H, body, k));
  return frames;
}

template <FrameGroup G>
Eigen::Vector2d ResponseValues<G>::deflection(int body, const std::vector<SE3>& now,
                                              double place) const {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[body].kind);
  return chord_offset(now, place) - chord_offset(beam.nodes, place);
}

template <FrameGroup G>
double ResponseValues<G>::elongation(const ResponseSpec& r, const State<G>& s) const {
  const G* H = s.H.data();
  return (view_.frame(H, r.to).x - view_.frame(H, r.at).x).norm() -
         (mechanism_.frame(r.to).x - mechanism_.frame(r.at).x).norm();
}

template <FrameGroup G>
const std::vector<std::vector<StressPoint>>& ResponseValues<G>::points_of(int body) const {
  const auto [known, fresh] = stress_points_.try_emplace(body);
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[body].kind);
  for (size_t e = 0; fresh && e < beam.sections.size(); ++e)
    known->second.push_back(stress_points(beam.sections[e], beam.material.nu));
  return known->second;
}

template <FrameGroup G>
double ResponseValues<G>::stress(const ResponseSpec& r, const State<G>& s) const {
  const auto& points = points_of(r.body);
  double largest = 0;
  for (int e = 0; e < model_.bodies[r.body]->elements(); ++e) {
    const SE3::Tangent n = view_.local(
        model_.bodies[r.body]->section_force(model_.body_state(s, r.body), e), r.body, e);
    for (const auto& point : points[e]) {
      const Vec3 stress = point.S * n;
      largest =
          std::max(largest, std::sqrt(stress[0] * stress[0] + 3 * stress.tail<2>().squaredNorm()));
    }
  }
  return largest;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::operator()(const ResponseSpec& r, const State<G>& s) const {
  const auto along = [&r](const Vec3& v) -> Eigen::VectorXd {
    return r.axis ? Eigen::VectorXd::Constant(1, r.axis->dot(v)) : Eigen::VectorXd(v);
  };
  const auto scalar = [](double v) -> Eigen::VectorXd { return Eigen::VectorXd::Constant(1, v); };
  switch (r.kind) {
    case ResponseKind::Position:
      return along(view_.frame(s.H.data(), r.at).x);
    case ResponseKind::Velocity:
      return along(view_.frame(s.H.data(), r.at).R *
                   view_.velocity(s.v.data(), r.at).template head<3>());
    case ResponseKind::AngularVelocity:
      return along(view_.velocity(s.v.data(), r.at).template tail<3>());
    case ResponseKind::Displacement: {
      const Port base{r.at.body, 0, SE3::identity()};
      return along((view_.frame(s.H.data(), base).inverse() * view_.frame(s.H.data(), r.at)).x -
                   (mechanism_.frame(base).inverse() * mechanism_.frame(r.at)).x);
    }
    case ResponseKind::Deflection: {
      const std::vector<SE3> now = nodes(s.H.data(), r.body);
      if (r.everywhere) {
        double largest = 0;
        const int n = model_.bodies[r.body]->elements();
        for (int k = 1; k < n; ++k)
          largest = std::max(largest, deflection(r.body, now, double(k) / n).norm());
        return scalar(largest);
      }
      const Eigen::Vector2d offset = deflection(r.body, now, r.s);
      if constexpr (G::space_dim == 3) {
        return offset;
      } else {  // one of the two normals is the plane's; the other carries the offset
        const Vec3 normal = model_.space.frame.R.col(2);
        const auto& beam = std::get<BeamSpec>(mechanism_.bodies[r.body].kind);
        return scalar(std::abs(beam.nodes[0].R.col(1).dot(normal)) < 0.5 ? offset[0] : offset[1]);
      }
    }
    case ResponseKind::Elongation:
      return scalar(elongation(r, s));
    case ResponseKind::Coordinate:
      return scalar(joint_coordinates(mechanism_, model_, r.joint, s).at(r.coordinate));
    case ResponseKind::JointForce:
      return scalar(joint_force(mechanism_, model_, r.joint, s).template head<3>().norm());
    case ResponseKind::SectionForce:
      return scalar(
          view_.local(model_.bodies[r.body]->section_force(model_.body_state(s, r.body), r.element),
                      r.body, r.element)[r.component]);
    case ResponseKind::Stress:
      return scalar(stress(r, s));
    case ResponseKind::Compliance:
      return scalar(
          2 * model_.bodies[r.body]->energy(model_.body_state(s, r.body), model_.gravity).elastic);
    case ResponseKind::Energy:
      return scalar(total(mechanical_energy(model_, s)));
  }
  return scalar(0);
}

namespace {

template <FrameGroup G>
const Coupling<G>* find_joint(const Mechanism& mechanism, const Model<G>& model, int joint) {
  for (const auto& c : model.couplings)
    if (c.is_joint && c.name == mechanism.joints[joint].name) return &c;
  return nullptr;
}

}  // namespace

template <FrameGroup G>
SE3::Tangent joint_force(const Mechanism& mechanism, const Model<G>& model, int joint,
                         const State<G>& s) {
  SE3::Tangent total = SE3::Tangent::Zero();
  const Coupling<G>* c = find_joint(mechanism, model, joint);
  if (!c) return total;
  const G a = c->a.frame(s.H), b = c->b.frame(s.H);
  const RelativeMotion<G> motion(a, b);
  typename G::Tangent f = G::Tangent::Zero();
  for (int i = 0; i < c->constraints; ++i) {
    typename Row<G>::Gradient g;
    c->equations[i].row.gradient(motion, g);
    f -= s.lambda[c->first_constraint + i] * g.template tail<G::dim>();
  }
  // The joint's port has the inertial axes at the start; turn into the port's own.
  const JointSpec& spec = mechanism.joints[joint];
  const SE3 own = mechanism.frame(spec.b);
  const SE3::Tangent inertial = model.space.embed_local(f, SE3::identity());
  Mat3 axes = Mat3::Identity();
  if constexpr (G::space_dim == 2) axes = model.space.frame.R;
  total << own.R.transpose() * axes * inertial.template head<3>(),
      own.R.transpose() * axes * inertial.template tail<3>();
  return total;
}

template <FrameGroup G>
std::vector<double> joint_coordinates(const Mechanism& mechanism, const Model<G>& model, int joint,
                                      const State<G>& s) {
  constexpr int kCount[] = {0, 1, 1, 2, 0, 2, 3};  // by JointType
  std::vector<double> q(kCount[static_cast<int>(mechanism.joints[joint].type)], 0.0);
  if (const Coupling<G>* c = find_joint(mechanism, model, joint))
    for (size_t i = 0; i < c->equations.size(); ++i)
      if (const int k = c->equations[i].coordinate; k >= 0)
        q[k] = s.q[c->first_row + static_cast<int>(i)];
  return q;
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;
template SE3::Tangent joint_force(const Mechanism&, const Model<SE2>&, int, const State<SE2>&);
template SE3::Tangent joint_force(const Mechanism&, const Model<SE3>&, int, const State<SE3>&);
template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE2>&, int,
                                               const State<SE2>&);
template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE3>&, int,
                                               const State<SE3>&);

}  // namespace liesl
