#include "apps/export/part_matrices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "apps/mesh/matrix_file.hpp"
#include "apps/mesh/matrix_market.hpp"
#include "apps/output/file.hpp"
#include "liegroup/so3.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

std::string list(const Eigen::Vector3d& x, int dim) {
  return fmt::format("[{}]", fmt::join(x.data(), x.data() + dim, ", "));
}

/// The table `bodies.NAME.solid`.
std::string scene_part(const std::string& name, const SolidSpec& solid) {
  const int dim = solid.mesh().dim;
  std::string text = fmt::format(
      "# Takes the place of bodies.{0} in a scene in the folder of these files. SI units.\n"
      "[bodies.{0}.solid]\nat = {1}\norientation = {2}\nmodes = {3}\ndamping = {4}\n"
      "matrices = {{ stiffness = \"{0}_stiffness.mtx\", mass = \"{0}_mass.mtx\", nodes = "
      "\"{0}_nodes.mtx\" }}\n",
      name, list(solid.frame.x, 3), list(SO3::log(solid.frame.R), 3), solid.modes, solid.damping);
  for (const Interface& f : solid.interfaces()) {
    std::vector<int> numbers;
    for (const int node : f.nodes) numbers.push_back(node + 1);
    text += fmt::format("[bodies.{}.solid.interfaces.{}]\nnodes = [{}]\npoint = {}\ntie = \"{}\"\n",
                        name, f.name, fmt::join(numbers, ", "), list(f.point, dim),
                        f.tie == Tie::Rigid ? "rigid" : "averaged");
  }
  return text;
}

}  // namespace

void write_part_matrices(const std::filesystem::path& folder, const std::string& name,
                         const SolidSpec& solid) {
  const SolidModel& model = *solid.model;
  const SolidMesh& mesh = model.mesh();
  if (mesh.cell_count() == 0)
    throw std::invalid_argument("'" + name + "' is given by matrices; expected a part with a mesh");
  const SolidModel free(mesh, model.material(), {}, {model.thickness(), model.law()});
  const Eigen::VectorXd v = solid_fractions(solid).value;
  PartMatrices part = {{mesh.dim, mesh.nodes, {}, {}}, {free.stiffness(v), free.mass(v)}};
  const std::string freedoms = fmt::format("'{}': freedoms {} of node 1, of node 2, ...", name,
                                           mesh.dim == 2 ? "x, y" : "x, y, z");
  output::write_file(folder / (name + "_stiffness.mtx"),
                     symmetric_text(part.matrices.K, "N/m, " + freedoms));
  output::write_file(folder / (name + "_mass.mtx"),
                     symmetric_text(part.matrices.M, "kg, " + freedoms));
  output::write_file(
      folder / (name + "_nodes.mtx"),
      dense_text(mesh.nodes.topRows(mesh.dim).transpose(), "m, a row a node, '" + name + "'"));
  output::write_file(folder / (name + ".toml"), scene_part(name, solid));
  for (const Interface& f : solid.interfaces()) part.nodes.sets[f.name] = f.nodes;
  write_matrix_file(folder / (name + ".h5"), part);
}

}  // namespace liesl
