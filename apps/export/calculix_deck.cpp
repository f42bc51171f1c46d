#ifdef LIESL_OPTIM

#include <fmt/format.h>

#include "apps/export/beam_mesh.hpp"

namespace liesl {
namespace {

/// Section type and dimensions of B32R.
struct SectionCard {
  const char* type;
  std::string numbers;
};
struct ToCard {
  SectionCard operator()(const Circle& s) const {
    return {"CIRC", fmt::format("{:.12e}", s.diameter)};  // PIPE: radius
  }
  SectionCard operator()(const Tube& s) const {
    return {"PIPE", fmt::format("{:.12e}, {:.12e}", s.diameter / 2, s.thickness)};
  }
  SectionCard operator()(const Rectangle& s) const {
    return {"RECT", fmt::format("{:.12e}, {:.12e}", s.width, s.height)};
  }
  SectionCard operator()(const Box& s) const {
    return {"BOX", fmt::format("{:.12e}, {:.12e}, {:.12e}, {:.12e}, {:.12e}, {:.12e}", s.width,
                               s.height, s.thickness, s.thickness, s.thickness, s.thickness)};
  }
  template <class Other>
  SectionCard operator()(const Other&) const {
    throw std::invalid_argument(
        "CalculiX has no such beam section; expected a circle, tube, rectangle or box, or --to "
        "nastran, which has I-sections, too");
  }
};

std::string node_line(int number, const Vec3& x) {
  return fmt::format("{}, {:.12e}, {:.12e}, {:.12e}\n", number, x[0], x[1], x[2]);
}

/// "1,\n2,\n"
std::string list(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += fmt::format("{},\n", number);
  return text;
}

std::string mesh_text(const BeamDeck& deck, const BeamMesh& mesh) {
  std::string text = "*NODE, NSET=ALL\n";
  for (const auto& [number, node] : mesh.nodes) text += node_line(number, node.x);
  text += "*ELEMENT, TYPE=B32R, ELSET=PART\n";
  for (const auto& [number, nodes] : mesh.elements)
    text += fmt::format("{}, {}, {}, {}\n", number, nodes[0], nodes[1], nodes[2]);
  text += "*NSET, NSET=NODES\n";
  for (std::size_t k = 0; k < deck.nodes.size(); ++k) text += fmt::format("{},\n", 2 * k + 1);
  return text;
}

std::string sections_text(const BeamDeck& deck, const BeamMesh& mesh) {
  std::string text =
      fmt::format("*MATERIAL, NAME=MATERIAL\n*ELASTIC\n{:.12e}, {:.12e}\n*DENSITY\n{:.12e}\n",
                  deck.material.E, deck.material.nu, deck.material.rho);
  const auto groups = section_groups(deck);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Shape& shape = groups[g].section->shape;
    const SectionCard card = std::visit(ToCard(), shape);
    text += fmt::format("*ELSET, ELSET=SECTION{}\n", g + 1);
    for (const int e : groups[g].elements) text += list(mesh.pieces[static_cast<std::size_t>(e)]);
    const Vec3& y = groups[g].y;
    text += fmt::format(
        "*BEAM SECTION, ELSET=SECTION{}, MATERIAL=MATERIAL, SECTION={}{}\n{}\n{:.12e}, {:.12e}, "
        "{:.12e}\n",
        g + 1, card.type, mesh.by_node && is_bar(shape) ? ", NODAL THICKNESS" : "", card.numbers,
        y[0], y[1], y[2]);
  }
  return text;
}

/// Outlines of bars that pass from one to another.
std::string thickness_text(const BeamMesh& mesh) {
  if (!mesh.by_node) return "";
  std::string text = "*NODAL THICKNESS\n";
  for (const auto& [number, node] : mesh.nodes)
    if (node.outline[0] > 0)
      text += fmt::format("{}, {:.12e}, {:.12e}\n", number, node.outline[0], node.outline[1]);
  return text;
}

std::string step_text(const DeckWords& words, const BeamDeck::Case& load_case, std::size_t number) {
  std::string text = fmt::format(
      "** case {}: the {} at {}\n*STEP, NLGEOM, INC=1000\n*STATIC\n0.25, 1.\n"
      "*CLOAD, OP=NEW\n",
      number, words.state(), words.at(load_case.time));
  for (std::size_t k = 1; k < load_case.force.size(); ++k)
    for (int c = 0; c < 6; ++c)
      text += fmt::format("{}, {}, {:.12e}\n", 2 * k + 1, c + 1,
                          c < 3 ? load_case.force[k][c] : load_case.moment[k][c - 3]);
  return text + "*NODE PRINT, NSET=NODES\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
}

}  // namespace

std::string calculix_text(const BeamDeck& deck) {
  std::string text = fmt::format(
      "** '{}' of '{}' under the equivalent static loads of its {}. SI units.\n"
      "** See README.md in this folder.\n",
      deck.part, deck.scene, deck.words.state());
  const BeamMesh mesh = beam_mesh(deck);
  text += mesh_text(deck, mesh) + sections_text(deck, mesh) + thickness_text(mesh) +
          "*BOUNDARY\n1, 1, 6\n";
  for (std::size_t n = 0; n < deck.cases.size(); ++n)
    text += step_text(deck.words, deck.cases[n], n + 1);
  return text;
}

}  // namespace liesl

#endif
