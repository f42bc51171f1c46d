/// @file
/// What every kind of design variables is asked for: numbers that fit each other, and parameters
/// that are the derivatives of what `apply` writes.
#include "optim/design/variable_group.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mbs/solids/volume_fraction.hpp"
#include "optim/design/design.hpp"
#include "optim/problems/mass_problem.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::variable_group_test {
namespace {

using Eigen::VectorXd;
using levelset::FeatureKind;

constexpr double kDuration = 0.1, kStep = 1e-3;

/// A slider-crank: the crank a beam, the rod a mesh with a hole, the slider rigid; a spring between
/// crank and ground.
Mechanism machine() {
  Mechanism m = slider_crank_with_mesh(40, 6, 3);
  std::get<SolidSpec>(m.bodies[1].kind).outline = {
      2,
      {{"bar", FeatureKind::HalfSpace, {2, 0, 0}, {}},
       {"hole", FeatureKind::Circle, {0.1, 0.0011, 0, 0.004}, {}},
       {"all", FeatureKind::Difference, {}, {"bar", "hole"}}}};
  m.bodies[0] = slider_crank().bodies[0];
  m.joints[1].a = {0, 8};
  ForceSpec spring;
  spring.name = "spring";
  spring.b = {0, 8};
  spring.stiffness = 30;
  spring.damping = 0.2;
  spring.rest = 0.1;
  m.forces = {spring};
  return m;
}

ConstantSpec constant(const char* name, ConstantQuantity quantity, double lower, double upper) {
  ConstantSpec c;
  c.name = name;
  c.quantity = quantity;
  c.lower = lower;
  c.upper = upper;
  return c;
}

/// All that may vary of the machine.
StudySpec study() {
  StudySpec s;
  DesignSpec diameters;
  diameters.name = "crank";
  diameters.bodies = {0};
  diameters.properties = {"diameter"};
  diameters.groups = 3;
  diameters.lower = 0.01;
  diameters.upper = 0.03;
  s.design = {diameters};
  s.shapes[1].variables = {{"x", {{"hole.x", 1}}, 0.05, 0.2, {}},
                           {"radius", {{"hole.radius", 1}}, 0.002, 0.0055, {}}};
  s.duration = kDuration;
  const DriveTable table{
      0, {0, 0.02, 0.05, kDuration}, {0, 1, 4, 6}, TimeFunction::Interpolation::Cubic};
  s.drives = {table};
  s.constants = {constant("stiffness", ConstantQuantity::Stiffness, 10, 100),
                 constant("damping", ConstantQuantity::Damping, 0.1, 1),
                 constant("rest", ConstantQuantity::Rest, 0, 0.2),
                 constant("mass", ConstantQuantity::Mass, 0.1, 1),
                 constant("angle", ConstantQuantity::DriveValue, 3, 5),
                 constant("duration", ConstantQuantity::Duration, 0.05, 0.2)};
  for (std::size_t i = 0; i < 3; ++i) s.constants[i].force = 0;
  s.constants[3].body = 2;
  s.constants[4].drive = 0;
  s.constants[4].row = 2;
  s.constants[4].start = 4;
  s.constants[5].start = kDuration;
  return s;
}

/// Instants of the drive, as shares of the duration.
constexpr double kShares[] = {0.1, 0.33, 0.71, 1};

/// Everything that a variable may change, one number after the other, and the same of a derivative.
struct Laws {
  std::vector<double> values;

  void add(const SectionLaw& law) {
    values.insert(values.end(), law.K.data(), law.K.data() + law.K.size());
    values.insert(values.end(), law.M.data(), law.M.data() + law.M.size());
  }
  void add(const VectorXd& v) { values.insert(values.end(), v.data(), v.data() + v.size()); }
  VectorXd vector() const {
    return VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  }
};

/// Of the mechanism with x and how it is simulated.
VectorXd laws(const VariableGroup& group, const Mechanism& mechanism, const VectorXd& x) {
  Mechanism m = mechanism;
  group.apply(x, m);
  SimulationOptions options;
  options.duration = kDuration;
  options.step = kStep;
  options = group.simulation(options, x);
  Laws out;
  const auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
  for (const Section& section : beam.sections) out.add(section_law(section, beam.material));
  out.add(solid_fractions(std::get<SolidSpec>(m.bodies[1].kind)).value);
  const ForceSpec& f = m.forces[0];
  out.values.insert(out.values.end(), {std::get<RigidSpec>(m.bodies[2].kind).mass, f.stiffness,
                                       f.damping, f.rest, std::log(options.step)});
  for (const double share : kShares)
    out.values.push_back(m.drives[0].motion(share * options.duration));
  return out.vector();
}

/// d(laws)/dp as a parameter tells it; what it does not name does not change.
struct Slopes {
  const Mechanism& designed;
  double duration;
  std::vector<SectionLaw> sections;
  VectorXd fractions;
  double mass = 0, step = 0;
  ForceDerivative force;
  VectorXd drive = VectorXd::Zero(std::size(kShares));

  Slopes(const Mechanism& m, double T) : designed(m), duration(T) {
    const SectionLaw none{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
    sections.assign(std::get<BeamSpec>(m.bodies[0].kind).sections.size(), none);
    fractions.setZero(std::get<SolidSpec>(m.bodies[1].kind).mesh().cell_count());
  }
  void operator()(const BeamDerivative& d) {
    ASSERT_EQ(d.body, 0);
    sections = d.laws;
  }
  void operator()(const SolidDerivative& d) {
    ASSERT_EQ(d.body, 1);
    fractions = d.fractions;
  }
  void operator()(const RigidDerivative& d) {
    ASSERT_EQ(d.body, 2);
    mass = d.mass;
  }
  void operator()(const ForceDerivative& d) {
    ASSERT_EQ(d.force, 0);
    force = d;
  }
  void operator()(const StepDerivative& d) { step = d.relative; }
  void operator()(const DriveDerivative& d) {
    ASSERT_EQ(d.drive, 0);
    for (std::size_t i = 0; i < std::size(kShares); ++i) {
      const double t = kShares[i] * duration;
      double sum = d.factor * designed.drives[0].motion(t);
      for (const WeightedFunction& w : d.motion) sum += w.weight * w.function(t);
      drive[static_cast<Eigen::Index>(i)] = sum;
    }
  }
  template <class Part>
  void operator()(const Part&) {
    FAIL() << "no variable of this study changes that";
  }
  VectorXd vector() const {
    Laws out;
    for (const SectionLaw& law : sections) out.add(law);
    out.add(fractions);
    out.values.insert(out.values.end(), {mass, force.stiffness, force.damping, force.rest, step});
    out.add(drive);
    return out.vector();
  }
};

/// A place between the bounds that is no start.
VectorXd inner(const std::vector<NlpVariable>& variables) {
  VectorXd x(static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const NlpVariable& v = variables[static_cast<std::size_t>(i)];
    x[i] = v.lower + (0.4 + 0.05 * static_cast<double>(i)) * (v.upper - v.lower);
  }
  return x;
}

TEST(VariableGroup, EveryKindHasAVariableAUnitAndAParameterForEach) {
  const Mechanism m = machine();
  const Design design(study(), m);
  ASSERT_EQ(design.groups().size(), 3u);
  const std::vector<std::vector<std::string>> units = {
      {"m", "m", "m"}, {"m", "m"}, {"N/m", "N s/m", "m", "kg", "m", "s"}};
  for (std::size_t g = 0; g < units.size(); ++g) {
    const VariableGroup& group = *design.groups()[g].group;
    EXPECT_EQ(group.units(), units[g]);
    ASSERT_EQ(group.variables().size(), units[g].size());
    ASSERT_EQ(group.size(), static_cast<int>(units[g].size()));
    const VectorXd x = inner(group.variables());
    Mechanism designed = m;
    group.apply(x, designed);
    const std::vector<Parameter> parameters = group.parameters(designed, x);
    ASSERT_EQ(parameters.size(), units[g].size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const NlpVariable& v = group.variables()[i];
      EXPECT_EQ(parameters[i].name, v.name);
      EXPECT_LE(v.lower, v.start) << v.name;
      EXPECT_LE(v.start, v.upper) << v.name;
    }
  }
}

/// By differences of fourth order, component by component; a fraction beside the largest slope of
/// all cells.
TEST(VariableGroup, ParametersAreTheDerivativesOfWhatIsApplied) {
  const Mechanism m = machine();
  const Design design(study(), m);
  for (const Design::Share& share : design.groups()) {
    const VariableGroup& group = *share.group;
    const VectorXd x = inner(group.variables());
    Mechanism designed = m;
    group.apply(x, designed);
    SimulationOptions options;
    options.duration = kDuration;
    const double duration = group.simulation(options, x).duration;
    const std::vector<Parameter> parameters = group.parameters(designed, x);
    const VectorXd at = laws(group, m, x);
    for (int i = 0; i < group.size(); ++i) {
      const NlpVariable& v = group.variables()[static_cast<std::size_t>(i)];
      const double h = 1e-6 * range_of(v);  // no cell is entered or left on the way
      const auto beside = [&](double steps) {
        VectorXd y = x;
        y[i] += steps * h;
        return laws(group, m, y);
      };
      const VectorXd slope = (8 * (beside(1) - beside(-1)) - (beside(2) - beside(-2))) / (12 * h);
      Slopes told(designed, duration);
      for (const auto& part : parameters[static_cast<std::size_t>(i)].parts) std::visit(told, part);
      const VectorXd by = told.vector();
      ASSERT_EQ(by.size(), slope.size());
      EXPECT_GT(by.norm(), 0) << v.name << " changes nothing";
      const double cells = told.fractions.lpNorm<Eigen::Infinity>();
      for (Eigen::Index k = 0; k < by.size(); ++k) {
        const double round_off = 1e-13 * std::abs(at[k]) / h;
        const double size = std::max(std::abs(by[k]), cells);
        ASSERT_NEAR(slope[k], by[k], 1e-6 * size + round_off) << v.name << ", number " << k;
      }
    }
  }
}

TEST(VariableGroup, ADesignIsItsGroupsSideBySide) {
  const Mechanism m = machine();
  const Design design(study(), m);
  const VectorXd x = inner(design.variables());
  const std::vector<Parameter> parameters = design.parameters(design.apply(m, x), x);
  ASSERT_EQ(parameters.size(), design.variables().size());
  ASSERT_EQ(design.units().size(), design.variables().size());
  int next = 0;
  const VectorXd unit = design.unit(x), start = design.start();
  for (const Design::Share& share : design.groups()) {
    EXPECT_EQ(share.first, next);
    for (int i = 0; i < share.group->size(); ++i, ++next) {
      const auto own = static_cast<std::size_t>(i), all = static_cast<std::size_t>(next);
      const NlpVariable& v = share.group->variables()[own];
      EXPECT_EQ(design.variables()[all].name, v.name);
      EXPECT_EQ(design.units()[all], share.group->units()[own]);
      EXPECT_EQ(parameters[all].name, v.name);
      EXPECT_EQ(start[next], v.start);
      EXPECT_EQ(unit[next], share.group->measured_by_range() ? v.upper - v.lower : x[next]);
    }
  }
  EXPECT_EQ(next, x.size());
  EXPECT_EQ(design.variables()[static_cast<std::size_t>(design.duration())].name, "duration");
  EXPECT_EQ(&design.sizing(), design.groups()[0].group.get());
  EXPECT_EQ(&design.part(0), design.groups()[1].group.get());
}

TEST(VariableGroup, MassFollowsTheParameters) {
  const Mechanism m = machine();
  const Design design(study(), m);
  const std::vector<int> bodies = {0, 1, 2};
  const VectorXd x = inner(design.variables());
  const auto mass = [&](const VectorXd& y) { return mass_of(design.apply(m, y), bodies); };
  const Mechanism designed = design.apply(m, x);
  const VectorXd by = mass_gradient(design.parameters(designed, x), designed, bodies);
  ASSERT_EQ(by.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const NlpVariable& v = design.variables()[static_cast<std::size_t>(i)];
    const VectorXd h = 1e-6 * range_of(v) * VectorXd::Unit(x.size(), i);
    const double slope = (mass(x + h) - mass(x - h)) / (2 * h[i]);
    EXPECT_NEAR(slope, by[i], 1e-6 * std::abs(by[i]) + 1e-13 / h[i]) << v.name;
  }
  const VectorXd none = mass_gradient(design.parameters(designed, x), designed, {});
  EXPECT_EQ(none.cwiseAbs().maxCoeff(), 0);
}

/// As before there was anything else.
TEST(VariableGroup, SectionsAloneAreMeasuredByTheSizeOfX) {
  StudySpec sections = study();
  sections.shapes.clear();
  sections.constants.clear();
  sections.drives.clear();
  const Design design(sections, machine());
  EXPECT_EQ(design.unit(design.start()).size(), 0);
  EXPECT_EQ(design.duration(), -1);
}

}  // namespace
}  // namespace liesl::test::variable_group_test
