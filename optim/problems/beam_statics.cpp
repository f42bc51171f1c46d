#include "optim/problems/beam_statics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mbs/model/beam_ends.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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
BeamStatics<G>::BeamStatics(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study,
                            double move)
    : sizing_(sizing),
      study_(study),
      move_(move),
      counted_(beams_among(study.mass_of, at.mechanism)),
      mechanism_(at.mechanism),
      parts_model_(beams_of(at)),
      model_(parts_model_ ? *parts_model_ : *at.model),
      space_(at.model->space) {
  for (const LoadSet& loads : *at.loads) make_part(at, loads);
}

template <FrameGroup G>
void BeamStatics<G>::make_part(const Analysis<G>& at, const LoadSet& loads) {
  const auto& beam = *BeamChain<G>::of(*model_.bodies[loads.body]);
  PartOutputs outputs = limited_outputs(study_, at.mechanism, model_, loads.body);
  add_limits(outputs, loads.body);
  auto& labels = cases_.emplace_back();
  for (const double t : loads.t) labels.push_back(fmt::format("t = {:.6g} s", t));
  const auto support = study_.supports.find(loads.body);
  PartSupport held = read_support(support == study_.supports.end() ? Support{} : support->second,
                                  at.mechanism, model_, loads.body);
  StaticPart<G> problem(beam, std::move(held), outputs.C);
  MatrixXd measured =
      dynamic_outputs(outputs, study_, at.mechanism, model_, *at.trajectory, loads.body);
  Part part{loads.body,
            &beam,
            &loads,
            std::move(outputs),
            std::move(problem),
            {},
            std::move(measured),
            {},
            {},
            {},
            {}};
  for (int e = 0; e < beam.elements(); ++e)
    part.align.push_back(space_.alignment(at.mechanism.frame({loads.body, e, SE3::identity()})));
  parts_.push_back(std::move(part));
}

template <FrameGroup G>
void BeamStatics<G>::add_limits(const PartOutputs& outputs, int body) {
  for (const Limit& l : outputs.limits) {
    const ConstraintSpec& c = study_.constraints[l.constraint];
    outputs_of_limit_.push_back(l);
    outputs_of_limit_.back().part = static_cast<int>(parts_.size());
    const bool many = l.element >= 0;
    limits_.push_back(
        {c.response.name,
         {l.constraint, static_cast<int>(parts_.size()), many, c.limit},
         l.first,
         l.count,
         LimitedResponse{.constraint = l.constraint,
                         .response = response_of(l, c.response, model_.bodies[body]->elements()),
                         .treatment = c.treatment}});
    second_derivatives_ &= !ResponseValues<G>::depends_on_law(c.response.kind);
  }
}

template <FrameGroup G>
std::vector<NlpVariable> BeamStatics<G>::variables(const VectorXd& x0) const {
  std::vector<NlpVariable> out = sizing_.variables();
  for (int i = 0; i < sizing_.size(); ++i) {
    out[i].start = x0[i];
    out[i].lower = std::max(out[i].lower, x0[i] * (1 - move_));
    out[i].upper = std::min(out[i].upper, x0[i] * (1 + move_));
  }
  return out;
}

template <FrameGroup G>
void BeamStatics<G>::retain(const std::vector<std::vector<int>>& kept) {
  for (size_t p = 0; p < parts_.size(); ++p)
    parts_[p].problem.set_loads(kept_columns(parts_[p].loads->f, kept[p]));
}

template <FrameGroup G>
typename BeamStatics<G>::Law BeamStatics<G>::section_stiffness(const Part& part) const {
  const BeamSpec& beam = beam_of(part);
  Law law;
  for (size_t e = 0; e < beam.sections.size(); ++e)
    law.push_back(space_.reduce_law(section_law(beam.sections[e], beam.material).K, part.align[e]));
  return law;
}

template <FrameGroup G>
std::string BeamStatics<G>::solve(const VectorXd& x) {
  sizing_.apply(x, mechanism_);
  for (Part& part : parts_)
    if (std::string reason = solve_part(part); !reason.empty()) return reason;
  return {};
}

/// Outputs and what stresses need, with the sections of `mechanism_`.
template <FrameGroup G>
std::string BeamStatics<G>::solve_part(Part& part) const {
  const BeamSpec& beam = beam_of(part);
  part.section = section_stiffness(part);
  Law stiffness;
  for (size_t e = 0; e < part.section.size(); ++e)
    stiffness.push_back(part.beam->rest_stiffness_of(static_cast<int>(e), part.section[e]));
  if (!part.problem.solve(stiffness))
    return "a section of '" + mechanism_.bodies[part.body].name + "' has no stiffness";
  part.y.resize(part.outputs.count(), part.problem.cases());
  part.y.topRows(part.problem.outputs()) = part.problem.y();
  if (part.outputs.compliance) part.y.bottomRows(1) = part.problem.compliance();
  part.stress.clear();
  const auto& limits = part.outputs.limits;
  if (std::any_of(limits.begin(), limits.end(), [](const Limit& l) { return l.element >= 0; }))
    for (size_t e = 0; e < beam.sections.size(); ++e)
      part.stress.emplace_back(*part.beam, static_cast<int>(e), beam, space_, part.align[e]);
  return {};
}

template <FrameGroup G>
double BeamStatics<G>::value(int limit, const VectorXd& y, VectorXd* slope) const {
  const Limit& l = outputs_of_limit_[limit];
  if (l.element < 0) return PartStatics::value(limit, y, slope);
  typename G::Tangent d = G::Tangent::Zero();
  const double v = parts_[l.part].stress[l.element].value(l.point, y, slope ? &d : nullptr);
  if (slope) *slope = d;
  return v;
}

template <FrameGroup G>
double BeamStatics<G>::explicit_slope(int limit, const VectorXd& y, int i) const {
  const Limit& l = outputs_of_limit_[limit];
  if (l.element < 0) return 0;
  const Part& part = parts_[l.part];
  const auto change = part.changes.find({l.element, i});
  return change == part.changes.end()
             ? 0
             : part.stress[l.element].explicit_slope(l.point, y, change->second);
}

template <FrameGroup G>
bool BeamStatics<G>::in_mass(int body) const {
  return std::find(counted_.begin(), counted_.end(), body) != counted_.end();
}

/// What a derivative of an element's section law adds to that of the objective.
template <FrameGroup G>
double BeamStatics<G>::mass_slope(const SectionLaw& derivative, SizedElement at) const {
  if (!in_mass(at.body)) return 0;
  return derivative.M(0, 0) *
         element_length(std::get<BeamSpec>(mechanism_.bodies[at.body].kind), at.element);
}

template <FrameGroup G>
void BeamStatics<G>::objective_gradient(VectorXd& df) {
  for (int i = 0; i < sizing_.size(); ++i)
    for (const auto& at : sizing_.elements(i))
      if (in_mass(at.body)) df[i] += mass_slope(sizing_.derivative(mechanism_, i, at), at);
}

template <FrameGroup G>
typename G::Matrix BeamStatics<G>::section_derivative(const Part& part, int i,
                                                      SizedElement at) const {
  return space_.reduce_law(sizing_.derivative(mechanism_, i, at).K, part.align[at.element]);
}

template <FrameGroup G>
typename G::Matrix BeamStatics<G>::stiffness_derivative(const Part& part, int i,
                                                        SizedElement at) const {
  return part.beam->rest_stiffness_by(at.element, part.section[at.element],
                                      section_derivative(part, i, at));
}

/// By variable and element; empty where a variable does not touch the part.
template <FrameGroup G>
std::vector<typename BeamStatics<G>::Law> BeamStatics<G>::stiffness_derivatives(
    const Part& part) const {
  std::vector<Law> dK(sizing_.size());
  for (int i = 0; i < sizing_.size(); ++i)
    for (const auto& at : sizing_.elements(i)) {
      if (at.body != part.body) continue;
      if (dK[i].empty()) dK[i].assign(part.align.size(), G::Matrix::Zero());
      dK[i][at.element] = stiffness_derivative(part, i, at);
    }
  return dK;
}

template <FrameGroup G>
typename BeamStatics<G>::StressChange BeamStatics<G>::stress_change(const Part& part, int i,
                                                                    SizedElement at) const {
  const BeamSpec& beam = beam_of(part);
  StressChange change;
  change.dK = stiffness_derivative(part, i, at);
  for (const auto& name : sizing_.dimensions(i)) {
    const auto dS = element_stress_derivative(beam, std::size_t(at.element), name);
    change.dS.resize(dS.size(), Eigen::Matrix<double, 3, 6>::Zero());
    for (size_t k = 0; k < dS.size(); ++k) change.dS[k] += dS[k];
  }
  return change;
}

/// By the form that costs fewer solutions.
template <FrameGroup G>
std::vector<MatrixXd> BeamStatics<G>::output_gradients(int p) {
  Part& part = parts_[p];
  const bool direct = part.problem.direct_is_cheaper(sizing_.size());
  const std::vector<Law> dK = stiffness_derivatives(part);
  std::vector<MatrixXd> out;
  part.changes.clear();
  for (int i = 0; i < sizing_.size(); ++i) {
    MatrixXd& dy = out.emplace_back(MatrixXd::Zero(part.outputs.count(), part.problem.cases()));
    if (dK[i].empty()) continue;
    if (direct) part.problem.add_gradient_direct(dK[i], dy);
    for (const auto& at : sizing_.elements(i)) {
      if (at.body != part.body) continue;
      const Matrix& dK_s = dK[i][at.element];
      if (!direct) part.problem.add_gradient(at.element, dK_s, dy);
      if (part.outputs.compliance)
        dy.bottomRows(1) += part.problem.compliance_gradient(at.element, dK_s);
      if (!part.stress.empty()) part.changes[{at.element, i}] = stress_change(part, i, at);
    }
  }
  return out;
}

/// Second derivatives of the section laws by pair of variables j <= i, where both act.
template <FrameGroup G>
typename BeamStatics<G>::SecondLaws BeamStatics<G>::second_laws() const {
  const int n = sizing_.size();
  SecondLaws second(n);
  for (int i = 0; i < n; ++i) {
    second[i].resize(n);
    for (int j = 0; j <= i; ++j)
      for (const auto& a : sizing_.elements(i))
        for (const auto& b : sizing_.elements(j))
          if (a.body == b.body && a.element == b.element)
            second[i][j].push_back({a, sizing_.second_derivative(mechanism_, i, j, a)});
  }
  return second;
}

template <FrameGroup G>
void BeamStatics<G>::add_second(double sigma, const std::vector<MatrixXd>& weights,
                                MatrixXd& h) const {
  const int n = sizing_.size();
  const SecondLaws second = second_laws();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      for (const auto& [at, law] : second[i][j]) h(i, j) += sigma * mass_slope(law, at);
  for (size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    typename StaticPart<G>::Second d2K(n, std::vector<Law>(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        for (const auto& [at, law] : second[i][j]) {
          if (at.body != part.body) continue;
          if (d2K[i][j].empty()) d2K[i][j].assign(part.align.size(), G::Matrix::Zero());
          d2K[i][j][at.element] = part.beam->rest_stiffness_second(
              at.element, part.section[at.element], section_derivative(part, i, at),
              section_derivative(part, j, at), space_.reduce_law(law.K, part.align[at.element]));
        }
    part.problem.add_second(stiffness_derivatives(part), d2K, weights[p], h);
  }
}

template class BeamStatics<SE2>;
template class BeamStatics<SE3>;

}  // namespace liesl
