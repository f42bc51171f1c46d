/// @file
/// The static problem of a part against a dense solution, differences and closed forms.
#include "esl/static_part.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <memory>

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::static_part_test {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// One beam: curved in space (45 degree bend), straight in the plane (rod of the slider-crank).
template <FrameGroup G>
struct Sample {
  Mechanism mechanism;
  Model<G> model;
  int body;
  const Beam<G>& beam;

  static constexpr bool planar = G::dim == 3;
  Sample() : Sample(planar ? test::slider_crank() : test::bend45(8, 600), planar ? 1 : 0) {}
  Sample(const Mechanism& m, int b)
      : mechanism(m),
        model(Model<G>::build(mechanism, test::space_of<G>(mechanism))),
        body(b),
        beam(dynamic_cast<const Beam<G>&>(*model.bodies[b])) {}

  PartSupport held(const std::vector<std::string>& support) const {
    return read_support(support, mechanism, model, body);
  }
  typename StaticPart<G>::Law law() const {
    typename StaticPart<G>::Law K;
    for (int e = 0; e < beam.elements(); ++e) K.push_back(beam.element(e).section_stiffness());
    return K;
  }
  Matrix stiffness() const {
    Matrix K(beam.size(), beam.size());
    const auto blocks = beam.stiffness();
    for (int i = 0; i < beam.size(); ++i) {
      Vector column = Vector::Zero(beam.size());
      blocks.multiply_add(Vector::Unit(beam.size(), i).eval().data(), column.data());
      K.col(i) = column;
    }
    return K;
  }
};

Matrix random(int rows, int cols, unsigned seed) {
  std::srand(seed);
  return Matrix::Random(rows, cols);
}

/// A change of all section stiffnesses, symmetric, a hundredth to a tenth of them.
template <FrameGroup G>
typename StaticPart<G>::Law random_change(const typename StaticPart<G>::Law& K, unsigned seed) {
  typename StaticPart<G>::Law dK;
  for (const auto& k : K) {
    const Matrix r = 0.05 * random(G::dim, G::dim, seed++);
    const Vector root = k.diagonal().cwiseSqrt();
    dK.push_back(root.asDiagonal() * (r + r.transpose()) * root.asDiagonal());
  }
  return dK;
}

template <FrameGroup G>
typename StaticPart<G>::Law sum(typename StaticPart<G>::Law K, double f,
                                const typename StaticPart<G>::Law& dK) {
  for (size_t e = 0; e < K.size(); ++e) K[e] += f * dK[e];
  return K;
}

template <class G>
class Part : public testing::Test {};
using Groups = testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(Part, Groups);

std::vector<std::vector<std::string>> supports(bool planar) {
  if (planar) return {{"start"}, {"mid"}, {"start:x,y", "end:y"}, {"end:xyz,rx", "node2:yz"}};
  return {{"start"}, {"end"}, {"node3"}, {"start:xyz,rx", "end:yz"}};
}

TYPED_TEST(Part, SolvesAsADenseMatrixDoes) {
  const Sample<TypeParam> sample;
  const int n = sample.beam.size();
  for (const auto& support : supports(sample.planar)) {
    const PartSupport held = sample.held(support);
    StaticPart<TypeParam> part(sample.beam, held, random(n, 2, 1));
    Matrix f = random(n, 3, 2);
    part.set_loads(f);
    ASSERT_TRUE(part.solve(sample.law()));
    Matrix K = sample.stiffness();
    for (const int i : held.fixed) {
      K.row(i).setZero();
      K.col(i).setZero();
      K(i, i) = 1;
      f.row(i).setZero();
    }
    const Matrix u = K.fullPivLu().solve(f);
    EXPECT_LT((part.u() - u).norm(), 1e-8 * u.norm()) << support[0];
    EXPECT_LT((part.y() - random(n, 2, 1).transpose() * u).norm(), 1e-8 * u.norm()) << support[0];
  }
}

TYPED_TEST(Part, GradientsHaveDifferencesOfSecondOrder) {
  const Sample<TypeParam> sample;
  const int n = sample.beam.size();
  StaticPart<TypeParam> part(sample.beam, sample.held(supports(sample.planar)[2]), random(n, 2, 3));
  part.set_loads(random(n, 3, 4));
  const auto K = sample.law();
  const auto dK = random_change<TypeParam>(K, 5);
  ASSERT_TRUE(part.solve(K));
  Matrix dy = Matrix::Zero(2, 3);
  for (int e = 0; e < sample.beam.elements(); ++e) part.add_gradient(e, dK[e], dy);
  const auto error = [&](double h) {
    part.solve(sum<TypeParam>(K, h, dK));
    const Matrix plus = part.y();
    part.solve(sum<TypeParam>(K, -h, dK));
    return ((plus - part.y()) / (2 * h) - dy).norm() / dy.norm();
  };
  const double coarse = error(0.1), fine = error(0.01);
  EXPECT_NEAR(std::log10(coarse / fine), 2, 0.1);
  EXPECT_LT(error(1e-4), 1e-7);
}

TYPED_TEST(Part, DirectAndAdjointGradientsAreTheSame) {
  const Sample<TypeParam> sample;
  const int n = sample.beam.size();
  for (const auto& support : supports(sample.planar)) {
    StaticPart<TypeParam> part(sample.beam, sample.held(support), random(n, 4, 3));
    part.set_loads(random(n, 3, 4));
    const auto K = sample.law();
    const auto dK = random_change<TypeParam>(K, 5);
    ASSERT_TRUE(part.solve(K));
    Matrix adjoint = Matrix::Zero(4, 3), direct = adjoint;
    for (int e = 0; e < sample.beam.elements(); ++e) part.add_gradient(e, dK[e], adjoint);
    part.add_gradient_direct(dK, direct);
    EXPECT_LT((direct - adjoint).norm(), 1e-10 * adjoint.norm()) << support[0];
    EXPECT_GT(adjoint.norm(), 0);
  }
}

TYPED_TEST(Part, ComplianceIsLoadTimesDisplacementWithDifferencesOfSecondOrder) {
  const Sample<TypeParam> sample;
  StaticPart<TypeParam> part(sample.beam, sample.held(supports(sample.planar)[2]),
                             random(sample.beam.size(), 1, 3));
  const Matrix f = random(sample.beam.size(), 3, 4);
  part.set_loads(f);
  const auto K = sample.law();
  const auto dK = random_change<TypeParam>(K, 5);
  ASSERT_TRUE(part.solve(K));
  EXPECT_LT((part.compliance() - (f.transpose() * part.u()).diagonal().transpose()).norm(),
            1e-12 * part.compliance().norm());
  Eigen::RowVectorXd slope = Eigen::RowVectorXd::Zero(3);
  for (int e = 0; e < sample.beam.elements(); ++e) slope += part.compliance_gradient(e, dK[e]);
  const auto error = [&](double h) {
    part.solve(sum<TypeParam>(K, h, dK));
    const Eigen::RowVectorXd plus = part.compliance();
    part.solve(sum<TypeParam>(K, -h, dK));
    return ((plus - part.compliance()) / (2 * h) - slope).norm() / slope.norm();
  };
  EXPECT_NEAR(std::log10(error(0.1) / error(0.01)), 2, 0.1);
  EXPECT_LT(error(1e-4), 1e-7);
}

TYPED_TEST(Part, SecondDerivativesAreThoseOfTheGradients) {
  using G = TypeParam;
  const Sample<G> sample;
  const int n = sample.beam.size();
  StaticPart<G> part(sample.beam, sample.held(supports(sample.planar)[2]), random(n, 2, 6));
  part.set_loads(random(n, 3, 7));
  // K(x) = K + x0 A + x1 B + x0^2/2 A' + x0 x1 B'
  const auto K = sample.law();
  const auto A = random_change<G>(K, 8), B = random_change<G>(K, 20);
  const auto AA = random_change<G>(K, 32), AB = random_change<G>(K, 44);
  const Matrix w = random(2, 3, 9);
  const auto gradient = [&](double x0, double x1) {
    part.solve(sum<G>(sum<G>(sum<G>(sum<G>(K, x0, A), x1, B), x0 * x0 / 2, AA), x0 * x1, AB));
    const auto d0 = sum<G>(sum<G>(A, x0, AA), x1, AB), d1 = sum<G>(B, x0, AB);
    Matrix y0 = Matrix::Zero(2, 3), y1 = y0;
    for (int e = 0; e < sample.beam.elements(); ++e) {
      part.add_gradient(e, d0[e], y0);
      part.add_gradient(e, d1[e], y1);
    }
    return Eigen::Vector2d(w.cwiseProduct(y0).sum(), w.cwiseProduct(y1).sum());
  };
  const double step = 1e-4;
  const Eigen::Vector2d by0 = (gradient(step, 0) - gradient(-step, 0)) / (2 * step);
  const Eigen::Vector2d by1 = (gradient(0, step) - gradient(0, -step)) / (2 * step);
  part.solve(K);
  typename StaticPart<G>::Second d2K(2, std::vector<typename StaticPart<G>::Law>(2));
  d2K[0][0] = AA;
  d2K[1][0] = AB;
  Matrix h = Matrix::Zero(2, 2);
  part.add_second({A, B}, d2K, w, h);
  const double size = h.norm();
  EXPECT_NEAR(h(0, 0), by0[0], 1e-6 * size);
  EXPECT_NEAR(h(1, 0), by0[1], 1e-6 * size);
  EXPECT_NEAR(h(1, 0), by1[0], 1e-6 * size);
  EXPECT_NEAR(h(1, 1), by1[1], 1e-6 * size);
}

TYPED_TEST(Part, StrainsDoNotDependOnTheSupportUnderBalancedLoads) {
  const Sample<TypeParam> sample;
  const Matrix f = sample.stiffness() * random(sample.beam.size(), 2, 10);
  const Matrix C = StaticPart<TypeParam>::strain_output(sample.beam, 5);
  auto all = supports(sample.planar);
  all.push_back({"inertia_relief"});
  Matrix first;
  for (const auto& support : all) {
    StaticPart<TypeParam> part(sample.beam, sample.held(support), C);
    part.set_loads(f);
    ASSERT_TRUE(part.solve(sample.law()));
    if (first.size() == 0) first = part.y();
    EXPECT_LT((part.y() - first).norm(), 1e-9 * first.norm()) << support[0];
  }
}

TEST(InertiaRelief, PulledBarCarriesTheForceThatItsMassBehindNeeds) {
  const Sample<SE2> sample;
  const int elements = sample.beam.elements();
  const double force = 100, EA = sample.beam.element(0).section_stiffness()(0, 0);
  Matrix f = Matrix::Zero(sample.beam.size(), 1);
  f(3 * elements, 0) = force;
  for (int e = 0; e < elements; ++e) {
    StaticPart<SE2> part(sample.beam, sample.held({"inertia_relief"}),
                         StaticPart<SE2>::strain_output(sample.beam, e));
    part.set_loads(f);
    ASSERT_TRUE(part.solve(sample.law()));
    EXPECT_NEAR(part.y()(0, 0), force / EA * (e + 0.5) / elements, 1e-12 * force / EA);
  }
}

TEST(LongSlenderPart, KeepsItsDigits) {
  // 100 elements with shear made rigid: factoring the stiffness would lose nine digits.
  const Box wall{0.05002, 0.05002, 2e-5};
  const Section stiff_in_shear{"wall", wall, {20, 20}};
  Mechanism m = test::cantilever(
      test::straight_beam({0, 0, 0}, {5, 0, 0}, 100, stiff_in_shear, test::steel()));
  m.loads.push_back(test::tip_load(m, {0, -0.042, 0}));  // makes it planar
  const Sample<SE2> sample(m, 0);
  const double force = 0.042, L = 5, h = 0.05;
  const auto K = sample.law();
  Matrix C = Matrix::Zero(sample.beam.size(), 1);
  C(sample.beam.size() - 2, 0) = 1;
  StaticPart<SE2> part(sample.beam, sample.held({"start"}), C);
  part.set_loads(force * C);
  ASSERT_TRUE(part.solve(K));
  const double exact = force * ((L * L * L / 3 - L * h * h / 12) / K[0](2, 2) + L / K[0](1, 1));
  EXPECT_NEAR(part.y()(0, 0), exact, 1e-12 * exact);
}

std::string refusal(const std::vector<std::string>& support) {
  static const Sample<SE2> sample;
  try {
    sample.held(support);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Support, BadOnesAreRefusedWithText) {
  EXPECT_EQ(refusal({"start"}), "accepted");
  EXPECT_NE(refusal({"node99"}).find("no node 'node99'"), std::string::npos);
  EXPECT_NE(refusal({"start:xq"}).find("expected directions among x, y, z"), std::string::npos);
  EXPECT_NE(refusal({"start:x,y"}).find("holds 2 directions; expected 3"), std::string::npos);
  EXPECT_NE(refusal({"start", "end:y"}).find("holds 4 directions"), std::string::npos);
  EXPECT_NE(refusal({"start:x,y", "end:x"}).find("a rigid motion"), std::string::npos);
}

TEST(Support, InertiaReliefNeedsMass) {
  Mechanism m = test::bend45(8, 600);
  for (Section& s : std::get<BeamSpec>(m.bodies[0].kind).sections)
    std::get<FullSection>(s.shape).inertia.setZero();
  const Sample<SE3> massless(m, 0);
  EXPECT_THROW(massless.held({"inertia_relief"}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::static_part_test
