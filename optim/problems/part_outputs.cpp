#include "optim/problems/part_outputs.hpp"

#include "esl/static_part.hpp"
#include "mbs/model/beam_ends.hpp"
#include "mbs/system/end_force.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/problems/element_stress.hpp"

namespace liesl {
namespace {

/// Gradient of a response with respect to the increments of its body at the reference shape.
template <FrameGroup G>
Eigen::MatrixXd gradient_at_rest(const ResponseSpec& r, const Mechanism& mechanism,
                                 const Model<G>& model) {
  constexpr int dim = G::dim;
  const auto gradients = ResponseValues<G>(mechanism, model).gradient(r, model.initial_state());
  const int body = deformed_body(r), first = model.first_node(body);
  const int nodes = model.bodies[body]->nodes(), count = static_cast<int>(gradients.size());
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(dim * nodes, count);
  for (int i = 0; i < count; ++i)
    for (const auto& node : gradients[i].nodes)
      if (node.node >= first && node.node < first + nodes)
        c.col(i).template segment<dim>(dim * (node.node - first)) = node.h;
  return c;
}

/// A deflection `everywhere` is one at each inner node k.
ResponseSpec at_node(ResponseSpec r, int k, int elements) {
  r.everywhere = false;
  r.s = static_cast<double>(k) / elements;
  return r;
}

}  // namespace

ResponseSpec response_of(const Limit& limit, const ResponseSpec& limited, int elements) {
  if (limit.node >= 0) return at_node(limited, limit.node, elements);
  ResponseSpec r = limited;
  if (limit.element >= 0) {
    r.element = limit.element;
    r.point = limit.point;
  }
  return r;
}

template <FrameGroup G>
PartOutputs limited_outputs(const StudySpec& study, const Mechanism& mechanism,
                            const Model<G>& model, int body) {
  PartOutputs out;
  const BeamChain<G>& beam = *BeamChain<G>::of(*model.bodies[body]);
  out.C.resize(beam.size(), 0);
  const auto append = [&out](const Eigen::MatrixXd& c) {
    const auto first = out.C.cols();
    out.C.conservativeResize(Eigen::NoChange, first + c.cols());
    out.C.rightCols(c.cols()) = c;
    return static_cast<int>(first);
  };
  const auto add = [&](int constraint, const ResponseSpec& r, int node) {
    const Eigen::MatrixXd c = gradient_at_rest(r, mechanism, model);
    out.limits.push_back({constraint, 0, append(c), static_cast<int>(c.cols()), -1, -1, node});
  };
  int compliance = -1;
  for (size_t i = 0; i < study.constraints.size(); ++i) {
    const ResponseSpec& r = study.constraints[i].response;
    const int index = static_cast<int>(i);
    if (!study.constraints[i].has_image || deformed_body(r) != body) continue;
    if (r.kind == ResponseKind::Stress) {
      const auto& spec = std::get<BeamSpec>(mechanism.bodies[body].kind);
      for (int e = 0; e < beam.elements(); ++e) {
        const int half = static_cast<int>(element_stress_points(spec, std::size_t(e)).size()) / 2;
        for (int end = 0; end < 2; ++end) {
          const int first = append(StaticPart<G>::strain_output(beam, e));
          for (int p = 0; p < half; ++p)
            out.limits.push_back({index, 0, first, G::dim, e, half * end + p});
        }
      }
    } else if (r.kind == ResponseKind::Compliance) {
      compliance = index;
    } else if (r.everywhere) {
      for (int k = 1; k < beam.elements(); ++k) add(index, at_node(r, k, beam.elements()), k);
    } else {
      add(index, r, -1);
    }
  }
  out.compliance = compliance >= 0;
  if (out.compliance) out.limits.push_back({compliance, 0, static_cast<int>(out.C.cols()), 1});
  return out;
}

template <FrameGroup G>
Eigen::MatrixXd dynamic_outputs(const PartOutputs& outputs, const StudySpec& study,
                                const Mechanism& mechanism, const Model<G>& model,
                                const Trajectory<G>& trajectory, int body) {
  const ResponseValues<G> values(mechanism, model);
  const BeamChain<G>& beam = *BeamChain<G>::of(*model.bodies[body]);
  const EndForce<G> end_force(model, body);
  const int elements = beam.elements();
  Eigen::MatrixXd y(outputs.count(), trajectory.size());
  State<G> s = model.initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    int filled = -1;  // outputs that several limits share are read once
    int node = 0;
    for (const auto& limit : outputs.limits) {
      if (limit.first <= filled) continue;
      filled = limit.first;
      auto out = y.col(n).segment(limit.first, limit.count);
      const ResponseSpec& r = study.constraints[limit.constraint].response;
      if (limit.element >= 0) {
        const auto end = limit.point == 0 ? ElementPlace::First : ElementPlace::Last;
        out = ElementStress<G>::strain_of(
            beam, limit.element, end,
            end_force(*model.bodies[body], model.body_state(s, body), limit.element, end));
      } else if (r.everywhere) {
        node = node + 1 < elements ? node + 1 : 1;
        out = values(at_node(r, node, elements), s);
      } else {
        out = values(r, s);
      }
    }
  }
  return y;
}

template PartOutputs limited_outputs(const StudySpec&, const Mechanism&, const Model<SE2>&, int);
template PartOutputs limited_outputs(const StudySpec&, const Mechanism&, const Model<SE3>&, int);
template Eigen::MatrixXd dynamic_outputs(const PartOutputs&, const StudySpec&, const Mechanism&,
                                         const Model<SE2>&, const Trajectory<SE2>&, int);
template Eigen::MatrixXd dynamic_outputs(const PartOutputs&, const StudySpec&, const Mechanism&,
                                         const Model<SE3>&, const Trajectory<SE3>&, int);

}  // namespace liesl
