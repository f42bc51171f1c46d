#pragma once
/// @file
/// A meshed part as its picture needs it: at rest, with what its amplitudes do.

#include "apps/output/results.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

/// Cells, fractions, interfaces and level set at rest, seen from the first interface; displacements
/// and stresses of each amplitude. Without records.
/// @param phi node freedoms x k, displacement of the nodes by amplitude; no columns: it is rigid
/// @pre body.kind is a SolidSpec
output::MeshResult mesh_at_rest(const BodySpec& body, const Eigen::MatrixXd& phi);

/// Puts the displacements by amplitude into a mesh at rest. @param phi node freedoms x k
void add_basis(const SolidMesh& mesh, const Eigen::MatrixXd& phi, output::MeshResult& out);

/// A part under loads as records: record n is load case n alone, amplitude n is its displacement.
/// The abscissa "load_case" counts from 1.
/// @param u node freedoms x cases, in the axes of the mesh, m
/// @pre body.kind is a SolidSpec
output::Results load_case_results(const std::string& name, const BodySpec& body,
                                  const Eigen::MatrixXd& u);

}  // namespace liesl
