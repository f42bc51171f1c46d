/// @file
/// Joints: number of rows, coordinates and reactions, in space and in the plane.

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mbs/run.hpp"

namespace liesl::test::joints_test {
namespace {

struct Expected {
  JointType type;
  int constraints, coordinates;
};

Mechanism one_joint(JointType type, const Vec3& axis, const Vec3& axis2) {
  Mechanism m;
  m.bodies = {{"block", test::block({0.3, 0.1, 0}, 2, 0.1)}};
  JointSpec j{"joint", type, {}, {0, 0}, axis, axis2};
  if (kind_of(type).pitch) j.pitch = 0.2;
  m.joints = {j};
  return m;
}

template <class G>
int coordinates(const Model<G>& model) {
  int n = 0;
  for (const auto& e : model.couplings[0].rows) n += e.coordinate >= 0;
  return n;
}

/// Rank of the constraint gradients of joint 0 with respect to port b.
template <class G>
int rank(const Model<G>& model, const RelativeMotion<G>& motion) {
  Eigen::MatrixXd B(model.couplings[0].constraints, G::dim);
  for (int i = 0; i < B.rows(); ++i) {
    typename Row<G>::Gradient g;
    model.couplings[0].rows[std::size_t(i)].row.gradient(motion, g);
    B.row(i) = g.template tail<G::dim>().transpose();
  }
  return int(Eigen::FullPivLU<Eigen::MatrixXd>(B).rank());
}

TEST(Joints, RowsInSpace) {
  for (const auto& e : std::initializer_list<Expected>{{JointType::Fixed, 6, 0},
                                                       {JointType::Revolute, 5, 1},
                                                       {JointType::Prismatic, 5, 1},
                                                       {JointType::Cylindrical, 4, 2},
                                                       {JointType::Spherical, 3, 0},
                                                       {JointType::Universal, 4, 2},
                                                       {JointType::Planar, 3, 3},
                                                       {JointType::Screw, 5, 1}}) {
    const Mat3 R = test::oblique().R;
    const auto m = one_joint(e.type, R.col(2), R.col(0));
    const auto model = Model<SE3>::build(m, {});
    EXPECT_EQ(model.constraints(), e.constraints) << int(e.type);
    EXPECT_EQ(coordinates(model), e.coordinates) << int(e.type);
    EXPECT_EQ(rank(model, {SE3::identity(), SE3::identity()}), e.constraints) << int(e.type);
  }
}

/// The table is in the order of the types; rows and coordinates make up six motions.
TEST(Joints, TableIsComplete) {
  for (std::size_t i = 0; i < joint_kinds().size(); ++i) {
    const JointKind& kind = joint_kinds()[i];
    EXPECT_EQ(std::size_t(kind.type), i);
    EXPECT_EQ(&kind_of(kind.type), &kind);
    const std::size_t named = kind.type == JointType::Spherical ? 3  // not by coordinates
                              : kind.acts_on_distance()         ? 5
                                                                : 0;
    EXPECT_EQ(kind.constraints.size() + kind.coordinates.size() + named, 6u) << kind.name;
  }
}

TEST(Joints, CoordinatesHaveTheirUnits) {
  const auto units = [](JointType type) {
    std::string all;
    for (int i = 0; i < kind_of(type).coordinate_count(); ++i)
      all += std::string(kind_of(type).unit(i)) + " ";
    return all;
  };
  EXPECT_EQ(units(JointType::Fixed), "");
  EXPECT_EQ(units(JointType::Revolute), "rad ");
  EXPECT_EQ(units(JointType::Prismatic), "m ");
  EXPECT_EQ(units(JointType::Cylindrical), "m rad ");
  EXPECT_EQ(units(JointType::Spherical), "");
  EXPECT_EQ(units(JointType::Universal), "rad rad ");
  EXPECT_EQ(units(JointType::Planar), "m m rad ");
  EXPECT_EQ(units(JointType::Screw), "rad ");
  EXPECT_EQ(units(JointType::Rod), "");
  EXPECT_EQ(units(JointType::Cylinder), "m ");
  EXPECT_EQ(units(JointType::Bushing), "m m m rad rad rad ");
}

/// A displacement splits into what the joint allows and what it holds.
TEST(Joints, FreePartOfADisplacement) {
  const Vec3 axis = test::oblique().R.col(0), d(0.3, -0.2, 0.5), along = axis * axis.dot(d);
  const auto free = [&](JointType type) { return kind_of(type).free_part(axis, d); };
  for (const auto type :
       {JointType::Fixed, JointType::Revolute, JointType::Spherical, JointType::Universal})
    EXPECT_EQ(free(type), Vec3(Vec3::Zero())) << kind_of(type).name;
  for (const auto type : {JointType::Prismatic, JointType::Cylindrical, JointType::Screw})
    EXPECT_LT((free(type) - along).norm(), 1e-15) << kind_of(type).name;
  EXPECT_LT((free(JointType::Planar) - (d - along)).norm(), 1e-15);
  for (const auto type : {JointType::Rod, JointType::Cylinder, JointType::Bushing})
    EXPECT_EQ(free(type), d) << kind_of(type).name;
}

/// In a plane oblique to the axes of the scene, joints without an axis have as many rows as in any.
TEST(Joints, WithoutAxisInAnObliquePlane) {
  Space<SE2> plane;
  for (const double tilt : {0.0, 0.3, 0.7, 0.8, 1.2, M_PI / 2}) {
    plane.frame.R = Eigen::AngleAxisd(tilt, Vec3(1, 2, 0).normalized()).toRotationMatrix();
    Mechanism m = one_joint(JointType::Spherical, Vec3::UnitZ(), Vec3::UnitX());
    m.bodies[0].kind = test::block(plane.frame.R * Vec3(0.3, 0.1, 0), 2, 0.1);
    EXPECT_EQ(Model<SE2>::build(m, plane).constraints(), 2) << tilt;
    m.joints[0].type = JointType::Fixed;
    EXPECT_EQ(Model<SE2>::build(m, plane).constraints(), 3) << tilt;
  }
}

struct ExpectedInPlane {
  JointType type;
  Vec3 axis, axis2;
  int constraints, coordinates;
};

TEST(Joints, RowsInThePlane) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  for (const auto& e : std::initializer_list<ExpectedInPlane>{{JointType::Fixed, z, x, 3, 0},
                                                              {JointType::Fixed, x, y, 3, 0},
                                                              {JointType::Revolute, z, x, 2, 1},
                                                              {JointType::Revolute, x, y, 3, 0},
                                                              {JointType::Prismatic, x, y, 2, 1},
                                                              {JointType::Prismatic, z, x, 3, 0},
                                                              {JointType::Cylindrical, z, x, 2, 1},
                                                              {JointType::Cylindrical, x, y, 2, 1},
                                                              {JointType::Spherical, z, x, 2, 0},
                                                              {JointType::Universal, z, x, 2, 1},
                                                              {JointType::Universal, x, z, 2, 1},
                                                              {JointType::Universal, x, y, 3, 0},
                                                              {JointType::Planar, z, x, 0, 3},
                                                              {JointType::Planar, x, y, 2, 1}}) {
    const auto model = Model<SE2>::build(one_joint(e.type, e.axis, e.axis2), {});
    ASSERT_EQ(model.couplings.size(), 1u);
    EXPECT_EQ(model.constraints(), e.constraints) << int(e.type) << " " << e.axis.transpose();
    EXPECT_EQ(coordinates(model), e.coordinates) << int(e.type) << " " << e.axis.transpose();
    EXPECT_EQ(rank(model, {SE2::identity(), SE2::identity()}), e.constraints) << int(e.type);
  }
}

/// Free motions of a joint about z (and x) in the axes of b, at b = exp(free) in a.
Eigen::MatrixXd free_motions(JointType type) {
  const Eigen::MatrixXd e = Eigen::MatrixXd::Identity(6, 6);
  switch (type) {
    case JointType::Fixed:
      return Eigen::MatrixXd(6, 0);
    case JointType::Revolute:
      return e.col(5);
    case JointType::Prismatic:
      return e.col(2);
    case JointType::Cylindrical:
      return e(Eigen::all, std::vector<int>{2, 5});
    case JointType::Spherical:
      return e.rightCols(3);
    case JointType::Planar:
      return e(Eigen::all, std::vector<int>{0, 1, 5});
    case JointType::Screw:
      return e.col(5) + 0.2 / (2 * M_PI) * e.col(2);
    case JointType::Rod:
    case JointType::Cylinder:
    case JointType::Bushing:
    case JointType::Universal:
      break;
  }
  return e(Eigen::all, std::vector<int>{5, 3});
}

TEST(Joints, ReactionsHaveNoComponentAlongTheFreeMotions) {
  test::Random random(5);
  for (const auto type :
       {JointType::Fixed, JointType::Revolute, JointType::Prismatic, JointType::Cylindrical,
        JointType::Spherical, JointType::Planar, JointType::Screw}) {
    const auto m = one_joint(type, Vec3::UnitZ(), Vec3::UnitX());
    const auto model = Model<SE3>::build(m, {});
    const auto& c = model.couplings[0];
    for (int trial = 0; trial < 5; ++trial) {
      const Eigen::MatrixXd F = free_motions(type);
      SE3::Tangent h = SE3::Tangent::Zero();
      if (F.cols() > 0) h += F * random.vector(int(F.cols()));
      const SE3 H = SE3::exp(h);
      const RelativeMotion<SE3> motion(SE3::identity(), H);
      for (int i = 0; i < c.constraints; ++i) {
        const auto& row = c.rows[std::size_t(i)].row;
        EXPECT_NEAR(row.value(motion, 0), 0, 1e-14) << int(type);
        Row<SE3>::Gradient g;
        row.gradient(motion, g);
        EXPECT_LT((g.tail<6>().transpose() * F).norm(), 1e-14) << int(type);
      }
    }
  }
}

SE3 turn(const Vec3& w) {
  SE3::Tangent h = SE3::Tangent::Zero();
  h.tail<3>() = w;
  return SE3::exp(h);
}

TEST(Joints, UniversalJointHasItsTwoAngles) {
  const auto model =
      Model<SE3>::build(one_joint(JointType::Universal, Vec3::UnitZ(), Vec3::UnitX()), {});
  const auto& c = model.couplings[0];
  for (const double alpha : {-2.5, -0.4, 0.0, 1.3, 3.0})
    for (const double beta : {-1.2, 0.0, 0.7}) {
      const SE3 H = turn({0, 0, alpha}) * turn({beta, 0, 0});
      const RelativeMotion<SE3> motion(SE3::identity(), H);
      const int a = test::row_of(model, 0, 0) - c.first_row,
                b = test::row_of(model, 0, 1) - c.first_row;
      EXPECT_NEAR(c.rows[std::size_t(a)].row.value(motion, alpha), alpha, 1e-14);
      EXPECT_NEAR(c.rows[std::size_t(b)].row.value(motion, beta), beta, 1e-14);
      Eigen::Matrix<double, 6, 2> F = Eigen::Matrix<double, 6, 2>::Zero();
      F.col(0).tail<3>() = Vec3::UnitX();
      F.col(1).tail<3>() = turn({-beta, 0, 0}).R * Vec3::UnitZ();
      for (int i = 0; i < c.constraints; ++i) {
        Row<SE3>::Gradient g;
        c.rows[std::size_t(i)].row.value(motion, 0);
        c.rows[std::size_t(i)].row.gradient(motion, g);
        EXPECT_NEAR(c.rows[std::size_t(i)].row.value(motion, 0), 0, 1e-14);
        EXPECT_LT((g.tail<6>().transpose() * F).norm(), 1e-14);
      }
    }
}

}  // namespace
}  // namespace liesl::test::joints_test
