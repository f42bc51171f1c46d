#include "apps/tasks/part_range.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/tasks/motion_notes.hpp"
#include "liegroup/smallest_rotation.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/model/beam_ends.hpp"
#include "mbs/model/joint_kind.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBend = 0.15;     // rad
constexpr double kEuler = 0.1;     // its bending is about as much too stiff, or too soft in tension
constexpr double kFarBent = 1.5;   // rad
constexpr double kBuckled = 1;     // what a linear body that is pressed, or spins, cannot carry
constexpr double kFreeEnd = 0.25;  // of the Euler load between hinges: that of a free end
constexpr double kEndTurn = 1.6;   // of the first mode of a cantilever, over u/r
constexpr double kTwist = 0.02;    // of the bending of a chain: torsion that it has not
constexpr double kTwisted = 0.2;   // of it: nothing to rely on
constexpr double kNoTwist = 1e-6;  // rad
constexpr double kStill = 1e-6;    // rad/s
constexpr double kAlong = 1e-6;    // rad: an axis along a beam

/// Euler load of a bar that is as soft across the line to its end: C = d(end)/dF, in the axes of
/// `end`; 0 if there is none.
template <FrameGroup G>
double euler_load(const G& start, const G& end, const MatrixXd& C) {
  constexpr int sd = G::space_dim;
  const Eigen::Matrix<double, sd, 1> span = end.x - start.x;
  const double length = span.norm();
  if (length == 0) return 0;
  const VectorXd d = end.R.transpose() * span / length;
  const MatrixXd across = MatrixXd::Identity(sd, sd) - d * d.transpose();
  const double softest = linalg::symmetric_eigenvalues(across * C * across).maxCoeff();
  return softest > 0 ? M_PI * M_PI * length / (3 * softest) : 0;
}

/// |Omega x d|: what spins about d is not pulled along it.
template <FrameGroup G>
double turn_across(const VectorXd& d, const VectorXd& omega) {
  if constexpr (G::rotation_dim == 1)
    return std::abs(omega[0]);
  else
    return (omega - d * d.dot(omega)).norm();
}

/// Euler load from the softness of the end, held at the start. @pre it has amplitudes
template <FrameGroup G>
double euler_load(const ModalBody<G>& body) {
  const int last = body.nodes() - 1;
  const Eigen::Index n = body.basis().cols() - body.padding();
  const MatrixXd end = body.basis().block(G::dim * last, 0, G::space_dim, n);
  const MatrixXd C =
      end * linalg::LDLT(body.reduced_stiffness().topLeftCorner(n, n)).solve(end.transpose());
  return euler_load(body.reference[0], body.reference[last], C);
}

/// What is beyond a bound, and what helps against bending and against axial forces.
std::vector<RangeNote> passed(const std::string& who, const PartRange& r, const char* between,
                              const char* bending, const char* axial) {
  std::vector<RangeNote> said;
  if (r.bend > kBend)
    said.push_back({fmt::format("{} bends by up to {:.2g} rad{}, but its deformation is linear: {}",
                                who, r.bend, between, bending),
                    r.bend > kFarBent});
  const auto add = [&](const std::string& how, bool beyond) {
    said.push_back(
        {fmt::format("{} {}, but axial forces do not change how it bends: {}", who, how, axial),
         beyond});
  };
  if (r.euler > kEuler)
    add(fmt::format("carries up to {:.2g} of its Euler load", r.euler), r.euler > kBuckled);
  if (r.pull > kEuler)
    add(fmt::format("is pulled by up to {:.2g} of its Euler load", r.pull), false);
  if (r.spin > kEuler)
    add(fmt::format("turns at up to {:.2g} of its lowest frequency", std::sqrt(r.spin)),
        r.spin > kBuckled);
  return said;
}

std::vector<RangeNote> part_notes(const std::string& part, int interfaces, const PartRange& range) {
  return passed("the part '" + part + "'", range, interfaces > 1 ? " between its interfaces" : "",
                "divide it into several parts in a row",
                "divide it into several parts in a row, or use a beam");
}

/// @pre body is a beam that is simulated as modal
std::vector<RangeNote> beam_notes(const BodySpec& body, Formalism formalism,
                                  const PartRange& range) {
  BeamSpec plain = std::get<BeamSpec>(body.kind);
  std::string other;  // what makes it a beam that is not linear
  if (plain.as != BeamModel::AsFormalism)
    other = fmt::format("leave out bodies.{}.beam.as", body.name);
  plain.as = BeamModel::AsFormalism;
  if (const BeamModel left = model_of(plain, formalism);
      left == BeamModel::Modal || left == BeamModel::Rigid)
    other += std::string(other.empty() ? "" : " and ") + "use formalism se3";
  const std::string remedy = "divide it into several beams in a row, or " + other;
  return passed("the beam '" + body.name + "' in a floating frame", range, "", remedy.c_str(),
                remedy.c_str());
}

/// Does a joint hold the turn of what is at it about this axis?
bool holds(const JointSpec& joint, const Vec3& about) {
  const JointKind& kind = kind_of(joint.type);
  const auto turns = [](const JointRow& row) {
    return row.kind == JointRow::Kind::Perpendicular || row.kind == JointRow::Kind::Angle;
  };
  if (std::none_of(kind.constraints.begin(), kind.constraints.end(), turns)) return false;
  const Vec3 axes[] = {joint.axis, joint.axis2, joint.axis.cross(joint.axis2)};
  return std::none_of(kind.coordinates.begin(), kind.coordinates.end(), [&](const JointRow& row) {
    return row.kind == JointRow::Kind::Angle &&
           axes[row.about()].cross(about).norm() < kAlong * axes[row.about()].norm();
  });
}

/// Turn about x of the last frame of a chain against the one before it, carried onto it by the
/// smallest rotation. @param last of at least two nodes
double twist_of_end(const SE3* last) {
  const Mat3 &before = last[-1].R, &end = last->R;
  const Mat3 carried = smallest_rotation(before.col(0), end.col(0)) * before;
  const Mat3 rest = carried.transpose() * end;
  return std::atan2(rest(2, 1), rest(1, 1));
}

/// @param polar 3 I_p/(A L^2)
std::vector<RangeNote> chain_notes(const std::string& name, const PartRange& range, double polar) {
  std::vector<RangeNote> said;
  if (range.twist > std::max(kNoTwist, kTwist * range.bend))
    said.push_back(
        {fmt::format("the beam '{}' would be twisted by {:.2g} rad, beside bending by {:.2g} rad, "
                     "but a chain of segments has no torsion: use formalism se3",
                     name, range.twist, range.bend),
         range.twist > kTwisted * range.bend});
  const double spin = polar * range.turn;
  if (range.turn > kStill && spin > kTwist * range.speed)
    said.push_back(
        {fmt::format("the beam '{}' turns about its axis by {:.3g} rad/s, {:.2g} of the angular "
                     "momentum of its motion across, but inside a chain of segments nothing spins: "
                     "use formalism se3",
                     name, range.turn, spin / std::max(range.speed, kStill)),
         spin > kTwisted * range.speed});
  return said;
}

}  // namespace

template <FrameGroup G>
PartRanges<G>::PartRanges(const Mechanism& mechanism, const Model<G>& model)
    : mechanism_(mechanism), model_(model) {
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
    if (const auto* body = SolidBody<G>::of(*model.bodies[b])) add_part(*body, static_cast<int>(b));
  add_members();
}

template <FrameGroup G>
void PartRanges<G>::add_part(const SolidBody<G>& body, int index) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  Part part{&body, index, {}, {}, 0, 0, {}, 0, 0, 0, {}};
  if (body.points() == 2) {
    const G &first = body.reference[0], &second = body.reference[1];
    const MatrixXd K = body.reduced_stiffness().topLeftCorner(dim, dim);
    const Eigen::Matrix<double, sd, 1> span = second.x - first.x;
    part.euler = euler_load(first, second, K.inverse().topLeftCorner(sd, sd));
    part.d = first.R.transpose() * span.normalized();
    part.pull = K.topRows(sd).transpose() * part.d;
    part.centrifugal = body.total_mass() * span.norm() / 6;
  }
  if (body.points() == 1 && body.modes() > 0) {
    part.J = body.mass().dense.block(sd, sd, rd, rd);
    part.largest = linalg::symmetric_eigenvalues(part.J).maxCoeff();
    part.r2 = part.J.trace() / (rd == 1 ? 1 : 2);
    part.omega2 = body.omega2().minCoeff();
  }
  parts_.push_back(std::move(part));
}

template <FrameGroup G>
void PartRanges<G>::add_members() {
  const auto kind = [&](std::size_t b) {
    const auto* beam = std::get_if<BeamSpec>(&mechanism_.bodies[b].kind);
    return beam ? model_of(*beam, mechanism_.formalism) : BeamModel::Rigid;
  };
  bool untold = false;  // by PlaneStability
  for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b)
    untold = untold || kind(b) == BeamModel::Modal || kind(b) == BeamModel::Segments;
  for (std::size_t b = 0; untold && b < mechanism_.bodies.size(); ++b) {
    if (kind(b) == BeamModel::Rigid) continue;
    Member beam{model_.bodies[b].get(), nullptr, static_cast<int>(b)};
    if (kind(b) == BeamModel::Modal) {
      beam.modal = ModalBody<G>::of(*beam.body);
      if (beam.modal->basis().cols() == beam.modal->padding()) continue;
      beam.euler = euler_load(*beam.modal);
    }
    if (G::space_dim == 2) beam.sideways = sideways_load(beam.index);
    if (G::space_dim == 3 && kind(b) == BeamModel::Segments) {
      beam.may_twist = may_twist(beam.index);
      beam.polar = polar_share(std::get<BeamSpec>(mechanism_.bodies[b].kind));
    }
    members_.push_back(beam);
  }
}

/// pi^2 EI/L^2 about the axis in the plane that is across the beam.
template <FrameGroup G>
double PartRanges<G>::sideways_load(int body) const {
  double EI = std::numeric_limits<double>::infinity(), length = 0;
  if constexpr (G::space_dim == 2) {
    const auto& beam = std::get<BeamSpec>(mechanism_.bodies[static_cast<std::size_t>(body)].kind);
    const SpatialView<SE2> view(mechanism_, model_);
    for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e) {
      const Vec3 normal = view.local(SE2::Tangent(0, 0, 1), body, static_cast<int>(e)).tail<3>();
      const Vec3 across = normal.cross(Vec3::UnitX());
      for (const auto place : {ElementPlace::First, ElementPlace::Last}) {
        const SectionLaw law = section_law(section_at(beam, e, place), beam.material);
        EI = std::min(EI, across.dot(law.K.template block<3, 3>(3, 3) * across));
      }
      length += SE3::log(beam.nodes[e].inverse() * beam.nodes[e + 1]).template head<3>().norm();
    }
  }
  return length > 0 ? M_PI * M_PI * EI / (length * length) : 0;
}

/// At both ends by joints; or a load of which nothing tells that it does not turn an end that
/// spins, or a spin at the start, acts on it.
template <FrameGroup G>
bool PartRanges<G>::may_twist(int body) const {
  const BodySpec& spec = mechanism_.bodies[static_cast<std::size_t>(body)];
  const auto& nodes = std::get<BeamSpec>(spec.kind).nodes;
  const int last = static_cast<int>(nodes.size()) - 1;
  const auto turns = [&](const LoadSpec& load) {
    return !load.spread && load.port.body == body &&
           (!load.moment.isZero(0) || !load.port.offset.x.isZero(0));
  };
  if (std::any_of(mechanism_.loads.begin(), mechanism_.loads.end(), turns)) return true;
  const auto held = [&](int node) {
    return std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(),
                       [&](const JointSpec& joint) {
                         const bool at = (joint.a.body == body && joint.a.node == node) ||
                                         (joint.b.body == body && joint.b.node == node);
                         return at && holds(joint, nodes[1].x - nodes[0].x);
                       });
  };
  const bool spins = spec.angular_velocity.dot(nodes[1].x - nodes[0].x) != 0;
  return (held(0) && held(last)) || (spins && (held(0) || held(last)));
}

template <FrameGroup G>
void PartRanges<G>::measure_twist(Member& chain, const State<G>& s) const {
  if constexpr (G::space_dim == 3) {
    const BodyState<G> state = model_.body_state(s, chain.index);
    const int last = chain.body->nodes() - 1;
    PartRange& range = chain.range;
    range.twist = std::max(range.twist, std::abs(twist_of_end(state.H + last)));
    const Vec3 start = state.H[0].R.col(0);
    for (int k = 1; k <= last; ++k)
      range.bend = std::max(range.bend,
                            std::acos(std::clamp(start.dot(Vec3(state.H[k].R.col(0))), -1., 1.)));
  }
}

template <FrameGroup G>
double PartRanges<G>::polar_share(const BeamSpec& chain) {
  double mass = 0, polar = 0, length = 0;
  for (std::size_t e = 0; e < chain.sections.size(); ++e) {
    const double l = (chain.nodes[e + 1].x - chain.nodes[e].x).norm();
    const SectionLaw law = section_law(chain.sections[e], chain.material);
    mass += l * law.M(0, 0);
    polar += l * law.M(3, 3);
    length += l;
  }
  return mass > 0 ? 3 * polar / (mass * length * length) : 0;
}

template <FrameGroup G>
void PartRanges<G>::measure_spin(Member& chain, const BodyState<G>& state) const {
  if constexpr (G::space_dim == 3) {
    const auto& nodes =
        std::get<BeamSpec>(mechanism_.bodies[static_cast<std::size_t>(chain.index)].kind).nodes;
    const double length = (nodes.back().x - nodes.front().x).norm();
    for (const int k : {0, chain.body->nodes() - 1}) {
      const Eigen::Map<const SE3::Tangent> v(state.v + 6 * k);
      chain.range.turn = std::max(chain.range.turn, std::abs(v[3]));
      chain.range.speed = std::max(chain.range.speed, v.template head<3>().norm() / length);
    }
  }
}

template <FrameGroup G>
void PartRanges<G>::measure(Part& part, const State<G>& s) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  const SolidBody<G>& body = *part.body;
  PartRange& range = part.range;
  const int first = model_.first_node(part.index);
  const VectorXd e =
      body.coordinates({s.H.data() + first, nullptr, nullptr, s.w.data() + dim * first});
  const VectorXd omega = s.v.segment(dim * first + sd, rd);
  for (int i = 0; i + 1 < body.points(); ++i)
    range.bend = std::max(range.bend, e.segment(dim * i + sd, rd).norm());
  if (part.euler > 0) {
    const double pull = part.pull.dot(e.head(dim)), spin = turn_across<G>(part.d, omega);
    range.euler = std::max(range.euler, -pull / part.euler);
    range.pull = std::max(range.pull, (pull + part.centrifugal * spin * spin) / part.euler);
  }
  if (part.J.size() == 0) return;
  const int n = body.modes();
  if (part.largest > 0)
    range.spin = std::max(range.spin, omega.dot(part.J * omega) / part.largest / part.omega2);
  const double u2 = e.head(n).dot(body.mass().dense.block(dim, dim, n, n) * e.head(n));
  if (part.r2 > 0)
    range.bend = std::max(range.bend, kEndTurn * std::sqrt(std::max(0., u2) / part.r2));
}

template <FrameGroup G>
void PartRanges<G>::measure(Member& beam, const State<G>& s) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  const BodyState<G> state = model_.body_state(s, beam.index);
  PartRange& range = beam.range;
  if (beam.modal) {
    const VectorXd u = beam.modal->displacements(state.H);
    for (int k = 1; k < beam.modal->nodes(); ++k)
      range.bend = std::max(range.bend, u.segment(dim * k + sd, rd).norm());
  }
  if (beam.may_twist) measure_twist(beam, s);
  if (beam.polar > 0) measure_spin(beam, state);
  if (beam.euler == 0 && beam.sideways == 0) return;
  for (int e = 0; e < beam.body->elements(); ++e) {
    const double N = beam.body->section_force(state, e, ElementPlace::Middle)[0];
    if (beam.euler > 0) {
      range.euler = std::max(range.euler, -N / beam.euler);
      range.pull = std::max(range.pull, N / beam.euler);
    }
    if (beam.sideways > 0) range.sideways = std::max(range.sideways, -N / beam.sideways);
  }
}

template <FrameGroup G>
void PartRanges<G>::add(const State<G>& s) {
  for (Part& part : parts_) measure(part, s);
  for (Member& beam : members_) measure(beam, s);
}

template <FrameGroup G>
void PartRanges<G>::add(const Trajectory<G>& records) {
  if (parts_.empty() && members_.empty()) return;
  State<G> s = model_.initial_state();
  for (int n = 0; n < records.size(); ++n) {
    records.read(n, s);
    model_.complete(s);
    add(s);
  }
}

template <FrameGroup G>
std::vector<RangeNote> PartRanges<G>::notes() const {
  std::vector<RangeNote> all;
  const auto add = [&](const std::vector<RangeNote>& notes) {
    all.insert(all.end(), notes.begin(), notes.end());
  };
  for (const Member& beam : members_)
    if (beam.modal)
      add(beam_notes(mechanism_.bodies[static_cast<std::size_t>(beam.index)], mechanism_.formalism,
                     beam.range));
  for (const Member& beam : members_)
    if (beam.polar > 0) add(chain_notes(beam.body->name, beam.range, beam.polar));
  for (const Part& part : parts_) add(part_notes(part.body->name, part.body->points(), part.range));
  return all;
}

template <FrameGroup G>
std::vector<std::string> PartRanges<G>::leaving_plane() const {
  if (has_planar_mesh(mechanism_)) return {};
  const auto most = std::ranges::max_element(
      members_, {}, [](const Member& beam) { return beam.range.sideways; });
  if (most == members_.end() || most->range.sideways <= kFreeEnd) return {};
  return {fmt::format(
      "the motion may leave the plane: '{}' carries up to {:.2g} of its Euler load out of it, "
      "as a body by itself between hinges (an end that is free buckles at 0.25, clamped ends at 4; "
      "several in a row sooner), and floating "
      "frames and chains of segments do not tell; formalism \"se3\" does, simulation.space = "
      "\"planar\" keeps the plane and this note away",
      most->body->name, most->range.sideways)};
}

template class PartRanges<SE2>;
template class PartRanges<SE3>;

}  // namespace liesl
