#include "apps/tasks/motion_gradient.hpp"

#include <cmath>
#include <limits>

namespace liesl {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <FrameGroup G>
TapedMotion<G>::TapedMotion(const Mechanism& of, const Space<G>& space,
                            const SimulationOptions& options,
                            const std::vector<ResponseSpec>& responses, const Progress& progress)
    : mechanism(of), model(Model<G>::build(mechanism, space)) {
  const ResponseValues<G> values(mechanism, model);
  std::vector<double> t;
  std::vector<std::vector<double>> y(responses.size());
  const auto observe = [&](const State<G>& s, bool record) {
    t.push_back(s.t);
    if (record) recorded.push_back(s.t);
    for (std::size_t r = 0; r < responses.size(); ++r) {
      const VectorXd now = values(responses[r], s);
      y[r].insert(y[r].end(), now.data(), now.data() + now.size());
    }
  };
  simulation = run_simulation<G>(model, options, progress, &tape, observe);
  const auto steps = static_cast<Index>(t.size());
  times = Eigen::Map<const VectorXd>(t.data(), steps);
  for (const auto& of_response : y)
    histories.emplace_back(
        steps == 0
            ? MatrixXd()
            : MatrixXd(Eigen::Map<const MatrixXd>(
                  of_response.data(), static_cast<Index>(of_response.size()) / steps, steps)));
}

template <FrameGroup G>
FunctionalValue functional_value(const TapedMotion<G>& motion, std::size_t response,
                                 const FunctionalSpec& functional, int peak) {
  return evaluate(functional, motion.times, motion.histories[response], peak);
}

namespace {

/// The functionals of all responses, and their gradients so far.
struct Functionals {
  std::vector<std::vector<FunctionalValue>> of;  ///< by response
  MatrixXd gradient;                             ///< n_p x all of them, response by response
  int each = 0;

  /// dJ/dy_n of those of a response, components x functionals.
  MatrixXd weights(std::size_t response, long step) const {
    const auto& values = of[response];
    MatrixXd w(values.front().by_y.rows(), each);
    for (int f = 0; f < each; ++f) w.col(f) = values[static_cast<std::size_t>(f)].by_y.col(step);
    return w;
  }
};

/// dy/dp at the records, and dJ/dp = sum_n dJ/dy_n dy_n/dp.
template <FrameGroup G>
SensitivityEnd direct(const TapedMotion<G>& motion, const Parameters<G>& parameters,
                      const std::vector<ResponseSensitivity<G>>& responses,
                      Functionals& functionals, output::Sensitivities& out) {
  out.derivatives.resize(responses.size());
  std::size_t record = 0;
  return direct_sensitivity<G>(
      motion.model, motion.tape, parameters, [&](long step, const State<G>& s, const auto& ds) {
        const bool records = record < motion.recorded.size() && s.t == motion.recorded[record];
        for (std::size_t r = 0; r < responses.size(); ++r) {
          const MatrixXd dy = responses[r](s, ds);
          functionals.gradient.middleCols(static_cast<int>(r) * functionals.each,
                                          functionals.each) +=
              dy.transpose() * functionals.weights(r, step);
          if (!records) continue;
          for (Index c = 0; c < dy.rows(); ++c)
            for (Index p = 0; p < dy.cols(); ++p) out.derivatives[r].push_back(dy(c, p));
        }
        record += records;
      });
}

template <FrameGroup G>
SensitivityEnd adjoint(const TapedMotion<G>& motion, const Parameters<G>& parameters,
                       const std::vector<ResponseSensitivity<G>>& responses,
                       Functionals& functionals) {
  const int all = functionals.each * static_cast<int>(responses.size());
  return adjoint_sensitivity<G>(
      motion.model, motion.tape, parameters, all,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd& gradient) {
        for (std::size_t r = 0; r < responses.size(); ++r) {
          const MatrixXd weights = functionals.weights(r, step);
          if (!weights.isZero(0))
            responses[r].add_cotangents(s, weights, static_cast<int>(r) * functionals.each, bars,
                                        gradient);
        }
      },
      functionals.gradient);
}

}  // namespace

template <FrameGroup G>
SensitivityEnd differentiate(const TapedMotion<G>& motion, const SensitivityProblem& problem,
                             const SensitivityRequest& request, SensitivityMethod method,
                             output::Sensitivities& out) {
  const auto& specs = problem.scene.responses;
  Parameters<G> parameters;
  for (const Parameter& p : problem.parameters)
    parameters.emplace_back(motion.mechanism, motion.model, p);
  const ResponseValues<G> values(motion.mechanism, motion.model);
  std::vector<ResponseSensitivity<G>> responses;
  Functionals functionals;
  functionals.each = static_cast<int>(request.functionals.size());
  for (std::size_t r = 0; r < specs.size(); ++r) {
    responses.emplace_back(motion.model, values, specs[r], parameters);
    auto& of = functionals.of.emplace_back();
    for (const FunctionalSpec& f : request.functionals)
      of.push_back(functional_value(motion, r, f));
  }
  const auto count = static_cast<Index>(specs.size()) * functionals.each;
  functionals.gradient.setZero(static_cast<Index>(parameters.size()), count);
  const SensitivityEnd end = method == SensitivityMethod::Direct
                                 ? direct(motion, parameters, responses, functionals, out)
                                 : adjoint(motion, parameters, responses, functionals);
  Index column = 0;
  for (std::size_t r = 0; r < specs.size(); ++r)
    for (std::size_t f = 0; f < request.functionals.size(); ++f, ++column) {
      const FunctionalValue& value = functionals.of[r][f];
      auto by_p = functionals.gradient.col(column);
      if (request.functionals[f].kind == FunctionalKind::Integral)  // its weights are steps
        for (Index p = 0; p < by_p.size(); ++p)
          by_p[p] += parameters[static_cast<std::size_t>(p)].step() * value.value;
      out.gradients.push_back(
          {specs[r].name, to_string(request.functionals[f]),
           unit(request.functionals[f], unit(specs[r], motion.mechanism)), value.value,
           value.step < 0 ? std::numeric_limits<double>::quiet_NaN() : motion.times[value.step],
           std::vector<double>(by_p.data(), by_p.data() + by_p.size())});
    }
  return end;
}

template struct TapedMotion<SE2>;
template struct TapedMotion<SE3>;
template FunctionalValue functional_value(const TapedMotion<SE2>&, std::size_t,
                                          const FunctionalSpec&, int);
template FunctionalValue functional_value(const TapedMotion<SE3>&, std::size_t,
                                          const FunctionalSpec&, int);
template SensitivityEnd differentiate(const TapedMotion<SE2>&, const SensitivityProblem&,
                                      const SensitivityRequest&, SensitivityMethod,
                                      output::Sensitivities&);
template SensitivityEnd differentiate(const TapedMotion<SE3>&, const SensitivityProblem&,
                                      const SensitivityRequest&, SensitivityMethod,
                                      output::Sensitivities&);

}  // namespace liesl
