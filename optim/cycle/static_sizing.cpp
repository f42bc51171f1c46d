#include "optim/cycle/static_sizing.hpp"

#include <algorithm>
#include <limits>

namespace liesl {

namespace {

std::vector<int> beams_among(const std::vector<int>& bodies, const Mechanism& mechanism) {
  std::vector<int> beams;
  for (const int b : bodies)
    if (std::holds_alternative<BeamSpec>(mechanism.bodies[b].kind)) beams.push_back(b);
  return beams;
}

/// The static problem of a part is the same whatever the motion was simulated with: at reference
/// the straight beams of all formalisms have one stiffness. Empty if the model will do.
template <FrameGroup G>
std::optional<Model<G>> beams_of(const Analysis<G>& at) {
  Mechanism m = at.mechanism;
  bool same = m.formalism == Formalism::SE3;
  m.formalism = Formalism::SE3;
  for (auto& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) {
      same = same && beam->as == BeamModel::AsFormalism;
      beam->as = BeamModel::AsFormalism;
    }
  if (same) return std::nullopt;
  return Model<G>::build(m, at.model->space);
}

}  // namespace

template <FrameGroup G>
StaticSizing<G>::StaticSizing(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study,
                              const Eigen::VectorXd& x0, double move)
    : sizing_(sizing),
      study_(study),
      counted_(beams_among(study.mass_of, at.mechanism)),
      mechanism_(at.mechanism),
      parts_model_(beams_of(at)),
      model_(parts_model_ ? *parts_model_ : *at.model),
      space_(at.model->space) {
  variables_ = sizing.variables();
  for (int i = 0; i < sizing.size(); ++i) {
    variables_[i].start = x0[i];
    variables_[i].lower = std::max(variables_[i].lower, x0[i] * (1 - move));
    variables_[i].upper = std::min(variables_[i].upper, x0[i] * (1 + move));
  }
  make_parts(at);
  for (auto& part : parts_) retain_all(part);
  solve_parts();
  for (auto& part : parts_)
    part.correction =
        dynamic_outputs(part.outputs, study, at.mechanism, model_, *at.trajectory, part.body) -
        part.y;
  keep(near_largest(all_values(), screened(), study.cycle));
}

template <FrameGroup G>
void StaticSizing<G>::make_parts(const Analysis<G>& at) {
  for (const auto& loads : *at.loads) {
    const auto& beam = dynamic_cast<const BeamChain<G>&>(*model_.bodies[loads.body]);
    PartOutputs outputs = limited_outputs(study_, at.mechanism, model_, loads.body);
    for (auto limit : outputs.limits) {
      limit.part = static_cast<int>(parts_.size());
      limits_.push_back(limit);
      const ResponseKind kind = study_.constraints[limit.constraint].response.kind;
      second_derivatives_ &= kind != ResponseKind::Stress && kind != ResponseKind::Compliance;
    }
    const auto support = study_.supports.find(loads.body);
    PartSupport held = read_support(support == study_.supports.end() ? Support{} : support->second,
                                    at.mechanism, model_, loads.body);
    StaticPart<G> problem(beam, std::move(held), outputs.C);
    Part part{loads.body, &beam, &loads, std::move(outputs), std::move(problem), {}, {}, {},
              {},         {},    {}};
    for (int e = 0; e < beam.elements(); ++e)
      part.align.push_back(space_.alignment(at.mechanism.frame({loads.body, e, SE3::identity()})));
    parts_.push_back(std::move(part));
  }
}

template <FrameGroup G>
typename StaticSizing<G>::Law StaticSizing<G>::section_stiffness(const Part& part) const {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
  Law law;
  for (size_t e = 0; e < beam.sections.size(); ++e)
    law.push_back(space_.reduce_law(section_law(beam.sections[e], beam.material).K, part.align[e]));
  return law;
}

template <FrameGroup G>
typename StaticSizing<G>::Law StaticSizing<G>::stiffness(const Part& part) const {
  Law law;
  for (size_t e = 0; e < part.section.size(); ++e)
    law.push_back(part.beam->rest_stiffness_of(static_cast<int>(e), part.section[e]));
  return law;
}

template <FrameGroup G>
bool StaticSizing<G>::solve(const Eigen::VectorXd& x) {
  sizing_.apply(x, mechanism_);
  return solve_parts();
}

/// Outputs of all parts and what their stresses need, with the sections of `mechanism_`.
template <FrameGroup G>
bool StaticSizing<G>::solve_parts() {
  for (auto& part : parts_) {
    part.section = section_stiffness(part);
    if (!part.problem.solve(stiffness(part))) return false;
    part.y.resize(part.outputs.count(), part.problem.cases());
    part.y.topRows(part.problem.outputs()) = part.problem.y();
    if (part.outputs.compliance) part.y.bottomRows(1) = part.problem.compliance();
    part.stress.clear();
    const auto& limits = part.outputs.limits;
    if (std::none_of(limits.begin(), limits.end(), [](const Limit& l) { return l.element >= 0; }))
      continue;
    const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
    for (size_t e = 0; e < beam.sections.size(); ++e)
      part.stress.emplace_back(*part.beam, static_cast<int>(e), beam.sections[e], beam.material,
                               space_, part.align[e]);
  }
  return true;
}

template <FrameGroup G>
double StaticSizing<G>::limit_value(const Limit& limit, const Eigen::VectorXd& y,
                                    Eigen::VectorXd* slope) const {
  if (limit.element >= 0) {
    typename G::Tangent d = G::Tangent::Zero();
    const double v =
        parts_[limit.part].stress[limit.element].value(limit.point, y, slope ? &d : nullptr);
    if (slope) *slope = d;
    return v;
  }
  const double v = y.norm();
  if (slope) *slope = v > 0 ? Eigen::VectorXd(y / v) : Eigen::VectorXd::Zero(y.size());
  return v;
}

template <FrameGroup G>
Eigen::VectorXd StaticSizing<G>::outputs_of(const Limit& limit, int kept) const {
  const Part& part = parts_[limit.part];
  return part.y.col(kept).segment(limit.first, limit.count) +
         part.correction.col(part.kept[kept]).segment(limit.first, limit.count);
}

template <FrameGroup G>
bool StaticSizing<G>::in_mass(int body) const {
  return std::find(counted_.begin(), counted_.end(), body) != counted_.end();
}

/// What a derivative of an element's section law adds to that of the objective.
template <FrameGroup G>
double StaticSizing<G>::mass_slope(const SectionLaw& derivative, SizedElement at) const {
  if (!in_mass(at.body)) return 0;
  return derivative.M(0, 0) *
         element_length(std::get<BeamSpec>(mechanism_.bodies[at.body].kind), at.element);
}

template <FrameGroup G>
void StaticSizing<G>::values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
  const bool solved = solve(x);
  f = mass_of(mechanism_, counted_);
  for (size_t i = 0; i < retained_.rows.size(); ++i) {
    const Limit& limit = limits_[retained_.rows[i].limit];
    g[static_cast<int>(i)] =
        solved ? limit_value(limit, outputs_of(limit, retained_.rows[i].kept), nullptr) /
                         limit_of(limit) -
                     1
               : std::numeric_limits<double>::quiet_NaN();
  }
}

template class StaticSizing<SE2>;
template class StaticSizing<SE3>;

}  // namespace liesl
