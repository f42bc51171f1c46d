/// @file
/// States moved by increments: `retract` under every update, and `NodeCoordinates` beside it.

#include "mbs/solvers/node_coordinates.hpp"

#include <set>

#include "mbs/run.hpp"
#include "mbs/system/retract.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::node_coordinates_test {
namespace {

using Eigen::VectorXd;

/// Frames, amplitudes (the reduced rod) and positions (the block) side by side.
template <class G>
Mechanism all_kinds_of_nodes(Formalism formalism) {
  const int layers = G::space_dim == 3 ? 1 : 0;
  Mechanism m = slider_crank_with_mesh(4, 2, 2, layers);
  m.bodies.push_back({"block", continuum_block({0.4, 0.1, 0.05}, 2, 1, layers, steel())});
  m.formalism = formalism;
  return m;
}

template <class G>
class NodeCoordinatesTest : public ::testing::Test {
 protected:
  /// A model under one of the updates, a state of it and an increment.
  struct Moved {
    const Model<G> model;
    const NodeCoordinates<G> coordinates;
    State<G> from;
    VectorXd dq;

    explicit Moved(Formalism formalism)
        : model(Model<G>::build(all_kinds_of_nodes<G>(formalism),
                                space_of<G>(all_kinds_of_nodes<G>(formalism)))),
          coordinates(model, false),
          from(model.initial_state()) {
      Random random(11);
      coordinates.start(from);
      from = by(0.5 * random.vector(model.size()));
      dq = 0.5 * random.vector(model.size());
    }
    MovedNodes nodes() const { return {model.frames(), model.positions(), model.amplitudes()}; }
    State<G> by(const VectorXd& increment) const {
      State<G> to = from;
      retract(from, increment, model.update, nodes(), to);
      return to;
    }
    /// Without components that move nothing.
    VectorXd unknowns(const VectorXd& increment) const {
      VectorXd out = VectorXd::Zero(increment.size());
      for (const auto* whole : {&model.frames(), &model.amplitudes()})
        for (const int k : *whole)
          out.segment(G::dim * k, G::dim) = increment.segment(G::dim * k, G::dim);
      for (const int k : model.positions())
        out.segment(G::dim * k, G::space_dim) = increment.segment(G::dim * k, G::space_dim);
      return out;
    }
  };
};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(NodeCoordinatesTest, Groups);

constexpr Formalism kUpdates[] = {Formalism::SE3, Formalism::R3SO3, Formalism::Classical};

template <class G>
void expect_same(const State<G>& a, const State<G>& b) {
  ASSERT_EQ(a.H.size(), b.H.size());
  for (std::size_t k = 0; k < a.H.size(); ++k) {
    EXPECT_TRUE(a.H[k].R == b.H[k].R) << "node " << k;
    EXPECT_TRUE(a.H[k].x == b.H[k].x) << "node " << k;
  }
  EXPECT_TRUE(a.w == b.w);
}

TYPED_TEST(NodeCoordinatesTest, HasEveryUpdateAndEveryKindOfNode) {
  std::set<NodeUpdate> updates;
  for (const Formalism f : kUpdates) {
    const typename TestFixture::Moved moved(f);
    updates.insert(moved.model.update);
    EXPECT_GT(moved.model.frames().size(), 0u);
    EXPECT_GT(moved.model.positions().size(), 0u);
    EXPECT_GT(moved.model.amplitudes().size(), 0u);
  }
  EXPECT_EQ(updates.size(), 3u);
}

TYPED_TEST(NodeCoordinatesTest, DifferenceGivesTheIncrementBack) {
  for (const Formalism f : kUpdates) {
    const typename TestFixture::Moved moved(f);
    VectorXd found;
    moved.coordinates.difference(moved.from, moved.by(moved.dq), found);
    EXPECT_LT((found - moved.unknowns(moved.dq)).template lpNorm<Eigen::Infinity>(), 1e-13)
        << to_string(f);
  }
}

/// In place, as a step of the integrator and as a correction of statics: the same bits.
TYPED_TEST(NodeCoordinatesTest, WhoeverMovesAStateMovesItAlike) {
  using G = TypeParam;
  for (const Formalism f : kUpdates) {
    const typename TestFixture::Moved moved(f);
    const State<G> to = moved.by(moved.dq);
    State<G> in_place = moved.from, placed = moved.from;
    retract(in_place, moved.dq, moved.model.update, moved.nodes(), in_place);
    expect_same(in_place, to);
    moved.coordinates.place(moved.from, moved.dq, moved.from.v, moved.from.vdot, placed);
    expect_same(placed, to);
    State<G> corrected = moved.from, screwed = moved.from;
    moved.model.retract(corrected, moved.dq);
    retract(moved.from, moved.dq, NodeUpdate::Screw, moved.nodes(), screwed);
    expect_same(corrected, screwed);
  }
}

/// dq + h e moves a state by dq, then by the left-invariant increment h delta, up to h^2.
TYPED_TEST(NodeCoordinatesTest, IncrementIsTheDerivativeByLeftInvariantOnes) {
  using G = TypeParam;
  for (const Formalism f : kUpdates) {
    const typename TestFixture::Moved moved(f);
    const State<G> to = moved.by(moved.dq);
    const VectorXd delta = Random(3).vector(moved.model.size());
    VectorXd e = VectorXd::Zero(delta.size());
    moved.coordinates.increment(to, moved.dq, delta, e);
    const auto off = [&](double h) {
      const State<G> a = moved.by(moved.dq + h * e);
      State<G> b = to;
      moved.model.retract(b, h * delta);
      double sum = 0;
      for (std::size_t k = 0; k < a.H.size(); ++k)
        sum += G::log(b.H[k].inverse() * a.H[k]).squaredNorm();
      for (const int k : moved.model.amplitudes())
        sum += (a.w - b.w).segment(G::dim * k, G::dim).squaredNorm();
      return std::sqrt(sum);
    };
    EXPECT_LT(off(1e-3), 1e-4) << to_string(f);
    EXPECT_NEAR(off(1e-3) / off(5e-4), 4, 0.05) << to_string(f);
  }
}

}  // namespace
}  // namespace liesl::test::node_coordinates_test
