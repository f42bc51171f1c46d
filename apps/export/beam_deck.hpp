#pragma once
/// @file
/// A beam with its equivalent static loads, as a finite element program takes it: data, and a text
/// for each program.

#include "apps/export/deck_words.hpp"
#include "apps/tasks/esl.hpp"

namespace liesl {

/// Load cases of a deck: those that bound a design, or every record.
enum class DeckCases { Peaks, All };

/// The isolated part, held at its first node (N nodes, E elements). Axes and places are inertial,
/// as the scene gives them.
struct BeamDeck {
  struct Case {
    double time = 0;                  ///< s, or load factor
    std::vector<Vec3> force, moment;  ///< N: on the nodes, N, N m
    std::vector<Vec3> displacement;   ///< N: what the motion has, m
    double deflection = 0;            ///< largest offset from the chord, m
  };
  std::string part, scene;
  DeckWords words;
  Material material;
  std::vector<Section> sections;  ///< E
  std::vector<SE3> nodes;         ///< N, at rest
  std::vector<SE3> middles;       ///< E, of the elements, at rest
  std::vector<Case> cases;
  Identity identity;  ///< how well the loads give back the deformation, by liesl
  BeamModel model = BeamModel::AsFormalism;  ///< by which it says so
};

/// In the frame H_0 of the first node at an instant, a node has H_0^-1 H_k; turned into the frame
/// at rest H_00 that is H_00 H_0^-1 H_k, whose displacement the deck shall give back. Its load f_k
/// = g_int(H)_k, in the axes of the node, turns with it: R_00 R_0^T R_k f_k. DeckCases::Peaks: the
/// records where the largest offset from the chord has a maximum over time above half of its
/// largest (optim/problems/treatment.hpp).
/// @throws std::invalid_argument for a part that is no beam, has sections without a shape, or loads
/// that are none (rigid, or a simulation that did not converge), and where the results have not the
/// records of the loads (`esl_task` with a sink keeps a few)
BeamDeck beam_deck(const Scene& scene, const EslOutcome& esl, const std::string& part,
                   DeckCases cases);

/// Elements with the same section: first of each group, and its elements.
struct SectionGroup {
  const Section* section = nullptr;
  Vec3 y = Vec3::Zero();  ///< axis of the section, inertial
  std::vector<int> elements;
};
std::vector<SectionGroup> section_groups(const BeamDeck& deck);

/// CalculiX: B32R, each case a step, NLGEOM (mesh and numbers: beam_mesh.hpp).
/// @throws std::invalid_argument for sections that B32R has not: I-sections
std::string calculix_text(const BeamDeck& deck);
/// Nastran, in large fields: CBAR with PBARL of every shape, each case a subcase of SOL 106 with
/// LGDISP. Node k of the beam is grid k + 1.
std::string nastran_text(const BeamDeck& deck);
/// What the folder of a deck is, in which units and frame, and what it shall give back.
std::string deck_readme(const BeamDeck& deck, const std::string& program);
/// `case,time [s],node,x..z [m],displacement x..z [m]` of the motion, for comparison.
std::string deck_displacements(const BeamDeck& deck);

}  // namespace liesl
