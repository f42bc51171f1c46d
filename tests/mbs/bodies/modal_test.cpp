/// @file
/// Identities of the modal body: forces are gradients, inertia has the power of the kinetic energy,
/// all modes make the linear finite element model.

#include "mbs/bodies/modal.hpp"

#include <Eigen/Eigenvalues>

#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::modal_test {
namespace {

template <class G>
class ModalBodyTest : public ::testing::Test {
 protected:
  static constexpr int dim = G::dim, elements = 4;
  using Tangent = typename G::Tangent;

  ModalBodyTest() {
    body = make({0, 4}, -1);
    move(0.1);
  }

  /// Sets a state with displacements of a size.
  void move(double displacement) {
    test::Random numbers{5};
    H = body->reference;
    for (auto& frame : H) frame = frame * G::exp(Tangent(displacement * numbers.vector(dim)));
    const int n = body->size();
    v = numbers.vector(n);
    vdot = numbers.vector(n);
    w = displacement * numbers.vector(n);
    keep_unknowns(*body, v);
    keep_unknowns(*body, vdot);
    for (int k = 0; k < body->nodes(); ++k)
      if (body->kind(k) != NodeKind::Amplitudes) w.template segment<dim>(dim * k).setZero();
  }

  std::unique_ptr<ModalBody<G>> make(const std::vector<int>& interfaces, int modes) {
    std::vector<G> nodes;
    std::vector<ElementSection<G>> sections;
    for (int k = 0; k <= elements; ++k) {
      nodes.push_back(k ? nodes.back() * G::exp(Tangent(0.3 * Tangent::Unit(0))) : G::identity());
      if (k) sections.push_back({stiffness, inertia});
    }
    return std::make_unique<ModalBody<G>>(std::make_unique<Beam<G>>("beam", nodes, sections, 0.),
                                          interfaces, modes);
  }
  static void keep_unknowns(const Body<G>& b, Eigen::VectorXd& x) {
    for (int k = 0; k < b.nodes(); ++k)
      if (b.kind(k) == NodeKind::Follower) x.template segment<dim>(dim * k).setZero();
  }
  /// The state a time t later along v and vdot.
  void later(double t, std::vector<G>& Ht, Eigen::VectorXd& vt, Eigen::VectorXd& at,
             Eigen::VectorXd& wt) const {
    Ht = H;
    vt = v + t * vdot;
    at = vdot;
    wt = w;
    for (int k = 0; k < body->nodes(); ++k) {
      const Tangent d =
          t * v.template segment<dim>(dim * k) + 0.5 * t * t * vdot.template segment<dim>(dim * k);
      if (body->kind(k) == NodeKind::Frame) Ht[k] = H[k] * G::exp(d);
      if (body->kind(k) == NodeKind::Amplitudes) wt.template segment<dim>(dim * k) += d;
    }
  }
  BodyEnergy energy(double t) const {
    std::vector<G> Ht;
    Eigen::VectorXd vt, at, wt;
    later(t, Ht, vt, at, wt);
    body->complete(Ht.data(), vt.data(), at.data(), wt.data());
    return body->energy({Ht.data(), vt.data(), at.data(), wt.data()}, Body<G>::Vector::Zero());
  }
  BodyState<G> state() const { return {H.data(), v.data(), vdot.data(), w.data()}; }

  test::Random random{3};
  typename G::Matrix stiffness = random.spd(dim), inertia = random.spd(dim);
  std::unique_ptr<ModalBody<G>> body;
  std::vector<G> H;
  Eigen::VectorXd v, vdot, w;
  ForceScale scale;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ModalBodyTest, Groups);

TYPED_TEST(ModalBodyTest, InternalForceHasThePowerOfTheElasticEnergy) {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(this->body->size());
  this->body->add_internal(this->state(), g.data(), this->scale);
  const double h = 1e-5, rate = (this->energy(h).elastic - this->energy(-h).elastic) / (2 * h);
  EXPECT_NEAR(g.dot(this->v), rate, 1e-7 * std::abs(rate));
}

/// Exactly where only the frame is held; else to first order: the velocities of the interfaces that
/// inertia sees are those of the frames up to the square of the displacements.
TYPED_TEST(ModalBodyTest, InertiaHasThePowerOfTheKineticEnergy) {
  const auto off = [this](double size) {
    this->move(size);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(this->body->size());
    this->body->add_inertia(this->state(), Body<TypeParam>::Vector::Zero(), g.data(), this->scale);
    const double h = 1e-5, rate = (this->energy(h).kinetic - this->energy(-h).kinetic) / (2 * h);
    return std::abs(g.dot(this->v) - rate) / std::abs(rate);
  };
  const double coarse = off(0.002), fine = off(0.001);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.05);
  this->body = this->make({0}, -1);
  EXPECT_LT(off(0.1), 1e-7);
}

TYPED_TEST(ModalBodyTest, MatricesAreThoseOfTheForcesAtReference) {
  this->H = this->body->reference;
  this->w.setZero();
  this->v.setZero();
  for (size_t j = 0; j < this->body->mass().nodes.size(); ++j)
    for (int i = 0; i < TypeParam::dim; ++i) {
      const int at = TypeParam::dim * this->body->mass().nodes[j] + i;
      this->vdot = Eigen::VectorXd::Unit(this->body->size(), at);
      Eigen::VectorXd g = Eigen::VectorXd::Zero(this->body->size());
      this->body->add_inertia(this->state(), Body<TypeParam>::Vector::Zero(), g.data(),
                              this->scale);
      const auto& M = this->body->mass();
      for (size_t k = 0; k < M.nodes.size(); ++k)
        EXPECT_LT(
            (M.dense.template block<TypeParam::dim, 1>(TypeParam::dim * k, TypeParam::dim * j + i) -
             g.template segment<TypeParam::dim>(TypeParam::dim * M.nodes[k]))
                .norm(),
            1e-12 * M.dense.norm())
            << j << " " << i << " " << k;
    }
}

TYPED_TEST(ModalBodyTest, AllModesMakeTheFrequenciesOfTheFreeBeam) {
  const auto& M = this->body->mass().dense;
  const auto& K = this->body->stiffness().dense;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> reduced(K, M);
  const auto fewer = this->make({0, 4}, 2 * TypeParam::dim);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> few(fewer->stiffness().dense,
                                                                      fewer->mass().dense);
  for (int i = 0; i < TypeParam::dim; ++i)
    EXPECT_NEAR(reduced.eigenvalues()[i], 0, 1e-9 * reduced.eigenvalues().maxCoeff());
  // The first elastic frequency of the reduced body is near to and not below that of all modes.
  const int first = TypeParam::dim;
  EXPECT_GT(few.eigenvalues()[first], reduced.eigenvalues()[first] * (1 - 1e-9));
  EXPECT_LT(few.eigenvalues()[first], reduced.eigenvalues()[first] * 1.02);
}

}  // namespace
}  // namespace liesl::test::modal_test
