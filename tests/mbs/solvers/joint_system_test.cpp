/// @file
/// The joint system against a dense solve of the whole saddle point.

#include "mbs/solvers/joint_system.hpp"

#include <functional>

#include "mbs/run.hpp"

namespace liesl::test::joint_system_test {
namespace {

using test::Random;

/// Slider-crank with a spring and a damper on joints, a spring between two points and an actuator.
Mechanism scene() {
  test::SliderCrank p;
  p.elements = 3;
  auto m = test::slider_crank(p);
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = 40;
  spring.damping = 0.3;
  ForceSpec rope;
  rope.name = "rope";
  rope.a.offset = SE3(Mat3::Identity(), {0.1, 0.3, 0});
  rope.b = {1, 2};
  rope.stiffness = 900;
  ForceSpec motor;
  motor.name = "motor";
  motor.joint = 2;
  motor.force = TimeFunction::constant(3);
  m.forces = {spring, rope, motor};
  return m;
}

template <class G>
class JointSystemTest : public ::testing::Test {
 protected:
  static constexpr int width = G::dim;
  static Space<G> space() {
    if constexpr (G::space_dim == 2)
      return *find_plane(scene()).plane;
    else
      return {};
  }
  JointSystemTest()
      : model(Model<G>::build(scene(), space())), eq(model), s(model.initial_state()) {
    for (auto& H : s.H) H = H * G::exp(typename G::Tangent(1e-2 * random.vector(width)));
    s.v = random.vector(model.size());
    s.vdot = random.vector(model.size());
    s.lambda = random.vector(model.constraints());
    eq.evaluate(s, s.rows, {0.01, 1});
  }

  Eigen::MatrixXd dense(const BlockTridiagonal<width>& A) const {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(A.size(), A.size());
    for (int k = 0; k < A.blocks(); ++k) {
      m.block(width * k, width * k, width, width) = A.D[std::size_t(k)];
      if (k + 1 == A.blocks()) break;
      m.block(width * k, width * (k + 1), width, width) = A.U[std::size_t(k)];
      m.block(width * (k + 1), width * k, width, width) = A.L[std::size_t(k)];
    }
    return m;
  }

  /// [A + C^T k C, B^T; B, 0] with A of the bodies, C the rows of springs and dampers.
  void solve_dense(const std::function<BlockTridiagonal<width>(int)>& body, double gamma,
                   bool compliant, Eigen::VectorXd& delta, Eigen::VectorXd& dlambda,
                   double scaling = 1, double penalty = 0) const {
    const int n = model.size(), c = model.constraints();
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(n + c, n + c);
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      const int at = width * model.first_node(int(b)), size = model.bodies[b]->size();
      S.block(at, at, size, size) = dense(body(int(b)));
    }
    for (std::size_t j = 0; j < model.couplings.size(); ++j) {
      const auto& coupling = model.couplings[j];
      for (int i = 0; i < coupling.active; ++i) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(n + c);
        const auto B = eq.couplings[j].B.row(i);
        if (coupling.a.body >= 0)
          row.segment<width>(width * coupling.a.node) += B.template head<width>().transpose();
        if (coupling.b.body >= 0)
          row.segment<width>(width * coupling.b.node) += B.template tail<width>().transpose();
        const auto& law = coupling.rows[std::size_t(i)].law;
        if (i < coupling.constraints) {
          S.row(n + coupling.first_constraint + i) = row.transpose();
          S.col(n + coupling.first_constraint + i) = row;
        } else if (compliant) {
          S += (law.stiffness + gamma * law.damping) * row * row.transpose();
        }
      }
    }
    Eigen::VectorXd rhs(n + c);
    rhs << -eq.r, -eq.phi;
    // Thesis eq. 2.8: k lambda + p Phi in the place of lambda, k Phi in that of Phi.
    const Eigen::MatrixXd B = S.bottomLeftCorner(c, n);
    S.topLeftCorner(n, n) += penalty * B.transpose() * B;
    rhs.head(n) -= penalty * B.transpose() * eq.phi;
    S.topRightCorner(n, c) *= scaling;
    S.bottomLeftCorner(c, n) *= scaling;
    rhs.tail(c) *= scaling;
    // Rows and columns of the constraints in the size of A, for the sake of the pivots.
    Eigen::VectorXd d = Eigen::VectorXd::Ones(n + c);
    d.tail(c) *= S.diagonal().cwiseAbs().maxCoeff();
    const Eigen::VectorXd x = d.asDiagonal() * (d.asDiagonal() * S * d.asDiagonal())
                                                   .eval()
                                                   .partialPivLu()
                                                   .solve(d.asDiagonal() * rhs)
                                                   .eval();
    delta = x.head(n);
    dlambda = scaling * x.tail(c);
  }

  /// Multipliers to a relative 1e-9, positions likewise.
  void expect_same(JointSystem<G>& system, bool compliant,
                   const std::function<BlockTridiagonal<width>(int)>& body, double gamma) {
    Eigen::VectorXd delta, dlambda = s.lambda, x, y;
    ASSERT_TRUE(system.solve(eq, delta, dlambda, compliant));
    solve_dense(body, gamma, compliant, x, y);
    EXPECT_LT((delta - x).norm(), 1e-8 * x.norm());
    EXPECT_LT((dlambda - y).norm(), 1e-8 * y.norm());
  }

  Random random{11};
  Model<G> model;
  Equations<G> eq;
  State<G> s;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(JointSystemTest, Groups);

constexpr TangentWeights kWeights{4e8, 2e4};

/// The classical formalism's scaling and penalty of constraints make no other corrections.
TYPED_TEST(JointSystemTest, ScalingAndPenaltyOfConstraintsLeaveTheCorrectionsAsTheyAre) {
  JointSystem<TypeParam> system(this->model);
  ASSERT_TRUE(system.factor(kWeights));
  const auto body = [&](int b) {
    BodyMatrix<TypeParam::dim> A(this->model.bodies[std::size_t(b)]->nodes());
    const auto& part = *this->model.bodies[std::size_t(b)];
    A.set_sum(kWeights.mass, part.mass(), 1 + kWeights.damping * part.damping(), part.stiffness());
    return A;
  };
  Eigen::VectorXd delta, dlambda = this->s.lambda, x, y;
  ASSERT_TRUE(system.solve(this->eq, delta, dlambda, true));
  this->solve_dense(body, kWeights.damping, true, x, y, 1e7, 1e5);
  EXPECT_LT((delta - x).norm(), 1e-8 * x.norm());
  EXPECT_LT((dlambda - y).norm(), 1e-8 * y.norm());
}

TYPED_TEST(JointSystemTest, ConstantTangent) {
  JointSystem<TypeParam> system(this->model);
  ASSERT_TRUE(system.factor(kWeights));
  const auto body = [&](int b) {
    BodyMatrix<TypeParam::dim> A(this->model.bodies[std::size_t(b)]->nodes());
    const auto& part = *this->model.bodies[std::size_t(b)];
    A.set_sum(kWeights.mass, part.mass(), 1 + kWeights.damping * part.damping(), part.stiffness());
    return A;
  };
  this->expect_same(system, true, body, kWeights.damping);
  this->expect_same(system, false, body, kWeights.damping);
}

/// With all that a state adds: the same corrections as the whole matrix, factored at once.
TYPED_TEST(JointSystemTest, ExactTangent) {
  using G = TypeParam;
  const Eigen::VectorXd dq = 0.1 * this->random.vector(this->model.size());
  RateTangents<G> rates;
  NodeCoordinates<G>(this->model, true)
      .rate_tangents(this->s, dq, this->s.v, this->s.vdot, kWeights, rates);
  IterationMatrix<G> S(this->model);
  S.take_prestress(this->eq, this->s);
  const Eigen::SparseMatrix<double> whole = S.assemble(this->eq, this->s, {0.01, 1}, &rates);
  JointSystem<G> system(this->model);
  ASSERT_TRUE(system.factor_exact(S));
  Eigen::VectorXd delta, dlambda = this->s.lambda;
  ASSERT_TRUE(system.solve(this->eq, delta, dlambda));
  Eigen::VectorXd rhs(whole.rows());
  rhs << -this->eq.r, -this->eq.phi;
  ASSERT_TRUE(S.factor());
  S.lu().solve(rhs);
  EXPECT_LT((delta - rhs.head(delta.size())).norm(), 1e-8 * delta.norm());
  EXPECT_LT((dlambda - rhs.tail(dlambda.size())).norm(), 1e-8 * dlambda.norm());
}

TYPED_TEST(JointSystemTest, MassAlone) {
  JointSystem<TypeParam> system(this->model);
  ASSERT_TRUE(system.factor({1, 0}, 0));
  this->expect_same(
      system, false, [&](int b) { return this->model.bodies[std::size_t(b)]->mass(); }, 0);
}

/// The exact tangent of the bodies is the derivative of their residual along
/// (H, v, vdot) += (delta, gamma' delta, beta' delta).
TYPED_TEST(JointSystemTest, ExactTangentIsTheDerivativeOfTheResidual) {
  using G = TypeParam;
  constexpr int dim = G::dim;
  const TangentWeights w{5e3, 40};
  const typename Body<G>::Vector gravity = Body<G>::Vector::Constant(2e5);  // counts beside EA
  for (std::size_t b = 0; b < this->model.bodies.size(); ++b) {
    const auto& body = *this->model.bodies[b];
    const int first = this->model.first_node(int(b));
    const auto residual = [&](const Eigen::VectorXd& delta) {
      State<G> at = this->s;
      Eigen::VectorXd all = Eigen::VectorXd::Zero(this->model.size());
      all.segment(dim * first, body.size()) = delta;
      this->model.retract(at, all);
      at.v.segment(dim * first, body.size()) += w.damping * delta;
      at.vdot.segment(dim * first, body.size()) += w.mass * delta;
      Eigen::VectorXd r = Eigen::VectorXd::Zero(body.size());
      ForceScale scale;
      const auto state = this->model.body_state(at, int(b));
      body.add_internal(state, r.data(), scale);
      body.add_inertia(state, gravity, r.data(), scale);
      return r;
    };
    BodyMatrix<dim> A(body.nodes());
    body.exact_tangent(this->model.body_state(this->s, int(b)), gravity, w, nullptr, A);
    const Eigen::VectorXd direction = this->random.vector(body.size());
    Eigen::VectorXd exact = Eigen::VectorXd::Zero(body.size());
    A.multiply_add(direction.data(), exact.data());
    const double h = 1e-6;
    const Eigen::VectorXd difference =
        (residual(h * direction) - residual(-h * direction)) / (2 * h);
    EXPECT_LT((difference - exact).norm(), 1e-7 * exact.norm()) << body.name;
  }
}

}  // namespace
}  // namespace liesl::test::joint_system_test
