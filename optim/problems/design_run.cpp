#include "optim/problems/design_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mbs/system/response_value.hpp"
#include "optim/problems/frequency_problem.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {
namespace {

/// Beams that carry limits, and meshed parts whose outline changes.
std::vector<int> loaded_bodies(const StudySpec& study, const Mechanism& mechanism) {
  std::vector<int> bodies;
  for (const int b : limited_bodies(study))
    if (std::holds_alternative<BeamSpec>(mechanism.bodies[b].kind)) bodies.push_back(b);
  for (const auto& [body, spec] : study.shapes) bodies.push_back(body);
  return bodies;
}

/// Limits hold at every step, whatever is recorded of a run of the scene. Sensitivities belong to
/// converged states: an error of 1e-6 in them is one of 1e-4 in a gradient.
constexpr double kConverged = 1e-8;

SimulationOptions options_of(SimulationOptions options, CycleMethod method) {
  options.output_every = 1;
  if (method != CycleMethod::Esl) options.tolerance = std::min(options.tolerance, kConverged);
  return options;
}

}  // namespace

template <FrameGroup G>
std::vector<double> DesignRun<G>::times() const {
  std::vector<double> t;
  for (int n = 0; n < simulation.trajectory.size(); ++n) t.push_back(simulation.trajectory.time(n));
  return t;
}

template <FrameGroup G>
DesignSimulator<G>::DesignSimulator(const Mechanism& mechanism, const Space<G>& space,
                                    const SimulationOptions& options, const StudySpec& study)
    : mechanism_(mechanism),
      space_(space),
      options_(options_of(options, study.cycle.method)),
      study_(study),
      design_(study, mechanism),
      bodies_(loaded_bodies(study, mechanism)) {}

template <FrameGroup G>
std::string DesignRun<G>::instant(double t) const {
  return statics ? fmt::format("load factor {:.6g}", t) : fmt::format("t = {:.6g} s", t);
}

template <FrameGroup G>
DesignRun<G> DesignSimulator<G>::run(const Eigen::VectorXd& x, const Progress& progress) const {
  DesignRun<G> r;
  r.mechanism = design_.apply(mechanism_, x);
  r.model = std::make_shared<Model<G>>(Model<G>::build(r.mechanism, space_));
  r.mass = mass_of(r.mechanism, study_.mass_of);
  const SimulationOptions options = design_.simulation(options_, x);
  r.duration = options.duration;
  r.pose_time = options.at;
  r.statics = options.type == SimulationType::Static;
  r.simulation = run_simulation(*r.model, options, progress, &r.tape);
  if (!r.good()) return r;
  extract(r);
  measure(r);
  measure_frequencies(r);
  measure_masses(r);
  measure_walls(r, x);
  return r;
}

template <FrameGroup G>
void DesignSimulator<G>::extract(DesignRun<G>& r) const {
  const auto& motion = r.simulation.trajectory;
  for (const int body : bodies_)
    if (std::holds_alternative<SolidSpec>(r.mechanism.bodies[body].kind))
      r.solid_loads.push_back(extract_solid_loads(*r.model, motion, body));
    else
      r.loads.push_back(extract_loads(*r.model, motion, body));
}

template <FrameGroup G>
void DesignSimulator<G>::measure_frequencies(DesignRun<G>& r) const {
  if (study_.frequencies.empty()) return;
  const Mechanism mechanism = with_multipliers(r.mechanism);
  const LimitedModes modes(mechanism, options_, study_.frequencies);
  r.undefined = modes.reason;
  for (std::size_t l = 0; l < study_.frequencies.size(); ++l) {
    const FrequencyLimitSpec& limit = study_.frequencies[l];
    const double lowest = modes.frequency(l, 0);
    r.frequencies.push_back({limit.name, limit.least, lowest, limit.weight > 0});
    if (limit.weight > 0) continue;
    r.add({limit.name, 1 - lowest / limit.least, ""});
  }
}

template <FrameGroup G>
void DesignSimulator<G>::measure_masses(DesignRun<G>& r) const {
  for (const MassLimitSpec& limit : study_.mass_limits) {
    r.masses.push_back({limit.name, limit.limit, mass_of(r.mechanism, limit.bodies)});
    r.add({limit.name, r.masses.back().value / limit.limit - 1, ""});
  }
}

/// A wall that is too thin counts as a limit that is violated all the time.
template <FrameGroup G>
void DesignSimulator<G>::measure_walls(DesignRun<G>& r, const Eigen::VectorXd& x) const {
  for (int k = 0; k < design_.parts(); ++k) {
    PartShape& part = design_.part(k);
    part.shape->set(part.design.parameters(design_.of_part(k, x)));
    const Eigen::VectorXd walls = part.design.walls();
    if (walls.size() == 0) continue;
    Eigen::Index worst = 0;
    const double excess = walls.maxCoeff(&worst);
    r.add({part.design.wall_names()[static_cast<std::size_t>(worst)], excess, ""});
  }
}

/// The true responses at every record.
template <FrameGroup G>
void DesignSimulator<G>::measure(DesignRun<G>& r) const {
  const ResponseValues<G> values(r.mechanism, *r.model);
  const auto& trajectory = r.simulation.trajectory;
  State<G> s = r.model->initial_state();
  for (const auto& c : study_.constraints)
    r.limits.push_back({c.response.name, c.limit, {}, 0, 0, 0, c.weight > 0});
  const std::vector<double> weights = time_weights(r.times());
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    for (const ResponseSpec& response : study_.motion_objective.responses)
      r.effort += r.duration * weights[std::size_t(n)] * values(response, s).squaredNorm();
    for (size_t i = 0; i < study_.constraints.size(); ++i) {
      const double v = values(study_.constraints[i].response, s).norm();
      LimitSeries& series = r.limits[i];
      series.values.push_back(v);
      if (v > series.largest) {
        series.largest = v;
        series.at_time = s.t;
      }
    }
  }
  const std::vector<double> times = r.times();
  for (std::size_t i = 0; i < r.limits.size(); ++i)
    r.limits[i].measure = treated_value(study_.constraints[i], times, r.limits[i].values);
  for (const auto& series : r.limits)
    if (!series.in_objective)
      r.add({series.name, series.measure / series.limit - 1, r.instant(series.at_time)});
}

template <FrameGroup G>
double load_change(const DesignRun<G>& run, const DesignRun<G>& before) {
  double change = 0;
  if (!run.loads.empty())
    change = load_change(run.loads, before.loads, G::dim, G::space_dim, run.model->length);
  for (std::size_t k = 0; k < run.solid_loads.size(); ++k)
    change = std::max(change, load_change(run.solid_loads[k], before.solid_loads[k]));
  return change;
}

template double load_change(const DesignRun<SE2>&, const DesignRun<SE2>&);
template double load_change(const DesignRun<SE3>&, const DesignRun<SE3>&);
template struct DesignRun<SE2>;
template struct DesignRun<SE3>;
template class DesignSimulator<SE2>;
template class DesignSimulator<SE3>;

}  // namespace liesl
