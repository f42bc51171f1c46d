/// @file
/// Rows of couplings: gradient and hessian against differences, angles beyond pi.

#include "mbs/couplings/rows.hpp"

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::rows_test {
namespace {

using test::Random;

template <class G>
using VectorOf = typename Row<G>::Vector;
template <class G>
using GradientOf = typename Row<G>::Gradient;

template <class G>
class RowsTest : public ::testing::Test {
 protected:
  static constexpr int dim = G::dim, sd = G::space_dim;

  std::vector<Row<G>> rows() {
    const auto any = [this] { return VectorOf<G>(random.vector(sd)); };
    std::vector<Row<G>> all;
    for (int i = 0; i < 3; ++i) {
      all.push_back(Row<G>::displacement(any()));
      all.push_back(Row<G>::perpendicular(any(), any()));
      all.push_back(Row<G>::angle(any(), any(), any(), any()));
      all.push_back(Row<G>::distance());
      all.push_back(Row<G>::distance(0.3).scaled(0.7));
      all.push_back(Row<G>::angle(any(), any(), any(), any()).scaled(-1.5));
      all.push_back(Row<G>::screw(any(), 0.3 * (i - 0.5), any(), any()));
    }
    return all;
  }
  RelativeMotion<G> motion(const GradientOf<G>& h) const {
    return {a * G::exp(typename G::Tangent(h.template head<dim>())),
            b * G::exp(typename G::Tangent(h.template tail<dim>()))};
  }

  Random random{7};
  G a = G::exp(typename G::Tangent(random.vector(dim))),
    b = G::exp(typename G::Tangent(random.vector(dim)));
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(RowsTest, Groups);

TYPED_TEST(RowsTest, GradientIsTheDerivativeOfTheValue) {
  using Gradient = GradientOf<TypeParam>;
  for (const auto& row : this->rows()) {
    Gradient g;
    row.gradient(this->motion(Gradient::Zero()), g);
    const double value = row.value(this->motion(Gradient::Zero()), 0);
    const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
      Eigen::VectorXd d(g.size());
      for (int j = 0; j < g.size(); ++j) {
        const Gradient e = h * Gradient::Unit(j);
        d[j] = (row.value(this->motion(e), value) - row.value(this->motion(-e), value)) / (2 * h);
      }
      return d;
    };
    test::expect_second_order(difference, g, Eigen::VectorXd::Constant(g.size(), g.norm()), 1e-3,
                              1e-10, "gradient " + std::to_string(int(row.kind())));
  }
}

TYPED_TEST(RowsTest, HessianIsTheDerivativeOfTheGradient) {
  using Gradient = GradientOf<TypeParam>;
  for (const auto& row : this->rows()) {
    const auto H = row.hessian(this->motion(Gradient::Zero()));
    const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
      Eigen::MatrixXd d(H.rows(), H.cols());
      for (int j = 0; j < H.cols(); ++j) {
        const Gradient e = h * Gradient::Unit(j);
        Gradient forward, backward;
        row.gradient(this->motion(e), forward);
        row.gradient(this->motion(-e), backward);
        d.col(j) = (forward - backward) / (2 * h);
      }
      return d.reshaped();
    };
    test::expect_second_order(difference, H.reshaped(),
                              Eigen::VectorXd::Constant(H.size(), H.norm()), 1e-3, 1e-10,
                              "hessian " + std::to_string(int(row.kind())));
  }
}

TYPED_TEST(RowsTest, RowsDependOnTheRelativeMotionOnly) {
  using G = TypeParam;
  const G H = G::exp(typename G::Tangent(2 * this->random.vector(G::dim)));
  const RelativeMotion<G> before(this->a, this->b), after(H * this->a, H * this->b);
  for (const auto& row : this->rows())
    EXPECT_NEAR(row.value(before, 0), row.value(after, 0), 1e-13);
}

TYPED_TEST(RowsTest, AnglesContinueOverTwentyTurns) {
  using G = TypeParam;
  using Vector = VectorOf<TypeParam>;
  const int plane = G::space_dim == 2 ? 0 : 1;  // turns about z, or about x in space
  const Vector m = Vector::Unit(plane + 1), n = Vector::Unit(plane);
  const auto row = Row<G>::angle(m, n, n, n);
  for (const double direction : {1.0, -1.0}) {
    double value = 0;
    for (double phi = 0; phi < 40 * M_PI; phi += 0.8 * M_PI) {
      typename G::Tangent h = G::Tangent::Zero();
      h[G::space_dim] = direction * phi;
      value = row.value(RelativeMotion<G>(this->a, this->a * G::exp(h)), value);
      ASSERT_NEAR(value, direction * phi, 1e-12);
    }
  }
}

/// Twenty turns either way, displaced in proportion: the value stays the deviation.
TEST(ScrewRow, FollowsItsTurns) {
  for (const double lead : {0.01, -0.4}) {
    const auto row = Row<SE3>::screw(Vec3::UnitZ(), lead, Vec3::UnitY(), Vec3::UnitX());
    for (const double direction : {1.0, -1.0}) {
      double value = 0;
      for (double phi = 0; phi < 40 * M_PI; phi += 0.8 * M_PI) {
        SE3::Tangent turn = SE3::Tangent::Zero();
        turn[5] = direction * phi;
        SE3 H = SE3::exp(turn);
        H.x.z() = lead * direction * phi + 0.3 * std::abs(lead);
        value = row.value(RelativeMotion<SE3>(SE3::identity(), H), value);
        ASSERT_NEAR(value, 0.3 * std::abs(lead), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace liesl::test::rows_test
