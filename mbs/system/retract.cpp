#include "mbs/system/retract.hpp"

#include "liegroup/rotation.hpp"

namespace liesl {

template <FrameGroup G>
void retract(const State<G>& from, const Eigen::Ref<const Eigen::VectorXd>& dq, NodeUpdate update,
             const MovedNodes& nodes, State<G>& to) {
  constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Rot = RotationOf<G>;
  using Angular = typename Rot::Vector;
  if (update == NodeUpdate::Screw) {
    for (const int k : nodes.frames)
      to.H[k] = from.H[k] * G::exp(dq.template segment<dim>(dim * k));
  } else {
    const bool vector = update == NodeUpdate::RotationVector;
    for (const int k : nodes.frames) {
      Angular turn = dq.template segment<rd>(dim * k + sd);
      to.H[k].x = from.H[k].x + dq.template segment<sd>(dim * k);
      if (vector) {
        turn += from.w.template segment<rd>(dim * k + sd);
        to.w.template segment<rd>(dim * k + sd) = turn;
      }
      to.H[k].R = vector ? Rot::exp(turn) : (from.H[k].R * Rot::exp(turn)).eval();
    }
  }
  for (const int k : nodes.positions) {
    to.H[k].R = from.H[k].R;
    to.H[k].x.noalias() = from.H[k].x + from.H[k].R * dq.template segment<sd>(dim * k);
  }
  for (const int k : nodes.amplitudes)
    to.w.template segment<dim>(dim * k) =
        from.w.template segment<dim>(dim * k) + dq.template segment<dim>(dim * k);
}

template void retract(const State<SE2>&, const Eigen::Ref<const Eigen::VectorXd>&, NodeUpdate,
                      const MovedNodes&, State<SE2>&);
template void retract(const State<SE3>&, const Eigen::Ref<const Eigen::VectorXd>&, NodeUpdate,
                      const MovedNodes&, State<SE3>&);

}  // namespace liesl
