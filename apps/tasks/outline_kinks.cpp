#include "apps/tasks/outline_kinks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <random>

#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

constexpr double kBeside = 1e-6;  // of a number: the other side of a kink

/// Do two derivatives of the fractions, one on each side, belong to a kink? Smooth ones differ by
/// about the share of a cell between them.
bool jumps(const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
  constexpr double kJump = 0.1;
  return (after - before).lpNorm<1>() > kJump * after.lpNorm<1>();
}

/// @param at which design it is, as in " at the start"  @param shift what would help
std::vector<std::string> one_sided(const std::string& part, const std::vector<std::string>& kinks,
                                   const char* at, const char* shift) {
  if (kinks.empty()) return {};
  return {fmt::format(
      "edges of the part '{}' that {} move{} lie on grid lines{}, where the fractions of cells "
      "have a kink and gradients hold to one side only: shift {} or the grid by a part of a cell",
      part, fmt::join(kinks, ", "), kinks.size() == 1 ? "s" : "", at, shift)};
}

Eigen::VectorXd numbers_of(const SolidSpec& solid) {
  return levelset::make_shape(solid.outline)->start();
}

/// Have the fractions of a part a kink where its numbers change by `slope` times a parameter?
/// @param step of the parameter
bool has_kink(const SolidSpec& solid, const Eigen::VectorXd& slope, double step) {
  const Eigen::VectorXd p = numbers_of(solid);
  const auto moved = [&](double by) {
    SolidSpec other = solid;
    set_values(other.outline, p + by * slope);
    return solid_fractions(other).value;
  };
  const Eigen::VectorXd here = solid_fractions(solid).value;
  return jumps((here - moved(-step)) / step, (moved(step) - here) / step);
}

const SolidSpec& solid_of(const Mechanism& mechanism, int body) {
  return std::get<SolidSpec>(mechanism.bodies[static_cast<std::size_t>(body)].kind);
}

}  // namespace

NearbyOutlines nearby_outlines(const Mechanism& mechanism, double by) {
  NearbyOutlines out{by, {}};
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
    if (const auto* solid = std::get_if<SolidSpec>(&mechanism.bodies[b].kind);
        solid && !solid->outline.features.empty())
      out.values[static_cast<int>(b)] = numbers_of(*solid);
  return out;
}

std::vector<std::string> kink_warnings(const SensitivityProblem& problem,
                                       const std::vector<NearbyOutlines>& nearby) {
  const auto kink = [&](std::size_t i, int body) {
    const SolidSpec& solid = solid_of(problem.scene.mechanism, body);
    const double p = problem.names[i].value;
    const Eigen::VectorXd slope = (nearby[i].values.at(body) - numbers_of(solid)) / nearby[i].by;
    return has_kink(solid, slope, kBeside * (p == 0 ? 1 : std::abs(p)));
  };
  std::map<int, std::vector<std::string>> kinks;  // by body
  for (std::size_t i = 0; i < problem.parameters.size(); ++i)
    for (const auto& part : problem.parameters[i].parts)
      if (const auto* solid = std::get_if<SolidDerivative>(&part); solid && kink(i, solid->body))
        kinks[solid->body].push_back(problem.parameters[i].name);
  std::vector<std::string> out;
  for (const auto& [body, names] : kinks) {
    const auto& part = problem.scene.mechanism.bodies[static_cast<std::size_t>(body)].name;
    for (auto& text : one_sided(part, names, "", "the outline")) out.push_back(std::move(text));
  }
  return out;
}

#ifdef LIESL_OPTIM

std::vector<std::string> outline_kinks(const PartShape& part, const Eigen::VectorXd& x,
                                       double within) {
  const auto& variables = part.design.variables();
  // Different shares, so that a position and a width do not leave an edge where it is.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  Eigen::VectorXd above = x, below = x;  // within the bounds: beyond them a shape need not exist
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const auto& v = variables[static_cast<std::size_t>(j)];
    const double step = within * share(random) * (v.upper - v.lower);
    above[j] = std::min(x[j] + step, v.upper);
    below[j] = std::max(x[j] - step, v.lower);
  }
  const Eigen::MatrixXd after = part.fraction_gradient(above),
                        before = part.fraction_gradient(below);
  part.shape->set(part.design.parameters(x));
  std::vector<std::string> names;
  for (Eigen::Index j = 0; j < x.size(); ++j)
    if (jumps(before.col(j), after.col(j)))
      names.push_back(variables[static_cast<std::size_t>(j)].name);
  return names;
}

std::vector<std::string> start_warnings(const std::string& name, const PartShape& part) {
  return one_sided(name, outline_kinks(part, part.design.start(), kBeside), " at the start",
                   "the start");
}

std::vector<std::string> start_warnings(const Design& start, const Mechanism& mechanism) {
  std::vector<std::string> out;
  for (int k = 0; k < start.parts(); ++k) {
    const PartShape& part = start.part(k);
    const BodySpec& body = mechanism.bodies[static_cast<std::size_t>(part.body)];
    for (auto& text : start_warnings(body.name, part)) out.push_back(std::move(text));
  }
  return out;
}

std::vector<std::string> end_warnings(const std::string& name, const PartShape& part,
                                      const Eigen::VectorXd& x) {
  const auto kinks = outline_kinks(part, x, 1e-3);
  if (kinks.empty()) return {};
  return {fmt::format(
      "edges of the part '{}' that {} move{} end on grid lines, where the fractions of cells have "
      "a kink: the optimum may lie there, and no gradient can say so; another grid has its kinks "
      "elsewhere",
      name, fmt::join(kinks, ", "), kinks.size() == 1 ? "s" : "")};
}

#endif

}  // namespace liesl
