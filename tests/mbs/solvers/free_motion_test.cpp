/// @file
/// What nothing resists, whatever the size of the mechanism and however stiff it is.

#include "mbs/solvers/free_motion.hpp"

#include <array>

#include "mbs/run.hpp"
#include "mbs/solvers/static_newton.hpp"
#include "mbs/static_cases.hpp"
#include "reference/continuum.hpp"

namespace liesl::test::free_motion_test {
namespace {

/// A bar, 12 times as long as it is high, of a Young's modulus, in units of any size.
struct Scale {
  double size = 1, modulus = 1;
};
constexpr std::array kSizes = {1e-6, 1e-3, 1., 1e3, 1e6};
constexpr std::array kModuli = {1e-9, 1e-3, 1e6, 1e12, 1e21};

enum class Kind { Reduced, Continuum, Beam, ModalBeam };
constexpr std::array kKinds = {Kind::Reduced, Kind::Continuum, Kind::Beam, Kind::ModalBeam};

/// @param layers of cells through the depth; 0: planar
BodySpec bar(Kind kind, const Scale& of, int layers, const Vec3& from = Vec3::Zero()) {
  const Material material{"any", of.modulus, 0.3, 1};
  const Vec3 size = of.size * Vec3(12, 1, 1);
  if (kind == Kind::Reduced || kind == Kind::Continuum) {
    SolidSpec s = continuum_block(size, 12, 2, layers, material);
    s.frame.x = from;
    s.modes = 4;  // no multiple of 3 or 6: some amplitudes are padding
    if (kind == Kind::Reduced) s.as = SolidMotion::Reduced;
    return {"bar", s};
  }
  Section section;
  section.shape = Rectangle{size[1], size[2]};
  BeamSpec beam = straight_beam(from, from + size[0] * Vec3::UnitX(), 8, section, material);
  if (kind == Kind::ModalBeam) beam.as = BeamModel::Modal;
  return {"bar", beam};
}

Mechanism held_bar(Kind kind, const Scale& of, int layers, JointType joint = JointType::Fixed) {
  Mechanism m;
  m.gravity = {0, -1, 0};  // singles the plane out; without load there is none of it
  m.bodies = {bar(kind, of, layers)};
  m.joints = {{"joint", joint, {}, {0, 0}}};
  return m;
}

struct Found {
  int motions = 0;
  std::string told;
};

template <FrameGroup G>
Found found_on(const Mechanism& m) {
  const auto model = Model<G>::build(m, space_of<G>(m));
  State<G> s = model.initial_state();
  model.complete(s);
  StaticNewton<G> newton(model, tight());
  const Eigen::MatrixXd motions = free_motions(model, newton.tangent(s));
  const int count = static_cast<int>(motions.cols());
  EXPECT_TRUE(motions.allFinite());
  return {count, count > 0 ? describe_free_motion(model, s, motions) : ""};
}

Found found(const Mechanism& m, int layers) {
  return layers > 0 ? found_on<SE3>(m) : found_on<SE2>(m);
}

/// Calls f with every kind of bar of every size and stiffness, in the plane and in space.
template <class F>
void for_each_bar(const F& f) {
  for (const Kind kind : kKinds)
    for (const int layers : {0, 1})
      for (const double size : kSizes)
        for (const double modulus : kModuli) {
          SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", layers "
                                          << layers << ", size " << size << ", E " << modulus);
          f(kind, Scale{size, modulus}, layers);
        }
}

TEST(FreeMotion, AHeldPartIsHeldWhateverItsSizeAndStiffness) {
  for_each_bar([](Kind kind, const Scale& of, int layers) {
    const Found all = found(held_bar(kind, of, layers), layers);
    EXPECT_EQ(all.motions, 0) << all.told;
  });
}

TEST(FreeMotion, AHingeIsFoundWhateverTheSizeAndStiffness) {
  for_each_bar([](Kind kind, const Scale& of, int layers) {
    const Found all = found(held_bar(kind, of, layers, JointType::Revolute), layers);
    EXPECT_EQ(all.motions, 1);
    EXPECT_NE(all.told.find("'bar' can rotate about (0, 0, 1) through (0, 0, 0) at its node 0"),
              std::string::npos)
        << all.told;
  });
}

TEST(FreeMotion, AFreePartHasAllRigidMotions) {
  for_each_bar([](Kind kind, const Scale& of, int layers) {
    Mechanism m = held_bar(kind, of, layers);
    m.joints.clear();
    const Found all = found(m, layers);
    EXPECT_EQ(all.motions, layers > 0 ? 6 : 3);
    EXPECT_NE(all.told.find("'bar' can "), std::string::npos) << all.told;
    EXPECT_EQ(all.told.find("nan"), std::string::npos) << all.told;
  });
}

/// A soft part beside a stiff one: each is judged by its own stiffness.
TEST(FreeMotion, ASoftPartBesideAStiffOneIsHeldOrNot) {
  for (const Kind kind : kKinds)
    for (const int layers : {0, 1}) {
      SCOPED_TRACE(testing::Message()
                   << "kind " << static_cast<int>(kind) << ", layers " << layers);
      Mechanism m = held_bar(kind, {1, 1e12}, layers);
      m.bodies[0].name = "stiff";
      m.bodies.push_back(bar(kind, {1, 1e-6}, layers, {0, 20, 0}));
      m.joints.push_back({"other", JointType::Fixed, {}, {1, 0}});
      EXPECT_EQ(found(m, layers).motions, 0);
      m.joints[1].type = JointType::Revolute;
      const Found hinged = found(m, layers);
      EXPECT_EQ(hinged.motions, 1);
      EXPECT_NE(hinged.told.find("'bar' can rotate about (0, 0, 1) through (0, 20, 0)"),
                std::string::npos)
          << hinged.told;
    }
}

/// The scene that was said to rotate: a meshed plate, 40 m by 4 m by 5 m of steel.
TEST(FreeMotion, ALargeHeldPlateBendsAsABeam) {
  const double L = 40, h = 4, t = 5, E = 210e9, P = 1e6;
  Mechanism m;
  SolidSpec plate = continuum_block({L, h, t}, 80, 8, 0, {"steel", E, 0.3, 7850});
  plate.as = SolidMotion::Reduced;
  m.bodies = {{"plate", plate}};
  m.joints = {{"wall", JointType::Fixed, {}, {0, 0}}};
  LoadSpec load;
  load.name = "tip";
  load.port = {0, 1};
  load.force = {0, -P, 0};
  m.loads = {load};
  const auto solved = solve<SE2>(m, tight(), space_of<SE2>(m));
  ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
  const double I = t * h * h * h / 12, G = E / 2.6,
               beam = P * L * L * L / (3 * E * I) + P * L / (5. / 6 * G * t * h);
  EXPECT_NEAR(solved.frame(1).x.y(), -beam, 0.01 * beam);
}

}  // namespace
}  // namespace liesl::test::free_motion_test
