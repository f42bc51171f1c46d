#include "mbs/sensitivity/lift.hpp"

#include <algorithm>

namespace liesl {

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
    const NearbyModels<G>& nearby = *parameters[i].nearby();
    const auto add = [&](int node) {
      const Eigen::Index at = G::dim * node;
      const auto real = nearby.direction(s, s.vdot, node);
      out.eta.col(column).template segment<G::dim>(at) = real.eta;
      out.v.col(column).template segment<G::dim>(at) = real.v;
      out.w.col(column).template segment<G::dim>(at) = real.rate;
      out.a.col(column).template segment<G::dim>(at) = nearby.direction(s, s.a, node).rate;
    };
    for (const int node : model.frames()) add(node);
    for (const int node : model.positions()) add(node);
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
