#ifdef LIESL_OPTIM

#include "apps/cli/part_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "apps/output/file.hpp"
#include "apps/output/shape_writer.hpp"
#include "apps/scene/outline_text.hpp"

namespace liesl {
namespace {

constexpr double kPointsACell = 2;  // of the outlines, in each direction

levelset::Box box_of(const SolidMesh& mesh) {
  return {mesh.nodes.rowwise().minCoeff(), mesh.nodes.rowwise().maxCoeff()};
}

/// Squares (cubes) for marching, about two a cell in each direction.
Eigen::Vector3i resolution(const SolidMesh& mesh) {
  const levelset::Box box = box_of(mesh);
  const Eigen::Vector3d size = (box.to - box.from).eval();
  const double volume = size.head(mesh.dim).prod();
  const double h = std::pow(volume / mesh.cell_count(), 1.0 / mesh.dim) / kPointsACell;
  return (size / h).array().ceil().cwiseMax(1).cast<int>();
}

std::vector<levelset::Polyline> outline_at(PartShape& part, const Eigen::VectorXd& x) {
  part.shape->set(part.design.parameters(x));
  const Eigen::Vector3i n = resolution(part.model.mesh());
  return levelset::outline(*part.shape, box_of(part.model.mesh()), n[0], n[1]);
}

void write_outlines(const std::filesystem::path& path, PartShape& part,
                    const std::vector<Eigen::VectorXd>& history) {
  std::string text = "step,line,x [m],y [m]\n";
  for (std::size_t step = 0; step < history.size(); ++step) {
    const auto lines = outline_at(part, history[step]);
    for (std::size_t l = 0; l < lines.size(); ++l)
      for (const auto& p : lines[l].points)
        text += fmt::format("{},{},{:.9g},{:.9g}\n", step + 1, l, p[0], p[1]);
  }
  output::write_file(path, text);
}

/// The load case with the largest stress of all, 0 if there is none.
Eigen::Index worst_case(const Eigen::MatrixXd& von_mises) {
  Eigen::Index cell = 0, load_case = 0;
  if (von_mises.size() > 0) von_mises.maxCoeff(&cell, &load_case);
  return load_case;
}

void write_cells(const std::filesystem::path& path, const SolidMesh& mesh, const PartFields& fields,
                 const Eigen::VectorXd& stress) {
  const bool gain = fields.hole_gain.size() > 0;
  std::string text;
  for (int c = 0; c < mesh.nodes_per_cell(); ++c) text += fmt::format("x{} [m],y{} [m],", c, c);
  text += "fraction,stress [Pa]";
  text += gain ? fmt::format(",hole_gain [{}]\n", fields.gain_unit) : "\n";
  for (int e = 0; e < mesh.cell_count(); ++e) {
    for (int c = 0; c < mesh.nodes_per_cell(); ++c) {
      const auto x = mesh.nodes.col(mesh.cells(c, e));
      text += fmt::format("{:.9g},{:.9g},", x[0], x[1]);
    }
    text += fmt::format("{:.6g},{:.6g}", fields.fractions[e], stress[e]);
    text += gain ? fmt::format(",{:.6g}\n", fields.hole_gain[e]) : "\n";
  }
  output::write_file(path, text);
}

/// Displacements of one case, 3 x nodes.
Eigen::MatrixXd in_space(const SolidMesh& mesh, const Eigen::VectorXd& u) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3, mesh.node_count());
  for (int i = 0; i < mesh.node_count(); ++i)
    out.col(i).head(mesh.dim) = u.segment(mesh.dim * i, mesh.dim);
  return out;
}

/// NAME_outline.toml: the tree of features, for a scene.
void write_outline(const std::filesystem::path& folder, const std::string& name,
                   const levelset::ShapeSpec& outline) {
  output::write_file(folder / (name + "_outline.toml"),
                     "# The final outline, to take the place of the scene's own. SI units.\n" +
                         outline_text(name, outline));
}

}  // namespace

void write_part(const std::filesystem::path& folder, const PartOutcome& outcome) {
  const std::string& name = outcome.name;
  PartShape& part = *outcome.shape;
  const std::vector<Eigen::VectorXd>& history = outcome.history;
  const PartFields& fields = outcome.fields;
  write_outline(folder, name, outcome.outline);
  const SolidMesh& mesh = part.model.mesh();
  const Eigen::Index worst = worst_case(fields.von_mises);
  const bool solved = fields.von_mises.size() > 0;
  const Eigen::VectorXd stress = solved ? Eigen::VectorXd(fields.von_mises.col(worst))
                                        : Eigen::VectorXd::Zero(mesh.cell_count());
  std::vector<output::MeshField> nodes;
  if (solved) nodes.emplace_back("displacement", in_space(mesh, fields.displacements.col(worst)));
  std::vector<output::MeshField> cells{{"fraction", fields.fractions.transpose()},
                                       {"von_mises", stress.transpose()}};
  if (fields.hole_gain.size() > 0) cells.emplace_back("hole_gain", fields.hole_gain.transpose());
  output::write_vtu(folder / (name + ".vtu"), mesh, cells, nodes);
  if (mesh.dim == 3) {
    part.shape->set(part.design.parameters(history.back()));
    const Eigen::Vector3i n = resolution(mesh);
    output::write_stl(folder / (name + ".stl"),
                      levelset::surface(*part.shape, box_of(mesh), n[0], n[1], n[2]));
    return;
  }
  const auto lines = outline_at(part, history.back());
  output::write_svg(folder / (name + ".svg"), lines);
  output::write_dxf(folder / (name + ".dxf"), lines);
  write_outlines(folder / (name + "_outlines.csv"), part, history);
  write_cells(folder / (name + "_cells.csv"), mesh, fields, stress);
}

}  // namespace liesl

#endif
