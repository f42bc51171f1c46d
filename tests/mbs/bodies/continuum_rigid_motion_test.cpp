/// @file
/// Meshed parts whose nodes all move do not see rigid motions: no stress, no forces, of every kind
/// of cells and both laws, as placed, in equilibrium and in motion.

#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/driven_block.hpp"
#include "mbs/solids/meshes.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/static_cases.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_rigid_motion_test {
namespace {

using Eigen::VectorXd;

/// Stress of what is at rest, over Young's modulus.
constexpr double kNone = 1e-12;

/// A kind of cells, with edges bent or not.
struct CellsOf {
  int dim, nodes;
  bool bent = false;
};

class ContinuumRigidMotion : public ::testing::TestWithParam<CellsOf> {
 protected:
  static SolidSpec part(SolidLaw law, Tie tie) {
    const auto [dim, nodes, bent] = GetParam();
    const SolidMesh straight = distorted(cell_kind(dim, nodes));
    const Vec3 middle(0, 0.5, dim == 3 ? 0.5 : 0);
    SolidSpec s;
    s.model = mesh_with_ends(bent ? with_bent_edges(straight) : straight, kSoftBlock, middle,
                             middle + 2 * Vec3::UnitX(), {0.1, {}});
    s.model = with_ties(*s.model, tie);
    s.as = SolidMotion::Continuum;
    s.law = law;
    return s;
  }
  /// Calls f with each law and each of the kinds of interfaces.
  template <class F>
  static void for_each_part(std::initializer_list<Tie> ties, const F& f) {
    for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
      for (const Tie tie : ties) {
        SCOPED_TRACE(std::string(to_string(law)) + (tie == Tie::Rigid ? ", rigid" : ", averaged"));
        f(part(law, tie));
      }
  }
  /// Calls f with the group of the cells' space.
  template <class F>
  static void in_its_space(const F& f) {
    if (GetParam().dim == 2)
      f(SE2::identity());
    else
      f(SE3::identity());
  }
};

class ContinuumRigidMotionSlow : public ContinuumRigidMotion {};

/// Largest stress of all cells, over Young's modulus.
template <FrameGroup G>
double stress_of(const Body<G>& of, const G* H) {
  const auto& body = *ContinuumBody<G>::of(of);
  typename ContinuumBody<G>::Points x;
  body.positions(H, x);
  return body.stresses_at(x).cwiseAbs().maxCoeff() / kSoftBlock.E;
}

/// Largest distance of a node from where the rigid motion of the first port takes it, m.
template <FrameGroup G>
double off_rigid(const Body<G>& of, const G* H) {
  const auto& body = *ContinuumBody<G>::of(of);
  typename ContinuumBody<G>::Points x, rest;
  body.positions(H, x);
  body.positions(body.reference.data(), rest);
  const G motion = H[0] * body.reference[0].inverse();
  double off = 0;
  for (int i = 0; i < x.cols(); ++i)
    off = std::max(off, (x.col(i) - motion.R * rest.col(i) - motion.x).norm());
  return off;
}

/// Far from where it was, turned by more than a right angle.
template <FrameGroup G>
G far_away() {
  typename G::Tangent h;
  for (int i = 0; i < G::dim; ++i) h[i] = i < G::space_dim ? 4 - 3 * i : 2.1 - 0.7 * i;
  return G::exp(h);
}

TEST_P(ContinuumRigidMotion, AsPlacedThereIsNoStress) {
  in_its_space([](auto group) {
    using G = decltype(group);
    for_each_part({Tie::Rigid, Tie::Averaged}, [](const SolidSpec& part) {
      Mechanism m;
      m.bodies = {{"part", part}};
      const auto model = Model<G>::build(m, space_of<G>(m));
      State<G> at = model.initial_state();
      for (auto& H : at.H) H = far_away<G>() * H;
      EXPECT_LT(stress_of<G>(*model.bodies[0], at.H.data()), kNone);
      VectorXd r = VectorXd::Zero(model.size());
      ForceScale scale;
      model.bodies[0]->add_internal(model.body_state(at, 0), r.data(), scale);
      EXPECT_LT(r.norm(), kNone * model.bodies[0]->axial_stiffness());
      at.H.back().x[0] += 1e-6;
      EXPECT_GT(stress_of<G>(*model.bodies[0], at.H.data()), 1e-7) << "stress is seen";
    });
  });
}

/// A drive turns it at once; nothing else holds or loads it.
TEST_P(ContinuumRigidMotionSlow, TurnedByADriveItIsInEquilibriumWithoutStress) {
  in_its_space([](auto group) {
    using G = decltype(group);
    for_each_part({Tie::Rigid, Tie::Averaged}, [](const SolidSpec& part) {
      Mechanism m = clamped(part);
      m.joints[0].type = JointType::Revolute;
      m.drives = {{0, 0, TimeFunction::expression("2.1*t")}};
      SimulationOptions o = tight();
      o.at = 1;
      o.max_iterations = 40;
      const auto model = Model<G>::build(m, space_of<G>(m));
      const auto found = solve_static(model, o);
      ASSERT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
      const G* H = found.trajectory.frames(found.trajectory.size() - 1);
      EXPECT_NEAR(H[0].R(0, 0), std::cos(2.1), 1e-9);
      EXPECT_LT(stress_of<G>(*model.bodies[0], H), kNone);
      EXPECT_LT(off_rigid<G>(*model.bodies[0], H), 1e-12);
    });
  });
}

/// Largest stress of all records, over Young's modulus.
template <FrameGroup G>
double largest_stress(const Run<G>& r) {
  double stress = 0;
  for (int i = 0; i <= r.last(); ++i)
    stress = std::max(stress, stress_of<G>(*r.model->bodies[0], r.trajectory().frames(i)));
  return stress;
}

/// It flies under its weight. (The port of an averaged interface has inertia, a thousandth of that
/// of its nodes, and weighs nothing: in a fall it strains them.)
TEST_P(ContinuumRigidMotion, ThrownItHasNoStress) {
  in_its_space([](auto group) {
    using G = decltype(group);
    for_each_part({Tie::Rigid}, [](SolidSpec part) {
      const double z = G::space_dim == 3 ? 1 : 0;
      part.frame = SE3(SO3::exp({z, 0.5 * z, 1.9}).R, {3, -2, z});
      Mechanism m;
      m.bodies = {{"part", part, {5, 7, 2 * z}}};
      m.gravity = {1, -9.81, 3 * z};
      const auto r = run<G>(m, space_of<G>(m), options(0.5, 0.05, 0.8, 1e-9));
      ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      EXPECT_GT((r.trajectory().frames(r.last())[0].x - r.trajectory().frames(0)[0].x).norm(), 3);
      EXPECT_LT(largest_stress(r), kNone);
    });
  });
}

/// Swung by a drive about an axis 3 m away, of a density with which centrifugal stress is less than
/// what counts as none: rho (omega r)^2 = 1e-14 E.
TEST_P(ContinuumRigidMotionSlow, SwungWithoutMassItHasNoStress) {
  in_its_space([](auto group) {
    using G = decltype(group);
    for_each_part({Tie::Rigid}, [](SolidSpec part) {
      Material light = kSoftBlock;
      light.rho = 1e-11;
      part.model = of_material(*part.model, light);
      Mechanism m;
      m.bodies = {{"part", part}};
      const Port hub{0, 0, SE3(Mat3::Identity(), {-3, 0, 0})};
      const Vec3 at = part.interfaces()[0].point - 3 * Vec3::UnitX();
      m.joints = {{"motor", JointType::Revolute, {-1, 0, SE3(Mat3::Identity(), at)}, hub}};
      m.drives = {{0, 0, TimeFunction::rate(8, 0.1)}};
      const auto r = run<G>(m, space_of<G>(m), options(0.4, 0.02, 0.8, 1e-9));
      ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      EXPECT_NEAR(r.trajectory().frames(r.last())[0].R(0, 0), std::cos(2.8), 1e-6);
      EXPECT_LT(largest_stress(r), kNone);
    });
  });
}

/// Tetrahedra of 10 nodes have a quadrature for straight edges.
const auto kCells = ::testing::Values(
    CellsOf{2, 3}, CellsOf{2, 4}, CellsOf{2, 6}, CellsOf{2, 8}, CellsOf{3, 4}, CellsOf{3, 8},
    CellsOf{3, 10}, CellsOf{3, 20}, CellsOf{2, 6, true}, CellsOf{2, 8, true}, CellsOf{3, 20, true});
std::string name_of(const ::testing::TestParamInfo<CellsOf>& info) {
  return "Of" + std::to_string(info.param.nodes) + "NodesIn" + std::to_string(info.param.dim) +
         "D" + (info.param.bent ? "Bent" : "");
}
INSTANTIATE_TEST_SUITE_P(Cells, ContinuumRigidMotion, kCells, name_of);
INSTANTIATE_TEST_SUITE_P(Cells, ContinuumRigidMotionSlow, kCells, name_of);

}  // namespace
}  // namespace liesl::test::continuum_rigid_motion_test
