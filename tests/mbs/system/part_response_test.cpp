/// @file
/// Stress and compliance of meshed parts in statics: against closed forms, the same responses of
/// beams, the work of the loads, and the static problem of the mesh.

#include "mbs/run.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/system/response_value.hpp"
#include "reference/continuum.hpp"

namespace liesl::test::part_response_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLength = 0.5, kHeight = 0.02, kWidth = 0.01, kE = 210e9;
constexpr double kArea = kHeight * kWidth, kI = kWidth * kHeight * kHeight * kHeight / 12;
constexpr int kRows = 4, kElements = 32;  // of cells over the height; of the beam

/// Of a bar along x without Poisson's effect, that its ends would hold back.
SolidSpec bar(SolidMotion as, int columns, int layers) {
  SolidSpec s =
      continuum_block({kLength, kHeight, kWidth}, columns, kRows, layers, {"steel", kE, 0, 7850});
  s.as = as;
  s.modes = 4;
  return s;
}

BeamSpec beam() {
  Section s;
  s.shape = Rectangle{kHeight, kWidth};  // width along y, in the plane
  s.shear_factor = {5. / 6, 5. / 6};
  return straight_beam({0, 0, 0}, {kLength, 0, 0}, kElements, s, {"steel", kE, 0, 7850});
}

/// Clamped at its start, a dead load at its end.
template <class Body>
Mechanism loaded(const Body& body, const Vec3& force, double moment) {
  Mechanism m;
  m.bodies = {{"bar", body}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  LoadSpec load;
  load.name = "load";
  load.port = {0, std::is_same_v<Body, BeamSpec> ? kElements : 1};
  load.force = force;
  load.moment = {0, 0, moment};
  m.loads = {load};
  return m;
}

struct Answer {
  double stress = 0, compliance = 0, work = 0;  ///< of the load: twice that, its ramp included
};

template <FrameGroup G>
Answer answer_on(const Mechanism& m) {
  const auto model = Model<G>::build(m, space_of<G>(m));
  const StaticResult<G> result = solve_static(model, tight());
  EXPECT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  State<G> s = model.initial_state();
  result.trajectory.read(result.trajectory.size() - 1, s);
  model.complete(s);
  const ResponseValues<G> values(m, model);
  const LoadSpec& load = m.loads[0];
  const auto value = [&](ResponseKind kind) -> VectorXd {
    ResponseSpec r;
    r.kind = kind;
    r.body = 0;
    r.at = load.port;
    r.in = Axes::Inertial;
    return values(r, s);
  };
  return {value(ResponseKind::Stress)[0], value(ResponseKind::Compliance)[0],
          value(ResponseKind::Displacement).dot(load.force) +
              value(ResponseKind::Rotation).dot(load.moment)};
}

/// Of planar meshes in the plane, else in space.
Answer answer(const Mechanism& m) {
  const auto* part = std::get_if<SolidSpec>(&m.bodies[0].kind);
  return part && part->mesh().dim == 2 ? answer_on<SE2>(m) : answer_on<SE3>(m);
}

struct Case {
  SolidMotion as;
  int layers;  ///< through the width; 0: planar
  std::string name() const {
    return std::string(as == SolidMotion::Reduced ? "reduced" : "continuum") +
           (layers > 0 ? "_in_space" : "_in_a_plane");
  }
};
const Case kCases[] = {{SolidMotion::Reduced, 0},
                       {SolidMotion::Reduced, 2},
                       {SolidMotion::Continuum, 0},
                       {SolidMotion::Continuum, 2}};

class PartResponse : public ::testing::TestWithParam<Case> {};

TEST_P(PartResponse, InTensionIsTheForceOverTheArea) {
  const double P = 1e3, strain = P / (kE * kArea);
  const Answer part = answer(loaded(bar(GetParam().as, 25, GetParam().layers), {P, 0, 0}, 0)),
               same = answer(loaded(beam(), {P, 0, 0}, 0));
  EXPECT_NEAR(part.stress / (P / kArea), 1, 1e-8);
  EXPECT_NEAR(part.stress / same.stress, 1, 1e-8);
  // A continuum has the energy of its Green-Lagrange strain.
  const double within = GetParam().as == SolidMotion::Reduced ? 1e-8 : 2 * strain;
  EXPECT_NEAR(part.compliance / (P * P * kLength / (kE * kArea)), 1, within);
  EXPECT_NEAR(part.compliance / part.work, 1, within);
  EXPECT_NEAR(part.compliance / same.compliance, 1, within);
}

/// Quadrilaterals and hexahedra with incompatible modes bend exactly: at the centres of the
/// outermost cells is what the outline has, less half a cell.
TEST_P(PartResponse, InBendingIsThatOfTheBeamAtTheCentresOfTheCells) {
  const double M = 1e-2, outline = M * kHeight / 2 / kI;
  const Answer part = answer(loaded(bar(GetParam().as, 25, GetParam().layers), {0, 0, 0}, M)),
               same = answer(loaded(beam(), {0, 0, 0}, M));
  EXPECT_NEAR(same.stress / outline, 1, 1e-5);
  EXPECT_NEAR(part.stress / same.stress, 1 - 1. / kRows, 1e-5);
  EXPECT_NEAR(part.compliance / part.work, 1, 1e-5);
  EXPECT_NEAR(part.compliance / (M * M * kLength / (kE * kI)), 1, 1e-5);
}

TEST_P(PartResponse, ComplianceIsTheWorkOfTheLoad) {
  const Vec3 force(0.03, 2e-3, 0);
  const double moment = 5e-4;
  const Answer part = answer(loaded(bar(GetParam().as, 50, GetParam().layers), force, moment)),
               same = answer(loaded(beam(), force, moment));
  EXPECT_NEAR(part.compliance / part.work, 1, 1e-5);
  EXPECT_NEAR(same.compliance / same.work, 1, 1e-5);
  EXPECT_NEAR(part.compliance / same.compliance, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Bars, PartResponse, ::testing::ValuesIn(kCases),
                         [](const auto& of) { return of.param.name(); });

/// A hole with cells that it cuts: the load on the reduced part is one on its interface, of which
/// its shapes have the static answer. The largest of the relaxed stresses, as results show them.
TEST(PartResponse, IsThatOfTheStaticProblemOfTheMesh) {
  for (const int layers : {0, 1}) {
    SolidSpec part = bar(SolidMotion::Reduced, 40, layers);
    cut_hole(part, 0.21, 0.001, 0.0063);
    const Vec3 force(0.03, 2e-4, 0);  // linear: what it pulls does not stiffen what it bends
    const double moment = 5e-5;
    const Answer found = answer(loaded(part, force, moment));
    const SolidModel& model = *part.model;
    const int dim = model.mesh().dim;
    SolidSupport support;
    fix_port(support, model, 0, dim == 2 ? "xyr" : "xyzr");
    SolidStatics statics(model, support, MatrixXd(model.size(), 0));
    VectorXd f = VectorXd::Zero(model.size());
    f.segment(model.port(1), 2) = force.head<2>();
    f[model.port(1) + model.rigid_count() - 1] = moment;
    statics.set_loads(f);
    const VectorXd v = solid_fractions(part).value;
    EXPECT_LT(v.minCoeff(), 0.9);
    ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
    const double largest = von_mises(statics, StressOptions().relaxation).maxCoeff();
    EXPECT_NEAR(found.stress / largest, 1, 1e-5) << dim;
    EXPECT_NEAR(found.compliance / statics.compliance()[0], 1, 1e-5) << dim;
  }
}

/// Parts that are simulated as rigid bodies have none.
TEST(PartResponse, OfARigidPartIsZero) {
  Mechanism m = loaded(bar(SolidMotion::Reduced, 10, 0), {1e3, 5, 0}, 0);
  m.formalism = Formalism::Rigid;
  EXPECT_TRUE(moves_rigidly(m.bodies[0], m.formalism));
  EXPECT_FALSE(moves_rigidly(m.bodies[0], Formalism::SE3));
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  const ResponseValues<SE2> values(m, model);
  for (const auto kind : {ResponseKind::Stress, ResponseKind::Compliance}) {
    ResponseSpec r;
    r.kind = kind;
    r.body = 0;
    EXPECT_EQ(values(r, model.initial_state())[0], 0) << name_of(kind);
    EXPECT_TRUE(values.gradient(r, model.initial_state())[0].nodes.empty()) << name_of(kind);
  }
}

}  // namespace
}  // namespace liesl::test::part_response_test
