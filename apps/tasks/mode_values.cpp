#include "apps/tasks/mode_values.hpp"

#include <algorithm>
#include <array>

#include "apps/tasks/body_series.hpp"
#include "apps/tasks/collect_reference.hpp"
#include "mbs/system/equations.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {
namespace {

constexpr double kPart = 1e-4;  // of the shape that is shown, over which values are differenced
constexpr std::array kInner = {&output::BodyResult::strains, &output::BodyResult::section_forces,
                               &output::BodyResult::stresses};

/// Values at the same part of every shape.
template <FrameGroup G>
output::Results values_at(const Scene& scene, const Model<G>& model, const State<G>& equilibrium,
                          const Eigen::MatrixXd& shapes, double part,
                          const output::Results& results) {
  output::Results out;
  out.bodies = results.bodies;
  for (auto& body : out.bodies)
    for (const auto series : output::kBodySeries) (body.*series).clear();
  out.responses.resize(scene.responses.size());
  BodySeries<G> bodies(scene.mechanism, model, static_cast<std::size_t>(shapes.cols()), nullptr,
                       out);
  const ResponseValues<G> values(scene.mechanism, model);
  const Equations<G> equations(model);
  for (const auto& shape : shapes.colwise()) {
    State<G> s = equilibrium;
    s.lambda.setZero();  // those of the mode are not known
    model.retract(s, part * shape);
    model.complete(s);
    equations.observe(s, equilibrium.rows, s.rows);
    bodies.add(s);
    for (std::size_t i = 0; i < out.responses.size(); ++i)
      append(out.responses[i].values, values(scene.responses[i], s));
  }
  return out;
}

/// Values at rest, and at half of and all of the part.
using Samples = std::array<output::Results, 3>;

/// The one-sided derivative of second order, exact for parabolas; of energies the parabola.
/// @param of a list of numbers in a sample
template <class List>
std::vector<double> change(const Samples& at, bool energy, const List& of) {
  std::vector<double> out(of(at[0]).size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double half = of(at[1])[i] - of(at[0])[i], whole = of(at[2])[i] - of(at[0])[i];
    out[i] = (4 * half - whole) / kPart;
    if (energy) out[i] += 2 * (whole - 2 * half) / (kPart * kPart);
  }
  return out;
}

/// The largest norm of a response over the modes.
void find_peak(const std::vector<double>& frequencies, output::ResponseResult& response) {
  response.peak.reset();
  const Eigen::Map<const Eigen::MatrixXd> y(response.values.data(), response.components,
                                            static_cast<Eigen::Index>(frequencies.size()));
  for (Eigen::Index n = 0; n < y.cols(); ++n)
    if (!response.peak || y.col(n).norm() > response.peak->size)
      response.peak = output::Peak{y.col(n).norm(), frequencies[static_cast<std::size_t>(n)]};
}

}  // namespace

template <FrameGroup G>
void set_mode_values(const Scene& scene, const Model<G>& model, const State<G>& equilibrium,
                     const Eigen::MatrixXd& shapes, output::Results& results) {
  const auto at = [&](double part) {
    return values_at(scene, model, equilibrium, shapes, part, results);
  };
  const Samples samples = {at(0), at(kPart / 2), at(kPart)};
  for (std::size_t i = 0; i < results.responses.size(); ++i) {
    const ResponseKind kind = scene.responses[i].kind;
    const bool energy = kind == ResponseKind::Energy || kind == ResponseKind::Compliance;
    output::ResponseResult& response = results.responses[i];
    response.values = change(
        samples,
        energy, [i](const output::Results& r) -> const auto& { return r.responses[i].values; });
    find_peak(results.times, response);
  }
  for (std::size_t b = 0; b < results.bodies.size(); ++b) {
    output::BodyResult& body = results.bodies[b];
    for (const auto series : kInner)
      body.*series = change(
          samples,
          false, [&](const output::Results& r) -> const auto& { return r.bodies[b].*series; });
    if (!body.stresses.empty())
      body.largest_stress = *std::max_element(body.stresses.begin(), body.stresses.end());
  }
  results.peaks.clear();
  for (std::size_t i = 0; i < std::min(results.responses.size(), output::kPeaks); ++i)
    if (const auto& peak = results.responses[i].peak)
      results.peaks.push_back(results.record_near(peak->at));
}

template void set_mode_values(const Scene&, const Model<SE2>&, const State<SE2>&,
                              const Eigen::MatrixXd&, output::Results&);
template void set_mode_values(const Scene&, const Model<SE3>&, const State<SE3>&,
                              const Eigen::MatrixXd&, output::Results&);

}  // namespace liesl
