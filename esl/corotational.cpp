#include "esl/corotational.hpp"

namespace liesl {
namespace {

/// Half-way between two nodes.
template <FrameGroup G>
G middle(const G& A, const G& B) {
  using Rotation = RotationOf<G>;
  return {A.R * Rotation::exp(0.5 * Rotation::log(A.R.transpose() * B.R)), 0.5 * (A.x + B.x)};
}

}  // namespace

template <FrameGroup G>
void add_corotational_force(const BeamChain<G>& beam, const G* H, double* f) {
  constexpr int dim = G::dim, sd = G::space_dim;
  for (int e = 0; e < beam.elements(); ++e) {
    const G* X = &beam.reference[e];
    const G to_reference = middle(X[0], X[1]) * middle(H[e], H[e + 1]).inverse();
    Eigen::Matrix<double, 2 * dim, 1> u;
    SquareMatrix<sd> turned[2];
    for (int k = 0; k < 2; ++k) {
      const G Y = to_reference * H[e + k];
      turned[k] = X[k].R.transpose() * Y.R;
      u.template segment<dim>(dim * k) << X[k].R.transpose() * (Y.x - X[k].x),
          RotationOf<G>::log(turned[k]);
    }
    const Eigen::Matrix<double, 2 * dim, 1> g = beam.constant_tangent(e) * u;
    for (int k = 0; k < 2; ++k) {
      Eigen::Map<typename G::Tangent> out(f + dim * (e + k));
      out.template head<sd>() += turned[k].transpose() * g.template segment<sd>(dim * k);
      if constexpr (G::rotation_dim == 3)
        out.template tail<3>() += turned[k].transpose() * g.template segment<3>(dim * k + sd);
      else
        out[sd] += g[dim * k + sd];
    }
  }
}

template void add_corotational_force(const BeamChain<SE2>&, const SE2*, double*);
template void add_corotational_force(const BeamChain<SE3>&, const SE3*, double*);

}  // namespace liesl
