/// @file
/// What joints leave open, against the deformation of the bodies that they are set against.

#include "mbs/run.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl::test::joint_opening_test {
namespace {

template <class G>
class JointOpeningIn : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(JointOpeningIn, Groups);

/// The share of an opening of every row where nodes are off by next to nothing.
template <FrameGroup G>
double share(const Model<G>& model, double opening, double off) {
  JointOpening<G> open(model);
  State<G> s = model.initial_state();
  Random random(5);
  model.retract(s, off * random.vector(model.size()));
  model.complete(s);
  open.step(Eigen::VectorXd::Constant(model.constraints(), opening), s);
  return open.worst().share;
}

/// Bodies that hardly deform do not make of joints that are as closed as augmented ones are, to
/// 1e-9 m, such as are open; those that are open further are.
TYPED_TEST(JointOpeningIn, OfClosedJointsIsNoShareOfStiffBodies) {
  using G = TypeParam;
  Mechanism m = slider_crank();
  m.penalty = {ConstraintForm::Penalty, 1e9, 1e7, 0, 1e-4};
  const auto model = Model<G>::build(m, space_of<G>(m));
  EXPECT_GT(share(model, 1e-10, 1e-12), 1e-5);
  EXPECT_LT(share(model, 1e-10, 1e-12), 0.01);
  EXPECT_GT(share(model, 1e-7, 1e-12), 0.1);
}

}  // namespace
}  // namespace liesl::test::joint_opening_test
