#ifdef LIESL_OPTIM

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/export/beam_deck.hpp"
#include "apps/export/nastran_card.hpp"

namespace liesl {
namespace {

using nastran::card;
using nastran::Fields;
using nastran::number;
using nastran::title;
using nastran::operator<<;

/// Type and dimensions of PBARL, and the axis of the section (1: y, 2: z) that is y of the element.
/// The first dimension of bars and boxes is along z of the element, the height of an "I" along y.
struct PbarlShape {
  std::string type;
  std::vector<double> dimensions;
  int y_axis = 1;
};
struct ToPbarl {
  PbarlShape operator()(const Circle& s) const { return {"ROD", {s.diameter / 2}}; }
  PbarlShape operator()(const Tube& s) const {
    return {"TUBE", {s.diameter / 2, s.diameter / 2 - s.thickness}};
  }
  PbarlShape operator()(const Rectangle& s) const { return {"BAR", {s.height, s.width}}; }
  PbarlShape operator()(const Box& s) const {
    return {"BOX", {s.height, s.width, s.thickness, s.thickness}};
  }
  PbarlShape operator()(const ISection& s) const {
    return {"I",
            {s.height, s.width, s.width, s.web_thickness, s.flange_thickness, s.flange_thickness},
            2};
  }
  PbarlShape operator()(const FullSection&) const {
    throw std::invalid_argument("a section of matrices is not exported to Nastran");
  }
};

std::string section_text(const PbarlShape& shape, std::size_t id) {
  Fields fields{std::to_string(id), "1", "", shape.type, "", "", "", ""};
  for (const double d : shape.dimensions) fields.push_back(number(d));
  return card("PBARL", fields);
}

/// @param loads cards of each case; a set without cards would be fatal, and so is left out
std::string control_text(const BeamDeck& deck, const std::vector<std::string>& loads) {
  std::string text = "SOL 106\nCEND\n" + title("TITLE = " + deck.part + " of " + deck.scene) +
                     "DISPLACEMENT = ALL\nSPC = 1\n";
  for (std::size_t n = 0; n < deck.cases.size(); ++n) {
    text += fmt::format("SUBCASE {}\n  LABEL = the {} at {}\n  NLPARM = 1\n", n + 1,
                        deck.words.state(), deck.words.at(deck.cases[n].time));
    if (!loads[n].empty()) text += fmt::format("  LOAD = {}\n", n + 1);
  }
  return text;
}

std::string bulk_text(const BeamDeck& deck) {
  std::string text;
  for (std::size_t k = 0; k < deck.nodes.size(); ++k) {
    Fields fields{std::to_string(k + 1), ""};
    text += card("GRID", fields << deck.nodes[k].x);
  }
  const auto groups = section_groups(deck);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const PbarlShape shape = std::visit(ToPbarl(), groups[g].section->shape);
    text += section_text(shape, g + 1);
    for (const int e : groups[g].elements) {
      Fields fields{std::to_string(e + 1), std::to_string(g + 1), std::to_string(e + 1),
                    std::to_string(e + 2)};
      const Vec3 y = deck.middles[static_cast<std::size_t>(e)].R.col(shape.y_axis);
      text += card("CBAR", fields << y);
    }
  }
  const Material& m = deck.material;
  return text + card("MAT1", {"1", number(m.E), "", number(m.nu), number(m.rho)}) +
         card("SPC1", {"1", "123456", "1"});
}

/// All components are written as 0.
bool no_load(const Vec3& load) {
  const std::string zero = number(0);
  return std::all_of(load.begin(), load.end(), [&](double x) { return number(x) == zero; });
}

/// Cards of each case; none where nothing loads it.
std::vector<std::string> loads_text(const BeamDeck& deck) {
  std::vector<std::string> text(deck.cases.size());
  const auto add = [&](const char* name, std::size_t n, std::size_t node, const Vec3& load) {
    if (no_load(load)) return;  // a card needs a component
    Fields fields{std::to_string(n + 1), std::to_string(node), "0", "1."};
    text[n] += card(name, fields << load);
  };
  for (std::size_t n = 0; n < deck.cases.size(); ++n)
    for (std::size_t k = 1; k < deck.nodes.size(); ++k) {
      add("FORCE", n, k + 1, deck.cases[n].force[k]);
      add("MOMENT", n, k + 1, deck.cases[n].moment[k]);
    }
  return text;
}

}  // namespace

std::string nastran_text(const BeamDeck& deck) {
  const std::vector<std::string> loads = loads_text(deck);
  return title("$ '" + deck.part + "' of '" + deck.scene + "'") +
         "$ under the equivalent static loads of its " + deck.words.state() +
         ". SI units.\n"
         "$ See README.md in this folder.\n" +
         control_text(deck, loads) + "BEGIN BULK\nPARAM,LGDISP,1\nNLPARM,1,4\n" + bulk_text(deck) +
         fmt::format("{}", fmt::join(loads, "")) + "ENDDATA\n";
}

}  // namespace liesl

#endif
