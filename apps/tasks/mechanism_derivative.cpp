#include "apps/tasks/mechanism_derivative.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

bool same(const SE3& a, const SE3& b) { return a.R == b.R && a.x == b.x; }
bool same(const Port& a, const Port& b) {
  return a.body == b.body && a.node == b.node && same(a.offset, b.offset);
}
bool same_frames(const std::vector<SE3>& a, const std::vector<SE3>& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i) equal = same(a[i], b[i]);
  return equal;
}

/// The same features, whatever their numbers.
bool same_features(const levelset::ShapeSpec& a, const levelset::ShapeSpec& b) {
  return std::ranges::equal(a.features, b.features, [](const auto& x, const auto& y) {
    return x.name == y.name && x.kind == y.kind && x.operands == y.operands &&
           x.values.size() == y.values.size();
  });
}

/// Numbers of the outline, as the derivatives of its fractions are ordered.
Eigen::VectorXd outline_values(const SolidSpec& solid) {
  if (solid.outline.features.empty()) return {};
  return levelset::make_shape(solid.outline)->start();
}

/// The same cells, interfaces of the same nodes, the same law, an outline of the same features.
bool same_mesh(const SolidSpec& a, const SolidSpec& b) {
  const auto &x = a.mesh().cells, &y = b.mesh().cells;
  bool equal = a.as == b.as && a.law == b.law && a.modes == b.modes &&
               a.mesh().node_count() == b.mesh().node_count() && x.rows() == y.rows() &&
               x.cols() == y.cols() && x == y && a.interfaces().size() == b.interfaces().size() &&
               same_features(a.outline, b.outline);
  for (std::size_t i = 0; equal && i < a.interfaces().size(); ++i)
    equal = a.interfaces()[i].nodes == b.interfaces()[i].nodes &&
            a.interfaces()[i].tie == b.interfaces()[i].tie;
  return equal;
}

bool same_places(const SolidSpec& a, const SolidSpec& b) {
  bool equal = same(a.frame, b.frame) && a.mesh().nodes == b.mesh().nodes;
  for (std::size_t i = 0; equal && i < a.interfaces().size(); ++i)
    equal = a.interfaces()[i].point == b.interfaces()[i].point;
  return equal;
}

bool same_nu(const SolidSpec& a, const SolidSpec& b) {
  return a.model->material().nu == b.model->material().nu;
}

bool same_ersatz(const SolidSpec& a, const SolidSpec& b) {
  const ErsatzLaw &x = a.model->law(), &y = b.model->law();
  return x.exponent == y.exponent && x.ratio == y.ratio;
}

bool same_kind(const BodySpec& a, const BodySpec& b) {
  if (a.kind.index() != b.kind.index()) return false;
  if (const auto* solid = std::get_if<SolidSpec>(&a.kind))
    return same_mesh(*solid, std::get<SolidSpec>(b.kind));
  const auto* beam = std::get_if<BeamSpec>(&a.kind);
  if (!beam) return true;
  const auto& other = std::get<BeamSpec>(b.kind);
  bool equal = beam->nodes.size() == other.nodes.size() && beam->as == other.as &&
               beam->modes == other.modes && beam->order == other.order &&
               beam->ends.size() == other.ends.size() &&
               beam->sections.size() == other.sections.size();
  for (std::size_t e = 0; equal && e < beam->sections.size(); ++e)
    equal = beam->sections[e].shape.index() == other.sections[e].shape.index();
  return equal;
}

/// All of a section but its dimensions.
bool same_constants(const Section& a, const Section& b) {
  const auto* full = std::get_if<FullSection>(&a.shape);
  const auto* other = std::get_if<FullSection>(&b.shape);
  return a.shear_factor == b.shear_factor && a.torsion_constant == b.torsion_constant &&
         (!full || (full->stiffness == other->stiffness && full->inertia == other->inertia));
}

/// @param factors in the middle of the elements, at their first and last nodes
BeamDerivative scaled(BeamDerivative part, const std::array<double, 3>& factors) {
  const auto scale = [](SectionLaw& law, double factor) {
    law.K *= factor;
    law.M *= factor;
  };
  for (auto& law : part.laws) scale(law, factors[0]);
  for (auto& ends : part.ends)
    for (std::size_t k = 0; k < 2; ++k) scale(ends[k], factors[k + 1]);
  for (auto& element : part.stress)
    for (std::size_t i = 0; i < element.size(); ++i)
      element[i] *= factors[2 * i < element.size() ? 1 : 2];
  return part;
}

/// Do both act on the same, along the same curve?
bool acts_alike(const ForceSpec& a, const ForceSpec& b) {
  const auto alike = [](const CoordinateShare& x, const CoordinateShare& y) {
    return x.coordinate == y.coordinate && x.weight == y.weight;
  };
  return same(a.a, b.a) && same(a.b, b.b) && a.curve == b.curve && a.joint == b.joint &&
         a.coordinate == b.coordinate && std::ranges::equal(a.shares, b.shares, alike);
}

/// Adds the derivative by an outline whose numbers change by `by_values`.
/// @throws std::invalid_argument if its material or thickness changes, too
void add_outline(const SolidScale& scale, const SolidSpec& solid, const Eigen::VectorXd& by_values,
                 const std::string& name, Parameter& p) {
  if (by_values.isZero(0)) return;
  if (scale.E != 0 || scale.rho != 0 || scale.thickness != 0)
    throw std::invalid_argument("material or thickness and outline of the meshed body '" + name +
                                "' change together, of which there is no derivative: each is a "
                                "parameter of its own");
  p.parts.push_back(SolidDerivative{scale.body, solid_fractions(solid).derivative * by_values});
}

/// Weights of penalties have a derivative of their own only.
void refuse_weights(const Parameter& p) {
  for (const auto& part : p.parts)
    if (std::holds_alternative<PenaltyDerivative>(part))
      throw std::invalid_argument(
          "weights of penalties change together with geometry, of which "
          "there is no derivative: each is a parameter of its own");
}

bool acts_alike(const LoadSpec& a, const LoadSpec& b) {
  return same(a.port, b.port) && a.follower == b.follower;
}

bool same_places(const RigidSpec& a, const RigidSpec& b) {
  return same(a.frame, b.frame) && a.points == b.points;
}

bool same_places_and_axes(const JointSpec& a, const JointSpec& b) {
  return same(a.a, b.a) && same(a.b, b.b) && a.axis == b.axis && a.axis2 == b.axis2 &&
         a.pitch == b.pitch;
}

class Differences {
 public:
  Differences(const Mechanism& at, const std::function<Mechanism(double)>& changed, double step,
              const SimulationOptions& simulation)
      : at_(at),
        mechanisms_{std::make_shared<const std::array<Mechanism, 4>>(std::array{
                        changed(-2 * step), changed(-step), changed(step), changed(2 * step)}),
                    step},
        perturbed_(*mechanisms_.at),
        step_(step),
        simulation_(simulation) {}

  Parameter parameter(const std::string& name) {
    require_structure();
    Parameter p{name, {}};
    add_data(p);
    if (beyond_data_) {
      refuse_weights(p);
      p.parts = {mechanisms_};
    }
    if (p.parts.empty())
      throw std::invalid_argument(
          fmt::format("'{}' changes nothing that has a derivative: geometry, sections, materials, "
                      "masses, springs, loads, drives or weights of penalties",
                      name));
    return p;
  }

 private:
  /// What has derivatives of its own; `beyond_data_` becomes true if that is not all that changes.
  void add_data(Parameter& p) {
    differs_unless([&](const Mechanism& m) { return m.gravity == at_.gravity; });
    if (!function([](const Mechanism& m) { return m.gravity_scale; }).empty()) beyond_data_ = true;
    for (std::size_t i = 0; i < at_.gears.size(); ++i)
      differs_unless([&](const Mechanism& m) { return m.gears[i].ratio == at_.gears[i].ratio; });
    for (std::size_t b = 0; b < at_.bodies.size(); ++b) add_body(static_cast<int>(b), p);
    differs_unless([&](const Mechanism& m) {
      return std::ranges::equal(m.joints, at_.joints, same_places_and_axes);
    });
    for (std::size_t i = 0; i < at_.drives.size(); ++i) add_drive(i, p);
    for (std::size_t i = 0; i < at_.forces.size(); ++i) add_force(i, p);
    for (std::size_t i = 0; i < at_.loads.size(); ++i) add_load(i, p);
    add_penalty(p);
  }

  /// The same unknowns at all values: numbers and kinds of everything.
  void require_structure() const {
    require("the number of bodies, joints, drives, springs, loads or gears",
            [&](const Mechanism& m) {
              return m.bodies.size() == at_.bodies.size() && m.joints.size() == at_.joints.size() &&
                     m.drives.size() == at_.drives.size() && m.forces.size() == at_.forces.size() &&
                     m.loads.size() == at_.loads.size() && m.gears.size() == at_.gears.size();
            });
    for (std::size_t j = 0; j < at_.joints.size(); ++j)
      require("the kind of joint '" + at_.joints[j].name + "'",
              [&](const Mechanism& m) { return m.joints[j].type == at_.joints[j].type; });
    for (std::size_t b = 0; b < at_.bodies.size(); ++b)
      require("the kind of body '" + at_.bodies[b].name + "', its elements, sections or modes",
              [&](const Mechanism& m) { return same_kind(m.bodies[b], at_.bodies[b]); });
  }

  /// Exactly zero for what does not change.
  template <class Get>
  auto difference(Get get) const {
    auto by_p = get(at_);
    by_p = ((get(perturbed_[2]) - get(perturbed_[1])) * 8 -
            (get(perturbed_[3]) - get(perturbed_[0]))) /
           (12 * step_);
    return by_p;
  }
  template <class Equal>
  void require(const std::string& what, Equal equal) const {
    for (const Mechanism& m : perturbed_)
      if (!equal(m))
        throw std::invalid_argument(what +
                                    " changes, of which there is no derivative: parameters are "
                                    "geometry, sections, materials, masses and inertias, springs, "
                                    "dampers, loads and drives");
  }
  template <class Equal>
  void differs_unless(Equal equal) {
    for (const Mechanism& m : perturbed_) beyond_data_ = beyond_data_ || !equal(m);
  }

  /// d/dp of a function of time; none if it does not change at any step of the simulation.
  template <class Get>
  FunctionDerivative function(Get get) const {
    FunctionDerivative by_p;
    for (std::size_t i = 0; i < perturbed_.size(); ++i)
      by_p.push_back({mechanisms_.weight(i), get(perturbed_[i])});
    const long steps = std::lround(std::ceil(simulation_.duration / simulation_.step));
    for (long n = 0; n <= steps; ++n) {
      const double t = static_cast<double>(n) * simulation_.step;
      for (const WeightedFunction& f : by_p)
        if (f.function(t) != get(at_)(t)) return by_p;
    }
    return {};
  }

  void add_body(int b, Parameter& p) {
    const auto of = [b](const Mechanism& m) -> const BodySpec& {
      return m.bodies[static_cast<std::size_t>(b)];
    };
    differs_unless([&](const Mechanism& m) {
      return of(m).velocity == of(at_).velocity &&
             of(m).angular_velocity == of(at_).angular_velocity;
    });
    if (std::holds_alternative<BeamSpec>(of(at_).kind)) add_beam(b, p);
    if (std::holds_alternative<RigidSpec>(of(at_).kind)) add_rigid(b, p);
    if (std::holds_alternative<SolidSpec>(of(at_).kind)) add_solid(b, p);
  }

  void add_beam(int b, Parameter& p) {
    const auto of = [b](const Mechanism& m) -> const BeamSpec& {
      return std::get<BeamSpec>(m.bodies[static_cast<std::size_t>(b)].kind);
    };
    const BeamSpec& beam = of(at_);
    differs_unless([&](const Mechanism& m) {
      const BeamSpec& other = of(m);
      return same_frames(other.nodes, beam.nodes) && other.material.nu == beam.material.nu &&
             other.damping == beam.damping;
    });
    BeamDerivative sum;
    bool depends = false;
    const auto take = [&](const std::array<double, 3>& by_p, auto law) {
      if (by_p == std::array{0., 0., 0.}) return;
      if (depends)
        sum += scaled(law(), by_p);
      else
        sum = scaled(law(), by_p);
      depends = true;
    };
    const int elements = static_cast<int>(beam.sections.size());
    for (int e = 0; e < elements; ++e) {
      const auto section = [&](const Mechanism& m) -> const Section& {
        return of(m).sections[static_cast<std::size_t>(e)];
      };
      differs_unless([&](const Mechanism& m) { return same_constants(section(m), section(at_)); });
      for (const auto dimension_name : dimensions(section(at_).shape)) {
        std::array<double, 3> by_p;
        for (std::size_t k = 0; k < 3; ++k)
          by_p[k] = difference([&](const Mechanism& m) {
            constexpr std::array places = {ElementPlace::Middle, ElementPlace::First,
                                           ElementPlace::Last};
            return dimension(section_at(of(m), static_cast<std::size_t>(e), places[k]).shape,
                             dimension_name);
          });
        take(by_p, [&] { return by_dimension(at_, b, {e}, dimension_name); });
      }
    }
    const auto material = [&](double Material::*constant) {
      const double by_p = difference([&](const Mechanism& m) { return of(m).material.*constant; });
      return std::array{by_p, by_p, by_p};
    };
    take(material(&Material::E), [&] { return by_youngs_modulus(at_, b); });
    take(material(&Material::rho), [&] { return by_density(at_, b); });
    if (depends) p.parts.push_back(std::move(sum));
  }

  void add_rigid(int b, Parameter& p) {
    const auto of = [b](const Mechanism& m) -> const RigidSpec& {
      return std::get<RigidSpec>(m.bodies[static_cast<std::size_t>(b)].kind);
    };
    differs_unless([&](const Mechanism& m) { return same_places(of(m), of(at_)); });
    RigidDerivative by_p;
    by_p.body = b;
    by_p.mass = difference([&](const Mechanism& m) { return of(m).mass; });
    by_p.centre = difference([&](const Mechanism& m) { return Vec3(of(m).centre); });
    by_p.inertia = difference([&](const Mechanism& m) { return Mat3(of(m).inertia); });
    if (by_p.mass != 0 || !by_p.centre.isZero(0) || !by_p.inertia.isZero(0))
      p.parts.push_back(by_p);
  }

  /// E, rho and the thickness scale the matrices, numbers of the outline change the fractions of
  /// cells, which the modes of a reduced part follow; they follow nothing else.
  void add_solid(int b, Parameter& p) {
    const auto of = [b](const Mechanism& m) -> const SolidSpec& {
      return std::get<SolidSpec>(m.bodies[static_cast<std::size_t>(b)].kind);
    };
    const SolidSpec& solid = of(at_);
    if (solid.as == SolidMotion::Reduced)
      require("Poisson's ratio, mesh or ersatz law of the meshed body '" +
                  at_.bodies[static_cast<std::size_t>(b)].name + "'",
              [&](const Mechanism& m) {
                return same_nu(of(m), solid) && of(m).mesh().nodes == solid.mesh().nodes &&
                       same_ersatz(of(m), solid);
              });
    differs_unless([&](const Mechanism& m) {
      return same_nu(of(m), solid) && same_places(of(m), solid) && same_ersatz(of(m), solid) &&
             of(m).damping == solid.damping;
    });
    const auto relative = [&](auto get) {
      const double by_p = difference([&](const Mechanism& m) { return get(*of(m).model); });
      return by_p == 0 ? 0 : by_p / get(*solid.model);
    };
    const SolidScale by_p{b, relative([](const SolidModel& m) { return m.material().E; }),
                          relative([](const SolidModel& m) { return m.material().rho; }),
                          relative([](const SolidModel& m) { return m.thickness(); })};
    if (by_p.E != 0 || by_p.rho != 0 || by_p.thickness != 0) p.parts.push_back(by_p);
    const Eigen::VectorXd by_values =
        difference([&](const Mechanism& m) { return outline_values(of(m)); });
    add_outline(by_p, solid, by_values, at_.bodies[static_cast<std::size_t>(b)].name, p);
  }

  void add_drive(std::size_t i, Parameter& p) const {
    DriveDerivative by_p{static_cast<int>(i), 0,
                         function([i](const Mechanism& m) { return m.drives[i].motion; })};
    if (!by_p.motion.empty()) p.parts.push_back(std::move(by_p));
  }

  void add_force(std::size_t i, Parameter& p) {
    differs_unless([&](const Mechanism& m) { return acts_alike(m.forces[i], at_.forces[i]); });
    ForceDerivative by_p;
    by_p.force = static_cast<int>(i);
    by_p.stiffness = difference([i](const Mechanism& m) { return m.forces[i].stiffness; });
    by_p.damping = difference([i](const Mechanism& m) { return m.forces[i].damping; });
    by_p.rest = difference([i](const Mechanism& m) { return m.forces[i].rest; });
    by_p.function = function([i](const Mechanism& m) { return m.forces[i].force; });
    if (by_p.stiffness != 0 || by_p.damping != 0 || by_p.rest != 0 || !by_p.function.empty())
      p.parts.push_back(std::move(by_p));
  }

  void add_load(std::size_t i, Parameter& p) {
    differs_unless([&](const Mechanism& m) { return acts_alike(m.loads[i], at_.loads[i]); });
    LoadDerivative by_p;
    by_p.load = static_cast<int>(i);
    by_p.factor = 0;
    by_p.force = difference([i](const Mechanism& m) { return Vec3(m.loads[i].force); });
    by_p.moment = difference([i](const Mechanism& m) { return Vec3(m.loads[i].moment); });
    by_p.scale = function([i](const Mechanism& m) { return m.loads[i].scale; });
    if (!by_p.force.isZero(0) || !by_p.moment.isZero(0) || !by_p.scale.empty())
      p.parts.push_back(std::move(by_p));
  }

  void add_penalty(Parameter& p) const {
    require("the damping of penalties",
            [&](const Mechanism& m) { return m.penalty.damping == at_.penalty.damping; });
    const PenaltyDerivative by_p{
        difference([](const Mechanism& m) { return m.penalty.displacement; }),
        difference([](const Mechanism& m) { return m.penalty.rotation; })};
    if (by_p.displacement != 0 || by_p.rotation != 0) p.parts.push_back(by_p);
  }

  const Mechanism& at_;
  const NearbyMechanisms mechanisms_;
  const std::array<Mechanism, 4>& perturbed_;
  const double step_;
  const SimulationOptions& simulation_;
  bool beyond_data_ = false;
};

}  // namespace

Parameter parameter_of(const std::string& name, const Mechanism& at,
                       const std::function<Mechanism(double)>& changed, double step,
                       const SimulationOptions& simulation) {
  return Differences(at, changed, step, simulation).parameter(name);
}

}  // namespace liesl
