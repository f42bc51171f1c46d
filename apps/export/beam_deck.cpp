#ifdef LIESL_OPTIM

#include "apps/export/beam_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {
namespace {

const output::BodyResult& recorded(const EslOutcome& esl, const std::string& part) {
  for (const output::BodyResult& body : esl.run.results.bodies)
    if (body.name == part) return body;
  throw std::invalid_argument("'" + part + "' was not recorded");
}

const BeamLoads& loads_of(const EslOutcome& esl, const std::string& part) {
  for (const BeamLoads& beam : esl.beams)
    if (beam.name == part) return beam;
  throw std::invalid_argument("'" + part +
                              "' has no loads; expected a flexible beam (a rigid one has none)");
}

/// Frames of the nodes of a body at a record.
std::vector<SE3> frames_at(const output::BodyResult& body, std::size_t record) {
  const auto N = static_cast<std::size_t>(body.nodes);
  std::vector<SE3> out;
  for (std::size_t k = 0; k < N; ++k) {
    const double* R = body.rotations.data() + 9 * (N * record + k);
    const double* x = body.positions.data() + 3 * (N * record + k);
    out.emplace_back(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R), Vec3(x));
  }
  return out;
}

/// Largest offset of a node from the chord of the beam at rest and now, m.
double largest_offset(const std::vector<SE3>& nodes) {
  double largest = 0;
  const int last = static_cast<int>(nodes.size()) - 1;
  for (int k = 1; k < last; ++k)
    largest = std::max(largest, chord_offset(nodes, static_cast<double>(k) / last).norm());
  return largest;
}

BeamDeck::Case case_at(const BeamDeck& deck, const BeamLoads& loads, const std::vector<SE3>& now,
                       std::size_t record) {
  BeamDeck::Case out;
  out.time = loads.set.t[record];
  const SE3 back = deck.nodes[0] * now[0].inverse();
  for (std::size_t k = 0; k < deck.nodes.size(); ++k) {
    const SE3 there = back * now[k];
    const double* f = loads.values.data() + 6 * (deck.nodes.size() * record + k);
    out.force.push_back(there.R * Vec3(f));
    out.moment.push_back(there.R * Vec3(f + 3));
    out.displacement.push_back(there.x - deck.nodes[k].x);
  }
  return out;
}

void require_shapes(const BeamDeck& deck) {
  for (const Section& section : deck.sections)
    if (std::holds_alternative<FullSection>(section.shape))
      throw std::invalid_argument("section '" + section.name +
                                  "' is given by its matrices; expected a shape, which other "
                                  "programs have, too");
}

}  // namespace

BeamDeck beam_deck(const Scene& scene, const EslOutcome& esl, const std::string& part,
                   DeckCases cases) {
  BeamDeck deck;
  const int number = scene.mechanism.body(part);
  if (number < 0) throw std::invalid_argument("there is no body '" + part + "'");
  const BeamLoads& loads = loads_of(esl, part);
  const auto& beam =
      std::get<BeamSpec>(scene.mechanism.bodies[static_cast<std::size_t>(number)].kind);
  deck.part = part;
  deck.scene = scene.mechanism.name;
  deck.words.equilibrium = scene.simulation.type != SimulationType::Dynamic;
  deck.material = beam.material;
  deck.sections = beam.sections;
  deck.nodes = beam.nodes;
  deck.identity = loads.identity;
  deck.model = model_of(beam, scene.mechanism.formalism);
  require_shapes(deck);
  for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e)
    deck.middles.push_back(beam.nodes[e] *
                           SE3::exp(0.5 * SE3::log(beam.nodes[e].inverse() * beam.nodes[e + 1])));
  const output::BodyResult& body = recorded(esl, part);
  const std::size_t records = loads.set.t.size();
  if (body.positions.size() != 3 * static_cast<std::size_t>(body.nodes) * records)
    throw std::invalid_argument("'" + part +
                                "' was not kept at every record; expected results without a sink");
  if (records == 0) throw std::invalid_argument("'" + part + "' has no load case");
  std::vector<double> offsets;
  for (std::size_t n = 0; n < records; ++n) offsets.push_back(largest_offset(frames_at(body, n)));
  std::set<int> kept;
  if (cases == DeckCases::Peaks) kept = treated_records(Treatment::Maxima, offsets);
  if (kept.empty())
    for (std::size_t n = 0; n < records; ++n) kept.insert(static_cast<int>(n));
  for (const int n : kept) {
    const auto record = static_cast<std::size_t>(n);
    deck.cases.push_back(case_at(deck, loads, frames_at(body, record), record));
    deck.cases.back().deflection = offsets[record];
  }
  return deck;
}

namespace {

/// Of shapes of one kind: sections of a taper share their name.
bool same_dimensions(const Shape& a, const Shape& b) {
  const auto names = dimensions(a);
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
    return dimension(a, name) == dimension(b, name);
  });
}

}  // namespace

std::vector<SectionGroup> section_groups(const BeamDeck& deck) {
  std::vector<SectionGroup> groups;
  for (std::size_t e = 0; e < deck.sections.size(); ++e) {
    const Section& section = deck.sections[e];
    const Vec3 y = deck.middles[e].R.col(1);
    const auto same = [&](const SectionGroup& g) {
      return g.section->name == section.name && (g.y - y).norm() < 1e-12 &&
             g.section->shape.index() == section.shape.index() &&
             same_dimensions(g.section->shape, section.shape);
    };
    auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end()) found = groups.insert(groups.end(), {&section, y, {}});
    found->elements.push_back(static_cast<int>(e));
  }
  return groups;
}

std::string deck_displacements(const BeamDeck& deck) {
  std::string text =
      "case," + deck.words.column() +
      ",node,x [m],y [m],z [m],displacement x [m],displacement y [m],displacement z [m]\n";
  for (std::size_t n = 0; n < deck.cases.size(); ++n)
    for (std::size_t k = 0; k < deck.nodes.size(); ++k) {
      const Vec3 &x = deck.nodes[k].x, &u = deck.cases[n].displacement[k];
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", n + 1, deck.cases[n].time, k, x[0], x[1],
                          x[2], u[0], u[1], u[2]);
    }
  return text;
}

}  // namespace liesl

#endif
