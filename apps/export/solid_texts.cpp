#ifdef LIESL_OPTIM

/// @file
/// A meshed part as texts for CalculiX and Nastran.
#include <fmt/format.h>

#include <cctype>

#include "apps/export/nastran_card.hpp"
#include "apps/export/solid_deck.hpp"

namespace liesl {
namespace {

/// A node of the deck in each of its layers: half of its load goes to each face.
struct Layers {
  explicit Layers(const SolidDeck& d) : deck(d), count(d.layered() ? 2 : 1) {}
  int node(int i, int layer) const { return layer * deck.node_count() + i + 1; }
  double z(int layer) const { return count == 1 ? 0 : (layer - 0.5) * deck.thickness; }

  const SolidDeck& deck;
  const int count;
};

/// A name that programs take for a set: letters, digits and lines.
std::string set_name(std::string name) {
  for (char& c : name)
    c = std::isalnum(static_cast<unsigned char>(c)) ? char(std::toupper(c)) : '_';
  return name;
}

std::string solid_mesh_text(const SolidDeck& deck) {
  const Layers layers(deck);
  std::string text = "*NODE, NSET=ALL\n";
  for (int layer = 0; layer < layers.count; ++layer)
    for (int i = 0; i < deck.node_count(); ++i)
      text += fmt::format("{}, {:.12e}, {:.12e}, {:.12e}\n", layers.node(i, layer),
                          deck.nodes(0, i), deck.nodes(1, i), deck.nodes(2, i) + layers.z(layer));
  text += fmt::format("*ELEMENT, TYPE={}, ELSET=PART\n", calculix_element(deck));
  for (Eigen::Index e = 0; e < deck.cells.cols(); ++e) {
    text += fmt::format("{}", e + 1);
    int fields = 1;  // at most 16 a line
    for (int layer = 0; layer < layers.count; ++layer)
      for (Eigen::Index c = 0; c < deck.cells.rows(); ++c)
        text += fmt::format("{}{}", fields++ % 16 == 0 ? ",\n" : ", ",
                            layers.node(deck.cells(c, e), layer));
    text += "\n";
  }
  const auto put_set = [&text](const std::string& name, const auto& members) {
    text += "*NSET, NSET=" + name + "\n";
    for (const int node : members) text += fmt::format("{},\n", node);
  };
  std::vector<int> first_layer;
  for (int i = 0; i < deck.node_count(); ++i) first_layer.push_back(i + 1);
  put_set("NODES", first_layer);
  for (const auto& [name, nodes] : deck.sets) {
    std::vector<int> all;
    for (int layer = 0; layer < layers.count; ++layer)
      for (const int i : nodes) all.push_back(layers.node(i, layer));
    put_set(set_name(name), all);
  }
  return text;
}

std::string solid_materials_text(const SolidDeck& deck) {
  std::string text;
  const auto groups = stiffness_groups(deck);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double E = groups[g].stiffness * deck.material.E, nu = deck.material.nu;
    const double G = groups[g].stiffness * deck.material.G();
    text += fmt::format("*ELSET, ELSET=CELLS{}\n", g + 1);
    for (const int e : groups[g].cells) text += fmt::format("{},\n", e + 1);
    text += fmt::format("*MATERIAL, NAME=MATERIAL{}\n", g + 1);
    if (deck.dim == 2)
      text += fmt::format(
          "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n{0:.12e}, {0:.12e}, {0:.12e}, {1:.12e}, 0., 0., "
          "{2:.12e}, {2:.12e}\n{2:.12e}\n",
          E, nu, G);
    else
      text += fmt::format("*ELASTIC\n{:.12e}, {:.12e}\n", E, nu);
    text += fmt::format("*SOLID SECTION, ELSET=CELLS{0}, MATERIAL=MATERIAL{0}\n", g + 1);
    if (deck.dim == 2 && !deck.layered()) text += fmt::format("{:.12e}\n", deck.thickness);
  }
  return text;
}

std::string unit_step_text(const SolidDeck& deck, std::size_t k) {
  const Layers layers(deck);
  const SolidDeck::Unit& unit = deck.units[k];
  std::string text = fmt::format("** unit case {}\n*STEP\n*STATIC\n*BOUNDARY, OP=NEW\n", k + 1);
  if (deck.layered()) text += "ALL, 3, 3\n";
  for (int layer = 0; layer < layers.count; ++layer)
    for (const int i : deck.held)
      for (int c = 0; c < deck.dim; ++c)
        text += fmt::format("{}, {}, {}, {:.12e}\n", layers.node(i, layer), c + 1, c + 1,
                            unit.displacement(c, i));
  text += "*CLOAD, OP=NEW\n";
  const std::set<int> held(deck.held.begin(), deck.held.end());
  for (int layer = 0; layer < layers.count; ++layer)
    for (int i = 0; i < deck.node_count(); ++i)
      for (int c = 0; c < deck.dim && !held.contains(i); ++c)
        if (unit.force(c, i) != 0)
          text += fmt::format("{}, {}, {:.12e}\n", layers.node(i, layer), c + 1,
                              unit.force(c, i) / layers.count);
  return text + "*NODE PRINT, NSET=NODES\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
}

}  // namespace

std::string calculix_element(const SolidDeck& deck) {
  const CellKind& kind = deck.layered() ? cell_kind(3, 8) : deck.kind();
  return std::string(kind.abaqus) + (kind.nodes == 8 && kind.dim == 3 ? "I" : "");
}

std::string calculix_text(const SolidDeck& deck) {
  std::string text = fmt::format(
      "** '{}' of '{}' under the equivalent static loads of its {}, as unit cases. SI units.\n"
      "** See README.md in this folder.\n",
      deck.part, deck.scene, deck.words.state());
  text += solid_mesh_text(deck) + solid_materials_text(deck);
  for (std::size_t k = 0; k < deck.units.size(); ++k) text += unit_step_text(deck, k);
  return text;
}

namespace {

using nastran::card;
using nastran::Fields;
using nastran::number;
using nastran::title;
using nastran::operator<<;

constexpr int kCombined = 1000;  // first number of the LOAD cards and of the supports of cases

/// Local nodes in the order of Nastran: of 20-node hexahedra the upright edges come before the
/// upper.
int nastran_local(const CellKind& kind, int c) {
  return kind.nodes == 20 && c >= 12 ? 12 + (c + 4 - 12) % 8 : c;
}

/// Materials, properties and cells: property g + 1 is that of group g.
std::string solid_bulk_text(const SolidDeck& deck) {
  std::string text;
  const bool planar = deck.dim == 2;
  const auto groups = stiffness_groups(deck);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string id = std::to_string(g + 1);
    text += card("MAT1", {id, number(groups[g].stiffness * deck.material.E), "",
                          number(deck.material.nu), number(deck.material.rho)});
    text += planar ? card("PSHELL", {id, id, number(deck.thickness)}) : card("PSOLID", {id, id});
    for (const int e : groups[g].cells) {
      Fields fields{std::to_string(e + 1), id};
      for (int c = 0; c < deck.kind().nodes; ++c)
        fields.push_back(std::to_string(deck.cells(nastran_local(deck.kind(), c), e) + 1));
      text += card(nastran_element(deck), fields);
    }
  }
  return text;
}

/// Grids with the freedoms that cells have not taken out.
std::string grids_text(const SolidDeck& deck) {
  std::string text;
  for (int i = 0; i < deck.node_count(); ++i) {
    Fields fields{std::to_string(i + 1), ""};
    fields << Vec3(deck.nodes.col(i));
    fields.insert(fields.end(), {"", deck.dim == 2 ? "3456" : "456"});
    text += card("GRID", fields);
  }
  return text;
}

/// What holds the first interface in a case.
std::string support_text(const SolidDeck& deck, int id, const Eigen::VectorXd& factors) {
  std::string text;
  for (const int i : deck.held)
    for (int c = 0; c < deck.dim; ++c) {
      double u = 0;
      for (std::size_t k = 0; k < deck.units.size(); ++k)
        u += factors[Eigen::Index(k)] * deck.units[k].displacement(c, i);
      text += card("SPC",
                   {std::to_string(id), std::to_string(i + 1), std::to_string(c + 1), number(u)});
    }
  return text;
}

}  // namespace

std::string nastran_element(const SolidDeck& deck) {
  const CellKind& kind = deck.kind();
  const bool simplex = kind.family == CellFamily::Simplex;
  if (kind.dim == 3) return simplex ? "CTETRA" : "CHEXA";
  return (simplex ? "CTRIA" : "CQUAD") + std::to_string(kind.nodes);
}

std::string nastran_text(const SolidDeck& deck) {
  std::string text = "SOL 101\nCEND\n" + title("TITLE = " + deck.part + " of " + deck.scene) +
                     "DISPLACEMENT = ALL\n";
  for (std::size_t n = 0; n < deck.times.size(); ++n)
    text += fmt::format("SUBCASE {0}\n  LABEL = the {3} at {1}\n  LOAD = {2}\n  SPC = {2}\n", n + 1,
                        deck.words.at(deck.times[n]), kCombined + static_cast<int>(n) + 1,
                        deck.words.state());
  text += "BEGIN BULK\n" + grids_text(deck) + solid_bulk_text(deck);
  for (std::size_t k = 0; k < deck.units.size(); ++k)
    for (int i = 0; i < deck.node_count(); ++i) {
      const Vec3 f = deck.units[k].force.col(i);
      if (f.isZero(0)) continue;
      Fields fields{std::to_string(k + 1), std::to_string(i + 1), "", number(1)};
      fields << f;
      text += card("FORCE", fields);
    }
  for (std::size_t n = 0; n < deck.times.size(); ++n) {
    const int id = kCombined + static_cast<int>(n) + 1;
    const Eigen::VectorXd factors = deck.factors.col(Eigen::Index(n));
    Fields fields{std::to_string(id), number(1)};
    for (Eigen::Index k = 0; k < factors.size(); ++k) {
      fields.push_back(number(factors[k]));
      fields.push_back(std::to_string(k + 1));
    }
    text += card("LOAD", fields) + support_text(deck, id, factors);
  }
  return text + "ENDDATA\n";
}

}  // namespace liesl

#endif
