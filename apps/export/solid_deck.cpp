#ifdef LIESL_OPTIM

#include "apps/export/solid_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "apps/tasks/describe_identity.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const SolidLoads& solid_loads_of(const EslOutcome& esl, const std::string& part) {
  for (const SolidLoads& solid : esl.solids)
    if (solid.name == part) return solid;
  throw std::invalid_argument("'" + part + "' has no loads; expected a flexible meshed part");
}

/// Cells that have material.
std::vector<int> filled_cells(const VectorXd& fractions) {
  std::vector<int> out;
  for (int e = 0; e < fractions.size(); ++e)
    if (fractions[e] > 0) out.push_back(e);
  return out;
}

/// Numbers from 0 of the nodes of these cells, -1 of others.
std::vector<int> renumbered(const SolidMesh& mesh, const std::vector<int>& filled) {
  std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
  for (const int e : filled)
    for (int c = 0; c < mesh.nodes_per_cell(); ++c) number[std::size_t(mesh.cells(c, e))] = 0;
  int next = 0;
  for (int& n : number)
    if (n == 0) n = next++;
  return number;
}

/// Displacements by unit case [node freedoms x k] as those of the deck's nodes.
void add_units(const SolidModel& model, const std::vector<int>& filled,
               const std::vector<int>& number, const MatrixXd& u, SolidDeck& deck) {
  const SolidMesh& mesh = model.mesh();
  const auto zero = Eigen::Matrix3Xd::Zero(3, deck.node_count());
  deck.units.assign(static_cast<std::size_t>(u.cols()), {zero, zero});
  for (std::size_t i = 0; i < number.size(); ++i)
    for (Eigen::Index k = 0; k < u.cols() && number[i] >= 0; ++k)
      deck.units[std::size_t(k)].displacement.col(number[i]).head(mesh.dim) =
          u.col(k).segment(mesh.dim * static_cast<Eigen::Index>(i), mesh.dim);
  for (std::size_t n = 0; n < filled.size(); ++n) {
    const MatrixXd f = deck.stiffness[n] * (model.cell(filled[n]).K * model.at_cell(filled[n], u));
    for (int c = 0; c < mesh.nodes_per_cell(); ++c)
      for (Eigen::Index k = 0; k < u.cols(); ++k)
        deck.units[std::size_t(k)].force.col(deck.cells(c, Eigen::Index(n))).head(mesh.dim) +=
            f.col(k).segment(mesh.dim * c, mesh.dim);
  }
}

void add_mesh(const SolidModel& model, const VectorXd& fractions, const std::vector<int>& filled,
              const std::vector<int>& number, SolidDeck& deck) {
  const SolidMesh& mesh = model.mesh();
  const auto count = std::count_if(number.begin(), number.end(), [](int n) { return n >= 0; });
  deck.nodes.resize(3, count);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) deck.nodes.col(number[i]) = mesh.nodes.col(static_cast<Eigen::Index>(i));
  deck.cells.resize(mesh.nodes_per_cell(), static_cast<Eigen::Index>(filled.size()));
  for (std::size_t n = 0; n < filled.size(); ++n) {
    for (int c = 0; c < mesh.nodes_per_cell(); ++c)
      deck.cells(c, Eigen::Index(n)) = number[std::size_t(mesh.cells(c, filled[n]))];
    deck.stiffness.push_back(model.law().stiffness(fractions[filled[n]]));
  }
  for (const Interface& interface : model.interfaces())
    for (const int node : interface.nodes)
      if (number[std::size_t(node)] >= 0)
        deck.sets[interface.name].push_back(number[std::size_t(node)]);
  deck.held = deck.sets[model.interfaces().front().name];
}

/// Records that become cases.
std::set<int> chosen_records(const SolidLoadSet& loads, DeckCases cases) {
  std::set<int> kept;
  if (cases == DeckCases::Peaks) {
    const MatrixXd energy = loads.basis.transpose() * loads.shapes;
    std::vector<double> of_records;
    for (Eigen::Index n = 0; n < loads.e.cols(); ++n)
      of_records.push_back(0.5 * loads.e.col(n).dot(energy * loads.e.col(n)));
    kept = treated_records(Treatment::Maxima, of_records);
  }
  if (kept.empty())
    for (int n = 0; n < loads.e.cols(); ++n) kept.insert(n);
  return kept;
}

}  // namespace

SolidDeck solid_deck(const Scene& scene, const EslOutcome& esl, const std::string& part,
                     DeckCases cases) {
  const SolidLoads& loads = solid_loads_of(esl, part);
  const auto& solid =
      std::get<SolidSpec>(scene.mechanism.bodies[std::size_t(scene.mechanism.body(part))].kind);
  const SolidModel& model = *solid.model;
  if (model.mesh().cell_count() == 0)
    throw std::invalid_argument("'" + part + "' is given by matrices; expected a part with a mesh");
  SolidDeck deck;
  deck.part = part;
  deck.scene = scene.mechanism.name;
  deck.words.equilibrium = scene.simulation.type != SimulationType::Dynamic;
  deck.material = model.material();
  deck.dim = model.mesh().dim;
  deck.thickness = deck.dim == 2 ? model.thickness() : 0;
  deck.frame = solid.frame;
  deck.identity = loads.identity;
  const VectorXd fractions = solid_fractions(solid).value;
  const std::vector<int> filled = filled_cells(fractions);
  const std::vector<int> number = renumbered(model.mesh(), filled);
  add_mesh(model, fractions, filled, number, deck);
  if (deck.held.empty())
    throw std::invalid_argument("the first interface of '" + part + "' lies outside the outline");
  add_units(model, filled, number, model.T() * loads.set.basis, deck);
  const std::set<int> kept = chosen_records(loads.set, cases);
  deck.factors = loads.set.e(Eigen::all, std::vector<int>(kept.begin(), kept.end()));
  for (const int n : kept) deck.times.push_back(loads.set.t[std::size_t(n)]);
  return deck;
}

std::vector<StiffnessGroup> stiffness_groups(const SolidDeck& deck) {
  std::map<double, std::vector<int>> cells;
  for (std::size_t e = 0; e < deck.stiffness.size(); ++e)
    cells[deck.stiffness[e]].push_back(static_cast<int>(e));
  std::vector<StiffnessGroup> groups;
  for (auto at = cells.rbegin(); at != cells.rend(); ++at)
    groups.push_back({at->first, at->second});
  return groups;
}

std::string deck_displacements(const SolidDeck& deck) {
  std::string text = "unit,node,x [m],y [m],z [m],displacement x,displacement y,displacement z\n";
  for (std::size_t k = 0; k < deck.units.size(); ++k)
    for (int i = 0; i < deck.node_count(); ++i) {
      const auto x = deck.nodes.col(i), u = deck.units[k].displacement.col(i);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", k + 1, i + 1, x[0], x[1], x[2], u[0], u[1],
                          u[2]);
    }
  return text;
}

std::string deck_factors(const SolidDeck& deck) {
  std::string text = "case," + deck.words.column();
  for (std::size_t k = 0; k < deck.units.size(); ++k) text += fmt::format(",unit {}", k + 1);
  text += "\n";
  for (std::size_t n = 0; n < deck.times.size(); ++n) {
    text += fmt::format("{},{}", n + 1, deck.times[n]);
    for (const double factor : deck.factors.col(Eigen::Index(n)))
      text += fmt::format(",{}", factor);
    text += "\n";
  }
  return text;
}

std::string deck_readme(const SolidDeck& deck, const std::string& program) {
  const bool calculix = program == "CalculiX", planar = deck.dim == 2;
  const std::string cells =
      calculix ? (deck.layered() ? "one layer of " : "") + calculix_element(deck)
               : nastran_element(deck) + (planar ? ", membrane stiffness alone" : "");
  const Vec3& x = deck.frame.x;
  std::string text = fmt::format(
      "# {0} of '{1}' for {2}\n\n"
      "The equivalent static loads of {12}: what deforms the part at {3}. The loads "
      "of "
      "a case\n"
      "are a combination of {4} unit cases, with the factors of `factors.csv`, as its "
      "displacements "
      "are.\n"
      "Written by `liesl export`.\n\n"
      "- **Units**: m, N, Pa, kg, s. A unit case is that of a coordinate of 1 m or 1 rad: the part "
      "is linear.\n"
      "- **Frame**: that of the mesh, whose origin lies at ({5:.6g}, {6:.6g}, {7:.6g}) m in the "
      "scene. Displacements are\n"
      "  those in the floating frame of the first interface, which is held: rotate with it for "
      "inertial axes.\n"
      "- **Cells**: {8} ({9} of {10} nodes); cells without material are left out, those that the "
      "outline cuts have\n"
      "  {11} materials with their share of the stiffness.\n",
      deck.part, deck.scene, program, deck.words.count(deck.times.size()), deck.units.size(), x[0],
      x[1], x[2], cells, deck.cells.cols(), deck.node_count(), stiffness_groups(deck).size(),
      deck.words.a_state());
  if (planar && calculix && !deck.layered())
    text +=
        "- **Planar part**: its material has no Poisson effect across its plane, so that this is "
        "one "
        "of plane\n  stress for every thickness.\n";
  if (planar && calculix && deck.layered())
    text += fmt::format(
        "- **Planar part**: one layer {:.6g} m thick, held across; its material has no Poisson "
        "effect across the\n"
        "  layer, so that its plane is that of plane stress. Node k is k, on the far face {} + "
        "k.\n",
        deck.thickness, deck.node_count());
  text += fmt::format(
      "- **Cases are linear** ({}): the large motion is that of the frame.\n"
      "- **Forces** are those of the cells that are left, K u, on every node: they also hold "
      "interfaces rigid,\n"
      "  so that the deck needs no rigid bodies.\n"
      "- **What it shall give back**: `displacements.csv`{}. The displacements that "
      "liesl finds with\n"
      "  the full mesh differ from those of the {}, over the largest: {}.\n\n"
      "| case | {} |\n|---|---|\n",
      calculix ? "no `NLGEOM`" : "`SOL 101`",
      calculix
          ? fmt::format("; {} is liesl's cell, so that it does to 1e-6", calculix_element(deck))
          : "; no Nastran was at hand, finite elements of liesl's kind do to 1e-6",
      deck.words.state(), difference_text(deck.identity.linear), deck.words.column());
  for (std::size_t n = 0; n < deck.times.size(); ++n)
    text += fmt::format("| {} | {:.6g} |\n", n + 1, deck.times[n]);
  return text;
}

}  // namespace liesl

#endif
