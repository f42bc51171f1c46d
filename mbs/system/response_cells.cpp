/// @file
/// Stress of a meshed part: the largest over its cells, v^(1/2) times the von Mises stress of the
/// material at their centres.

#include "mbs/solids/stress_norm.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

template <FrameGroup G>
bool ResponseValues<G>::is_meshed(int body) const {
  return std::holds_alternative<SolidSpec>(mechanism_.bodies[static_cast<std::size_t>(body)].kind);
}

template <FrameGroup G>
auto ResponseValues<G>::largest_cell(int body, const State<G>& s) const -> CellAt {
  const Body<G>& part = *model_.bodies[static_cast<std::size_t>(body)];
  const Eigen::VectorXd shares = part.stress_shares();
  CellAt at;
  if (shares.size() == 0) return at;  // rigid
  const Eigen::MatrixXd stresses = part.cell_stresses(model_.body_state(s, body));
  const Eigen::RowVectorXd sizes = von_mises(stresses);
  shares.cwiseProduct(sizes.transpose()).maxCoeff(&at.cell);
  at.share = shares[at.cell];
  at.sigma = stresses.col(at.cell);
  at.size = sizes[at.cell];
  return at;
}

template <FrameGroup G>
void ResponseValues<G>::add_cell_stress(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const CellAt largest = largest_cell(r.body, at.s);
  if (largest.value() == 0) return;
  model_.bodies[static_cast<std::size_t>(r.body)]->add_cell_stress_gradient(
      model_.body_state(at.unknowns, r.body), largest.cell,
      largest.share * von_mises_gradient(largest.sigma),
      out.unknown_h.data() + G::dim * model_.first_node(r.body));
}

/// share' sigma_vM + share (d sigma_vM/d sigma) . sigma'.
template <FrameGroup G>
double ResponseValues<G>::cell_stress_by(const ResponseSpec& r, const State<G>& s,
                                         const ParameterResidual<G>& parameter) const {
  const Body<G>* by = parameter.body(r.body);
  if (!by) return 0;
  const CellAt largest = largest_cell(r.body, s);
  if (largest.value() == 0) return 0;
  const Eigen::VectorXd change = by->cell_stress(model_.body_state(s, r.body), largest.cell);
  return by->stress_shares()[largest.cell] * largest.size +
         largest.share * von_mises_gradient(largest.sigma).dot(change);
}

/// share_n sigma_vM + share (d sigma_vM/d sigma) . sigma_n, n of the neighbour: differences as
/// `cell_stress_by`.
template <FrameGroup G>
double ResponseValues<G>::cell_stress_of_neighbour(const ResponseSpec& r, const State<G>& s,
                                                   const ResponseValues& neighbour,
                                                   const State<G>& seen) const {
  const CellAt largest = largest_cell(r.body, s);
  if (largest.value() == 0) return 0;
  const Body<G>& part = *neighbour.model_.bodies[static_cast<std::size_t>(r.body)];
  const Eigen::VectorXd sigma =
      part.cell_stress(neighbour.model_.body_state(seen, r.body), largest.cell);
  return part.stress_shares()[largest.cell] * largest.size +
         largest.share * von_mises_gradient(largest.sigma).dot(sigma);
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;

}  // namespace liesl
