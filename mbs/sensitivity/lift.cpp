#include "mbs/sensitivity/lift.hpp"

#include <algorithm>

namespace liesl {
namespace {

/// Of positions, in the axes of their nodes.
template <FrameGroup G>
void add_positions(const Model<G>& model, const NearbyModels<G>& nearby, const State<G>& s,
                   Eigen::Index column, StateSensitivity& out) {
  constexpr int sd = G::space_dim;
  for (const int node : model.positions()) {
    const int carrier = nearby.carriers()[static_cast<std::size_t>(node)], from = G::dim * carrier;
    const Eigen::Index at = G::dim * node;
    const typename Model<G>::Vector xi = nearby.lift().template segment<sd>(at);
    const typename G::Tangent v = s.v.template segment<G::dim>(from);
    const CarriedRates<G> real(v, s.vdot.template segment<G::dim>(from), xi),
        alike(v, s.a.template segment<G::dim>(from), xi);
    const SquareMatrix<sd> R = s.H[static_cast<std::size_t>(node)].R.transpose() *
                               s.H[static_cast<std::size_t>(carrier)].R;
    out.eta.col(column).template segment<sd>(at) = R * xi;
    out.v.col(column).template segment<sd>(at) = R * real.v;
    out.a.col(column).template segment<sd>(at) = R * alike.vdot;
    out.w.col(column).template segment<sd>(at) = R * real.vdot;
  }
}

}  // namespace

template <FrameGroup G>
bool lifted(const ParameterResidual<G>& parameter) {
  return parameter.nearby() && parameter.nearby()->lift().size() > 0;
}

template <FrameGroup G>
bool any_lifted(const Parameters<G>& parameters) {
  return std::any_of(parameters.begin(), parameters.end(), lifted<G>);
}

template <FrameGroup G>
StateSensitivity lift_of(const Model<G>& model, const Parameters<G>& parameters,
                         const State<G>& s) {
  auto out = StateSensitivity::zero(model.size(), model.constraints(),
                                    static_cast<int>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!lifted(parameters[i])) continue;
    const auto column = static_cast<Eigen::Index>(i);
    const Eigen::VectorXd& lift = parameters[i].nearby()->lift();
    for (const int node : model.frames()) {
      const Eigen::Index at = G::dim * node;
      const auto of = [&](const Eigen::VectorXd& x) ->
          typename G::Matrix { return G::ad(x.template segment<G::dim>(at)); };
      const typename G::Tangent xi = lift.template segment<G::dim>(at);
      out.eta.col(column).template segment<G::dim>(at) = xi;
      out.v.col(column).template segment<G::dim>(at) = of(s.v) * xi;
      out.a.col(column).template segment<G::dim>(at) = of(s.a) * xi;
      out.w.col(column).template segment<G::dim>(at) = of(s.vdot) * xi;
    }
    add_positions(model, *parameters[i].nearby(), s, column, out);
  }
  return out;
}

#define LIESL_INSTANTIATE(G)                            \
  template bool lifted<G>(const ParameterResidual<G>&); \
  template bool any_lifted<G>(const Parameters<G>&);    \
  template StateSensitivity lift_of<G>(const Model<G>&, const Parameters<G>&, const State<G>&);
LIESL_INSTANTIATE(SE2)
LIESL_INSTANTIATE(SE3)
#undef LIESL_INSTANTIATE

}  // namespace liesl
