#pragma once
/// @file
/// A meshed part with its equivalent static loads, as a finite element program takes it: data, and
/// a text for each program.

#include "apps/export/beam_deck.hpp"

namespace liesl {

/// The isolated part in the axes of its mesh, without its empty cells; N nodes, M cells. Loads are
/// combinations of a few unit cases (SolidLoadSet), so that a program factorises once.
struct SolidDeck {
  /// The deformation by one of the part's coordinates, and the forces on its nodes that make it,
  /// K u over the cells that are left: what is rigid in liesl (interfaces) is held by them, too.
  struct Unit {
    Eigen::Matrix3Xd displacement, force;  ///< 3 x N, by a coordinate of 1: m or rad; N
  };
  std::string part, scene;
  DeckWords words;
  Material material;
  int dim = 3;
  double thickness = 0;                          ///< m, of a planar part
  SE3 frame;                                     ///< of the mesh, in the scene
  Eigen::Matrix3Xd nodes;                        ///< m
  Eigen::MatrixXi cells;                         ///< nodes of each x M, in the order of VTK
  std::vector<double> stiffness;                 ///< M, share of the full one
  std::map<std::string, std::vector<int>> sets;  ///< interfaces, nodes from 0
  std::vector<int> held;                         ///< nodes of the first interface
  std::vector<Unit> units;
  std::vector<double> times;  ///< s, or load factors, of the cases
  Eigen::MatrixXd factors;    ///< units x cases
  Identity identity;

  int node_count() const { return static_cast<int>(nodes.cols()); }
  const CellKind& kind() const { return cell_kind(dim, static_cast<int>(cells.rows())); }
  /// Planar quadrilaterals are one layer of hexahedra for CalculiX.
  bool layered() const { return dim == 2 && cells.rows() == 4; }
};

/// DeckCases::Peaks: the records where the elastic energy has a maximum over time above half of its
/// largest. @throws std::invalid_argument for a part that has no loads (rigid, or not meshed)
SolidDeck solid_deck(const Scene& scene, const EslOutcome& esl, const std::string& part,
                     DeckCases cases);

/// Cells of one stiffness.
struct StiffnessGroup {
  double stiffness = 1;
  std::vector<int> cells;
};
std::vector<StiffnessGroup> stiffness_groups(const SolidDeck& deck);

/// CalculiX: the elements of `CellKind::abaqus`, hexahedra of order 1 as C3D8I, whose stiffness is
/// that of liesl; planar quadrilaterals of order 1 are one layer of C3D8I (CPS4 has no incompatible
/// modes). The material of a planar part has no Poisson effect across it, so that its plane is that
/// of plane stress. Each unit case a linear step. Node k is k + 1, on the far face of a layer
/// N + k + 1.
std::string calculix_text(const SolidDeck& deck);
/// Nastran, in large fields: CTETRA and CHEXA, or CTRIA3, CTRIA6, CQUAD4 and CQUAD8 with membrane
/// stiffness alone; a FORCE set each unit case, a LOAD and a subcase each case.
std::string nastran_text(const SolidDeck& deck);
/// "C3D10", "CTETRA": what the programs call the cells.
std::string calculix_element(const SolidDeck& deck);
std::string nastran_element(const SolidDeck& deck);
std::string deck_readme(const SolidDeck& deck, const std::string& program);
/// `unit,node,x..z [m],displacement x..z`: what each unit case shall give back.
std::string deck_displacements(const SolidDeck& deck);
/// `case,time [s],unit 1,...`: what the unit cases are multiplied by.
std::string deck_factors(const SolidDeck& deck);

}  // namespace liesl
