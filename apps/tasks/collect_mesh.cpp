#include "apps/tasks/collect_mesh.hpp"

#include "apps/tasks/collect_reference.hpp"
#include "mbs/levelset/shape_spec.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

/// Displacements of the nodes, 3 x nodes.
Eigen::Matrix3Xd nodes_in_space(const SolidMesh& mesh, const Eigen::VectorXd& u) {
  Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  out.topRows(mesh.dim) = Eigen::Map<const Eigen::MatrixXd>(u.data(), mesh.dim, mesh.node_count());
  return out;
}

void append_columns(std::vector<double>& out, const Eigen::Matrix3Xd& x) {
  append(out, Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()));
}

void add_stress_basis(const SolidModel& part, const Eigen::MatrixXd& phi, output::MeshResult& out) {
  std::vector<Eigen::MatrixXd> cells;
  for (int e = 0; e < part.mesh().cell_count(); ++e) cells.push_back(central_stress(part, e, phi));
  for (Eigen::Index k = 0; k < phi.cols(); ++k)
    for (const Eigen::MatrixXd& stress : cells) append(out.stress_basis, stress.col(k));
}

}  // namespace

output::MeshResult mesh_at_rest(const BodySpec& body, const Eigen::MatrixXd& phi) {
  const auto& solid = std::get<SolidSpec>(body.kind);
  const SolidMesh& mesh = solid.mesh();
  const Eigen::Vector3d origin = solid.interfaces()[0].point;
  output::MeshResult out;
  out.name = body.name;
  out.corners = mesh.nodes_per_cell();
  out.cells.assign(mesh.cells.data(), mesh.cells.data() + mesh.cells.size());
  append(out.fractions, solid_fractions(solid).value);
  append_columns(out.reference, mesh.nodes.colwise() - origin);
  for (const Interface& interface : solid.interfaces())
    append(out.interfaces, interface.point - origin);
  if (mesh.dim == 2) out.thickness = solid.model->thickness();
  if (!solid.outline.features.empty()) {
    const levelset::LevelSetPtr shape = levelset::make_shape(solid.outline);
    for (int i = 0; i < mesh.node_count(); ++i)
      out.level.push_back(shape->value(mesh.nodes.col(i)));
  }
  if (phi.cols() > 0) add_stress_basis(*solid.model, phi, out);
  add_basis(mesh, phi, out);
  return out;
}

void add_basis(const SolidMesh& mesh, const Eigen::MatrixXd& phi, output::MeshResult& out) {
  for (Eigen::Index k = 0; k < phi.cols(); ++k)
    append_columns(out.basis, nodes_in_space(mesh, phi.col(k)));
}

output::Results load_case_results(const std::string& name, const BodySpec& body,
                                  const Eigen::MatrixXd& u) {
  const auto& solid = std::get<SolidSpec>(body.kind);
  const SolidMesh& mesh = solid.mesh();
  output::Results r;
  r.name = name;
  r.space = mesh.dim == 2 ? "planar" : "spatial";
  r.abscissa = "load_case";
  r.abscissa_unit = "-";
  output::MeshResult part = mesh_at_rest(body, u);
  output::BodyResult frame;
  frame.name = body.name;
  frame.kind = "solid";
  frame.nodes = 1;
  const SE3 H = solid.port(0);
  const auto add_frame = [&H](std::vector<double>& places, std::vector<double>& turns) {
    append(places, H.x);
    for (int i = 0; i < 3; ++i) append(turns, H.R.row(i).transpose());
  };
  add_frame(frame.reference_positions, frame.reference_rotations);
  const Eigen::Matrix3Xd rest = mesh.nodes.colwise() - solid.interfaces()[0].point;
  for (Eigen::Index n = 0; n < u.cols(); ++n) {
    r.times.push_back(static_cast<double>(n + 1));
    append(part.amplitudes, Eigen::VectorXd::Unit(u.cols(), n));
    add_frame(frame.positions, frame.rotations);
    const Eigen::Matrix3Xd moved = nodes_in_space(mesh, u.col(n));
    part.records.push_back(static_cast<int>(n));
    append_columns(part.positions, (H.R * (rest + moved)).colwise() + H.x);
    append_columns(part.displacements, H.R * moved);
  }
  r.bodies.push_back(std::move(frame));
  r.meshes.push_back(std::move(part));
  return r;
}

}  // namespace liesl
