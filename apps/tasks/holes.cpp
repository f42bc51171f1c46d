#ifdef LIESL_OPTIM

#include "apps/tasks/holes.hpp"

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
                 {"kept", h.kept},
                 {"objective_before", h.before},
                 {"objective", h.after},
                 {"cycles", h.cycles},
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

}  // namespace liesl

#endif
