#include "apps/export/part_matrices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "apps/mesh/matrix_market.hpp"
#include "liegroup/so3.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

std::string list(const Vec3& x, int dim) {
  return fmt::format("[{}]", fmt::join(x.data(), x.data() + dim, ", "));
}

/// The table `bodies.NAME.solid`.
std::string scene_part(const std::string& name, const SolidSpec& solid) {
  const int dim = solid.mesh().dim;
  std::string text = fmt::format(
      "# Takes the place of bodies.{0} in a scene beside these files. SI units.\n"
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

std::map<std::string, std::string> matrix_files(const std::string& name, const SolidSpec& solid) {
  const SolidModel& part = *solid.model;
  const SolidMesh& mesh = part.mesh();
  if (part.nodal_mass())
    throw std::invalid_argument("'" + name + "' is given by matrices; expected a part with a mesh");
  const SolidModel free(mesh, part.material(), {}, {part.thickness(), part.law()});
  const Eigen::VectorXd v = solid_fractions(solid).value;
  const std::string freedoms = fmt::format("'{}': freedoms {} of node 1, of node 2, ...", name,
                                           mesh.dim == 2 ? "x, y" : "x, y, z");
  return {{name + "_stiffness.mtx", symmetric_text(free.stiffness(v), "N/m, " + freedoms)},
          {name + "_mass.mtx", symmetric_text(free.mass(v), "kg, " + freedoms)},
          {name + "_nodes.mtx",
           dense_text(mesh.nodes.topRows(mesh.dim).transpose(), "m, a row a node, '" + name + "'")},
          {name + ".toml", scene_part(name, solid)}};
}

}  // namespace liesl
