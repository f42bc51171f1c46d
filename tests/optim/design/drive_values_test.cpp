/// @file
/// A value of the table of a drive and the duration, as variables of a design: derivatives of a
/// motion at every step, direct against adjoint and against differences.
#include "mbs/sensitivity/forms.hpp"
#include "optim/design/constants.hpp"

namespace liesl::test::drive_values_test {
namespace {

constexpr double kRate = 60;  // rad/s, on average

/// Nothing but the drive depends on time.
Mechanism machine(double E) {
  Mechanism m = sensitive_machine(E);
  m.loads.pop_back();
  return m;
}

/// The crank follows a table, at rest at first; one value of it and the duration are free.
StudySpec study(TimeFunction::Interpolation how, double seconds) {
  DriveTable table{0, {0, 0.2, 0.4, 0.6, 0.8, 1}, {0, 0, 0.25, 0.6, 1, 1}, how};
  for (double& t : table.t) t *= seconds;
  for (double& q : table.q) q *= kRate * seconds;
  StudySpec s;
  s.drives = {table};
  s.duration = seconds;
  ConstantSpec value, duration;
  value.name = "value of the drive";
  value.quantity = ConstantQuantity::DriveValue;
  value.drive = 0;
  value.row = 3;
  value.lower = table.q[2];
  value.upper = table.q[4];
  value.start = table.q[3];
  duration.name = "duration";
  duration.quantity = ConstantQuantity::Duration;
  duration.lower = seconds / 2;
  duration.upper = 2 * seconds;
  duration.start = seconds;
  s.constants = {value, duration};
  return s;
}

/// A design of both, and its motions.
template <class G>
struct Driven {
  const Mechanism mechanism;
  const SimulationOptions simulation;
  const Constants constants;
  VectorXd x;

  Driven(double E, TimeFunction::Interpolation how, const SimulationOptions& o)
      : mechanism(machine(E)), simulation(o), constants(study(how, o.duration), mechanism) {
    x.resize(constants.size());
    for (int i = 0; i < x.size(); ++i) x[i] = constants.variables()[std::size_t(i)].start;
  }
  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all;
    for (int i = 0; i < x.size(); ++i) all.push_back({x[i], {}, constants.parameter(i, x)});
    return all;
  }
  Taped<G> run(const VectorXd& at) const {
    Mechanism changed = mechanism;
    constants.apply(at, changed);
    return Taped<G>(changed, constants.simulation(simulation, at));
  }
};

template <class G>
class DriveVariables : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(DriveVariables, Groups);

constexpr TimeFunction::Interpolation kTables[] = {TimeFunction::Interpolation::Cubic,
                                                   TimeFunction::Interpolation::Quintic};

TYPED_TEST(DriveVariables, DirectEqualsAdjoint) {
  for (const auto how : kTables)
    for (const int steps : {10, 100, 1000}) {
      const Driven<TypeParam> driven(7e9, how, tight(2e-4 * steps, 2e-4));
      expect_direct_equals_adjoint(driven.run(driven.x), driven.quantities());
    }
}

TYPED_TEST(DriveVariables, EqualsDifferencesOfSimulations) {
  using G = TypeParam;
  for (const auto how : kTables) {
    const Driven<G> driven(7e8, how, tight(0.02, 4e-4));
    const Taped<G> run = driven.run(driven.x);
    const Outputs<G> outputs(run.model);
    expect_differences<G>(run, driven.quantities(), {}, [&](std::size_t p, double change) {
      VectorXd at = driven.x;
      at[Eigen::Index(p)] *= 1 + change;
      return recorded(driven.run(at), outputs);
    });
  }
}

}  // namespace
}  // namespace liesl::test::drive_values_test
