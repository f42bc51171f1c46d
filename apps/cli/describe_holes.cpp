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

void describe_holes(output::OptimizeSummary& summary, const Holes& holes) {
  Json tried = Json::array();
  for (const HoleRound& h : holes.tried) {
    Json hole = {{"feature", h.feature}, {"kept", h.pays},   {"objective_before", h.before},
                 {"objective", h.after}, {"steps", h.steps}, {"reason", h.reason}};
    hole.update(of_nucleus(h.nucleus));
    tried.push_back(hole);
  }
  Json next = nullptr;
  if (holes.next) {
    next = {{"part", holes.part}};
    next.update(of_nucleus(*holes.next));
  }
  summary.more["nucleation"] = {{"next", next},
                                {"reason", holes.reason},
                                {"gain_unit", holes.unit + "/m^3"},
                                {"tried", tried}};
}

void print_holes(const Holes& holes, int most) {
  for (const HoleRound& h : holes.tried)
    fmt::print("  {}: {:.6g} {} -> {:.6g} {}, {}\n", h.feature, h.before, holes.unit, h.after,
               holes.unit, h.pays ? "kept" : "taken out again (" + h.reason + ")");
  if (const auto& n = holes.next)
    fmt::print(
        "  a hole in '{}' would pay at ({:.4g}, {:.4g}, {:.4g}) m, {:.4g} {} per m^3 at first "
        "(experimental): {}\n",
        holes.part, n->place[0], n->place[1], n->place[2], n->gain, holes.unit,
        most > 0 ? "--nucleate with a larger number" : "--nucleate inserts it");
  else if (!holes.reason.empty())
    fmt::print("  no hole is proposed: {}\n", holes.reason);
}

}  // namespace liesl

#endif
