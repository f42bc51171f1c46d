#ifdef LIESL_OPTIM

#include <fmt/format.h>

#include "apps/export/beam_mesh.hpp"
#include "apps/tasks/describe_identity.hpp"

namespace liesl {
namespace {

constexpr std::string_view kTaperNote =
    "**The sections of this part jump between elements.** CalculiX joins unlike ends of its "
    "expanded beams by\nrigid knots, which stiffen the whole elements beside them. The bars of "
    "this deck pass from one outline to\nthe next instead, over a tenth of the smaller one on "
    "each side of the node (`NODAL THICKNESS`): a rod of four\ndiameters, 9.3 to 12.1 mm, bends by "
    "0.7 % less than in its motion (with knots by 4.8 %), one of 8 and 16 mm\nby 1.4 %.\n\n";
constexpr std::string_view kKnotNote =
    "**Tubes or boxes of this part have other outlines than their neighbours**, which CalculiX "
    "joins by rigid\nknots. They lie between short elements here: a rod of tubes of 10 to 12.5 mm "
    "bends by 1.2 % less than in its\nmotion (between elements of 37.5 mm by 4.4 %), one of boxes "
    "of 10 to 13 mm by 1.4 % more.\n\n";
constexpr double kFarFromLinear = 0.5;  // linear strains, off by so much of the largest
constexpr std::string_view kFarNote =
    "**This part bends far.** Loads that a program raises in proportion need not lead to its "
    "shape: "
    "CalculiX 2.20\ncuts its increments back without end at 0.3 of the loads of liesl's scene "
    "`pendulum`.\n\n";

/// Where outlines jump.
std::string jump_notes(const BeamDeck& deck) {
  const BeamMesh mesh = beam_mesh(deck);
  return std::string(mesh.by_node ? kTaperNote : "") + std::string(mesh.knots ? kKnotNote : "");
}

/// What the identity of another model than that of the deck does not say.
std::string own_model(BeamModel model) {
  if (model == BeamModel::Modal)
    return ".\n"
           "  That is by its own model, linear in a floating frame; what axial forces do to the "
           "bending of the\n"
           "  deck comes on top, N L^2/(pi^2 EI) of it";
  if (model == BeamModel::Segments)
    return ".\n"
           "  That is by its own model, a chain of segments without shear; the deck differs by the "
           "error of its\n"
           "  mesh, which falls with the square of the segments";
  return "";
}

/// How the beams of a program differ from those of liesl, as measured (docs/outputs.md, "Decks").
std::string deviations(bool calculix) {
  if (calculix)
    return "of the rod of liesl's scene\n"
           "  `slider_crank` CalculiX 2.20 bends round bars by 0.4 % and tubes by 0.3 % less than "
           "the motion,\n"
           "  whatever the mesh, of one section, rectangles by less than 0.05 % less, thin boxes "
           "by 2 % more";
  return "no Nastran was\n"
         "  at hand; beams without shear, by second-order theory, bend 0.1 to 0.2 % less than the "
         "motion, with\n"
         "  thin walls 0.5 to 1 % less";
}

}  // namespace

std::string deck_readme(const BeamDeck& deck, const std::string& program) {
  const bool calculix = program == "CalculiX";
  std::string text = fmt::format(
      "# {0} of '{1}' for {2}\n\n"
      "The equivalent static loads of {10}: the internal forces of the part at {3}, "
      "each a\n"
      "load case on the isolated part. Written by `liesl export`.\n\n"
      "- **Units**: m, N, Pa, kg, s.\n"
      "- **Frame**: inertial axes; the part where the scene puts it, held at its first node. The "
      "loads of a\n"
      "  case are turned into the frame of that node, so that the part deforms as in the "
      "{11},\n"
      "  seen from there.\n"
      "- **Nodes**: {4}.\n"
      "- **Cases are solved with large displacements** ({5}). A slender part that bends under an "
      "axial force\n"
      "  N has, linearly, an error of N L^2/(pi^2 EI) of its bending, too much where N pulls and "
      "too little\n"
      "  where it pushes: linear decks miss 10 % and more.\n"
      "- **What they shall give back**: `displacements.csv`, the displacements of the {11}. "
      "The strains\n"
      "  that liesl finds under these loads differ from those of the {11}, over the largest: {6} "
      "(linear: {7}){8}.\n"
      "- **Deviations go to one side** at all instants where they were measured: {9}.\n"
      "- {12} in the loads; the deck has none of its own.\n\n",
      deck.part, deck.scene, program, deck.words.count(deck.cases.size()),
      calculix ? "node k of the beam is node 2k + 1, the middle of element e, or of its longest "
                 "piece, node 2e + 2"
               : "node k of the beam is grid k + 1",
      calculix ? "`NLGEOM`" : "`SOL 106`, `LGDISP`", difference_text(deck.identity.nonlinear),
      difference_text(deck.identity.linear), own_model(deck.model), deviations(calculix),
      deck.words.a_state(), deck.words.state(), deck.words.forces());
  if (!(deck.identity.linear < kFarFromLinear)) text += kFarNote;
  if (calculix) text += jump_notes(deck);
  text += "| case | " + deck.words.column() + " | largest deflection [m] |\n|---|---|---|\n";
  for (std::size_t n = 0; n < deck.cases.size(); ++n)
    text += fmt::format("| {} | {:.6g} | {:.6g} |\n", n + 1, deck.cases[n].time,
                        deck.cases[n].deflection);
  return text;
}

}  // namespace liesl

#endif
