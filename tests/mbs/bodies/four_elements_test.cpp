/// @file
/// Four elements at once against the same elements one by one.

#include "mbs/bodies/four_elements.hpp"

#include "mbs/bodies/beam.hpp"
#include "mbs/run.hpp"

namespace liesl::test::four_elements_test {
namespace {

/// A chain in motion, bent by up to `angle` an element.
template <class G>
struct Chain {
  static constexpr int size = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Tangent = typename G::Tangent;
  using Pair = typename FourthOrderElement<G>::Pair;
  using Vector = typename Body<G>::Vector;
  static constexpr double damping = 0.03;

  test::Random random{7};
  FourthOrderBeam<G> body;
  std::vector<G> H;
  Eigen::VectorXd v, vdot;
  Vector gravity;

  Chain(int elements, double angle)
      : body("chain", nodes(elements), sections(elements), damping),
        v(random.vector(size * (elements + 1))),
        vdot(random.vector(size * (elements + 1))),
        gravity(random.vector(sd)) {
    Tangent move = Tangent::Zero();
    for (const G& at_rest : body.reference) {
      H.push_back(at_rest * G::exp(move));
      move += 0.05 * random.vector(size);
      move.template tail<rd>() += angle * random.vector(rd);
    }
  }
  std::vector<G> nodes(int elements) {
    std::vector<G> at{G::exp(Tangent(random.vector(size)))};
    for (int e = 0; e < elements; ++e) {
      Tangent d = 0.1 * random.vector(size);
      d[0] = 1.2;
      at.push_back(at.back() * G::exp(d));
    }
    return at;
  }
  std::vector<ElementSection<G>> sections(int elements) {
    std::vector<ElementSection<G>> all(elements);
    for (auto& s : all) {
      s.K.setZero();
      s.M.setZero();
      s.K.template topLeftCorner<sd, sd>() = random.spd(sd);
      s.K.template bottomRightCorner<rd, rd>() = random.spd(rd);
      s.M.template topLeftCorner<sd, sd>().diagonal().setConstant(1.7);
      s.M.template bottomRightCorner<rd, rd>() = random.spd(rd);
    }
    return all;
  }
  BodyState<G> state() const { return {H.data(), v.data(), vdot.data()}; }

  /// Forces, their scale and energies, as the body has them and by its elements.
  struct Sums {
    Eigen::VectorXd inertia, internal;
    ForceScale of_inertia, of_internal;
    BodyEnergy energy;

    explicit Sums(Eigen::Index unknowns)
        : inertia(Eigen::VectorXd::Zero(unknowns)), internal(Eigen::VectorXd::Zero(unknowns)) {}
  };
  Sums of_body() const {
    Sums s(v.size());
    body.add_inertia(state(), gravity, s.inertia.data(), s.of_inertia);
    body.add_internal(state(), s.internal.data(), s.of_internal);
    s.energy = body.energy(state(), gravity);
    return s;
  }
  Sums by_elements() const {
    Sums s(v.size());
    for (int e = 0; e < body.elements(); ++e) {
      const auto& element = body.element(e);
      const double* rates = v.data() + size * e;
      Pair a, g;
      a << apparent_acceleration<G>(state(), e, gravity),
          apparent_acceleration<G>(state(), e + 1, gravity);
      element.inertia_force(H[e], H[e + 1], rates, a, g);
      s.inertia.template segment<2 * size>(size * e) += g;
      s.of_inertia.template add<G>(g.template head<size>());
      s.of_inertia.template add<G>(g.template tail<size>());
      element.internal_force(H[e], H[e + 1], rates, damping, g);
      s.internal.template segment<2 * size>(size * e) += g;
      s.of_internal.template add<G>(g.template head<size>());
      s.energy.kinetic += element.kinetic_energy(H[e], H[e + 1], rates);
      s.energy.elastic += element.elastic_energy(H[e], H[e + 1]);
      s.energy.potential += element.weight_potential(H[e], H[e + 1], gravity);
    }
    return s;
  }
};

/// K, C and M with these weights, by the elements; about section forces that are given, or their
/// own.
template <class G>
BodyMatrix<G::dim> tangent_by_elements(const Chain<G>& chain, TangentWeights w,
                                       const typename G::Tangent* stress) {
  constexpr int size = G::dim;
  BodyMatrix<size> A(chain.body.nodes());
  for (int e = 0; e < chain.body.elements(); ++e) {
    const auto& element = chain.body.element(e);
    const G &first = chain.H[e], &last = chain.H[e + 1];
    const double* rates = chain.v.data() + size * e;
    typename Chain<G>::Pair a;
    a << apparent_acceleration<G>(chain.state(), e, chain.gravity),
        apparent_acceleration<G>(chain.state(), e + 1, chain.gravity);
    const typename G::Tangent n = stress ? stress[e] : element.stress(first, last);
    A.add_element(e, w.stiffness * element.inertia_stiffness(first, last, rates, a, chain.gravity));
    A.add_element(e, w.stiffness * element.damped_tangent(first, last, n, rates, chain.damping));
    A.add_element(e, w.damping * element.gyroscopic_tangent(first, last, rates));
    A.add_element(e, w.damping * element.damping_tangent(first, last, rates, chain.damping));
    A.add_element(e, w.mass * element.mass(first, last));
  }
  return A;
}

template <int N>
double largest_difference(const BodyMatrix<N>& A, const BodyMatrix<N>& B) {
  double difference = 0, size = 0;
  const auto compare = [&](const auto& a, const auto& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      difference = std::max(difference, (a[i] - b[i]).norm());
      size = std::max(size, b[i].norm());
    }
  };
  compare(A.D, B.D);
  compare(A.U, B.U);
  compare(A.L, B.L);
  return difference / size;
}

template <class G>
class FourElementsTest : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(FourElementsTest, Groups);

void expect_equal(double a, double b) { EXPECT_NEAR(a, b, 1e-13 * std::abs(b)); }

/// Chains that fill lanes and that do not; elements that turn little, and such that the logarithm
/// of some, or of all, is not that of small angles.
TYPED_TEST(FourElementsTest, EqualTheElementsOneByOne) {
  for (const double angle : {0.01, 0.3, 1.0})
    for (const int elements : {1, 2, 3, 4, 5, 7, 8, 13}) {
      SCOPED_TRACE(std::to_string(elements) + " elements, angle " + std::to_string(angle));
      const Chain<TypeParam> chain(elements, angle);
      const auto grouped = chain.of_body(), one_by_one = chain.by_elements();
      EXPECT_LE((grouped.inertia - one_by_one.inertia).norm(), 1e-13 * one_by_one.inertia.norm());
      EXPECT_LE((grouped.internal - one_by_one.internal).norm(),
                1e-13 * one_by_one.internal.norm());
      expect_equal(grouped.of_inertia.force, one_by_one.of_inertia.force);
      expect_equal(grouped.of_inertia.moment, one_by_one.of_inertia.moment);
      expect_equal(grouped.of_internal.force, one_by_one.of_internal.force);
      expect_equal(grouped.of_internal.moment, one_by_one.of_internal.moment);
      expect_equal(grouped.energy.kinetic, one_by_one.energy.kinetic);
      expect_equal(grouped.energy.elastic, one_by_one.energy.elastic);
      expect_equal(grouped.energy.potential, one_by_one.energy.potential);
    }
}

TYPED_TEST(FourElementsTest, HaveTheStrainsAndEndForcesOfTheElements) {
  using Tangent = typename TypeParam::Tangent;
  for (const double angle : {0.01, 0.3, 1.0})
    for (const int elements : {1, 4, 7}) {
      SCOPED_TRACE(std::to_string(elements) + " elements, angle " + std::to_string(angle));
      const Chain<TypeParam> chain(elements, angle);
      const Tangent none = Tangent::Zero();
      std::vector<Tangent> strains(chain.body.elements(), none);
      std::vector<std::array<Tangent, 2>> forces(chain.body.elements(), {none, none});
      chain.body.all_strains(chain.state(), strains.data());
      chain.body.all_end_forces(chain.state(), forces.data());
      for (int e = 0; e < elements; ++e) {
        const Tangent strain = chain.body.strain(chain.state(), e);
        EXPECT_LE((strains[e] - strain).norm(), 1e-13 * strain.norm());
        for (const auto end : {ElementPlace::First, ElementPlace::Last}) {
          const Tangent force = chain.body.section_force(chain.state(), e, end);
          EXPECT_LE((forces[e][node_of(end)] - force).norm(), 1e-12 * force.norm());
        }
      }
    }
}

TYPED_TEST(FourElementsTest, HaveTheTangentsOfTheElements) {
  using G = TypeParam;
  using Stress = const typename G::Tangent*;
  for (const double angle : {0.01, 0.3})
    for (const int elements : {1, 4, 6}) {
      Chain<G> chain(elements, angle);
      typename Body<G>::Stresses given(static_cast<std::size_t>(elements));
      for (auto& n : given) n = chain.random.vector(G::dim);
      for (const typename G::Tangent* stress : {Stress(nullptr), Stress(given.data())}) {
        for (const TangentWeights w :
             {TangentWeights{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2., 0.7, 0.3}}) {
          BodyMatrix<G::dim> A(chain.body.nodes());
          chain.body.exact_tangent(chain.state(), chain.gravity, w, stress, A);
          EXPECT_LE(largest_difference(A, tangent_by_elements(chain, w, stress)), 1e-13);
        }
        BodyMatrix<G::dim> K(chain.body.nodes()), C = K, M = K;
        chain.body.exact_tangents(chain.state(), chain.gravity, stress, K, C, M);
        EXPECT_LE(largest_difference(K, tangent_by_elements(chain, {0, 0, 1}, stress)), 1e-13);
        EXPECT_LE(largest_difference(C, tangent_by_elements(chain, {0, 1, 0}, stress)), 1e-13);
        EXPECT_LE(largest_difference(M, tangent_by_elements(chain, {1, 0, 0}, stress)), 1e-13);
      }
    }
}

/// A section that couples stretch and bending in space is not taken four at a time.
TEST(FourElements, LeaveCoupledSections) {
  Chain<SE3> chain(4, 0.1);
  const FourthOrderElement<SE3>& of = chain.body.element(0);
  EXPECT_TRUE(FourElements<SE3>::takes(of));
  const FourthOrderElement<SE3> coupled(chain.H[0], chain.H[1], chain.random.spd(6),
                                        of.section_inertia());
  EXPECT_FALSE(FourElements<SE3>::takes(coupled));
}

}  // namespace
}  // namespace liesl::test::four_elements_test
