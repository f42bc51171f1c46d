#ifdef LIESL_OPTIM

#include "apps/cli/describe_holes.hpp"

#include <fmt/format.h>

namespace liesl {
namespace {

using Json = nlohmann::ordered_json;

Json of_nucleus(const Nucleus& n) {
  return {{"place", {n.place[0], n.place[1], n.place[2]}}, {"radius", n.radius}, {"gain", n.gain}};
}

}  // namespace

std::vector<std::string> body_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const BodySpec& body : mechanism.bodies) names.push_back(body.name);
  return names;
}

void describe_holes(output::OptimizeSummary& summary, const Holes& holes) {
  Json tried = Json::array();
  for (const HoleRound& h : holes.tried) {
    Json hole = {{"part", holes.bodies[std::size_t(h.body)]},
                 {"feature", h.feature},
                 {"kept", h.pays},
                 {"objective_before", h.before},
                 {"objective", h.after},
                 {"steps", h.steps},
                 {"reason", h.reason}};
    hole.update(of_nucleus(h.nucleus));
    tried.push_back(hole);
  }
  Json next = nullptr;
  if (holes.next) {
    next = {{"part", holes.bodies[std::size_t(holes.body)]}};
    next.update(of_nucleus(*holes.next));
  }
  summary.more["nucleation"] = {{"next", next},
                                {"reason", holes.reason},
                                {"gain_unit", holes.unit + "/m^3"},
                                {"tried", tried}};
}

void print_hole(const std::string& feature, const Nucleus& n, bool quiet) {
  if (quiet) return;
  fmt::print("      {} at ({:.4g}, {:.4g}, {:.4g}) m\n", feature, n.place[0], n.place[1],
             n.place[2]);
}

void print_holes(const Holes& holes, int most) {
  for (const HoleRound& h : holes.tried)
    fmt::print("  {} in '{}': {:.6g} {} -> {:.6g} {}, {}\n", h.feature,
               holes.bodies[std::size_t(h.body)], h.before, holes.unit, h.after, holes.unit,
               h.pays ? "kept" : "taken out again (" + h.reason + ")");
  if (const auto& n = holes.next)
    fmt::print(
        "  a hole in '{}' would pay at ({:.4g}, {:.4g}, {:.4g}) m, {:.4g} {} per m^3 at first "
        "(experimental): {}\n",
        holes.bodies[std::size_t(holes.body)], n->place[0], n->place[1], n->place[2], n->gain,
        holes.unit, most > 0 ? "--nucleate with a larger number" : "--nucleate inserts it");
  else if (!holes.reason.empty())
    fmt::print("  no hole is proposed: {}\n", holes.reason);
}

}  // namespace liesl

#endif
