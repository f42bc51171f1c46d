#pragma once
/// @file
/// A plate (or block) with two ends and two holes: a small part for the tests of statics.

#include <string>
#include <vector>

#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl::test {

inline constexpr double kScale =
    0.004;  ///< largest change of a parameter in a sweep is 0.05 of this, m or 1

struct PlateCase {
  int dim = 2;
  bool relief = false;
  Tie tie = Tie::Rigid;
  std::string name() const {
    return std::string(dim == 2 ? "plane" : "space") + (relief ? "_relief_" : "_held_") +
           (tie == Tie::Rigid ? "rigid" : "averaged");
  }
};

inline std::vector<PlateCase> plate_cases() {
  std::vector<PlateCase> cases;
  for (int dim : {2, 3})
    for (bool relief : {false, true})
      for (Tie tie : {Tie::Rigid, Tie::Averaged}) cases.push_back({dim, relief, tie});
  return cases;
}

struct Plate {
  explicit Plate(const PlateCase& c)
      : shape(make_shape()), model(make_model(c)), support(make_support(c, model)) {
    const int a = model.port(0), b = model.port(1), r = model.rigid_count();
    loads = Eigen::MatrixXd::Zero(model.size(), 3);
    loads(b, 0) = 1000;  // pull
    loads(b + 1, 1) = 300;
    loads(b + r - 1, 2) = 20;  // moment
    loads(a + 1, 2) = 50;
    outputs.resize(model.size(), 3);
    outputs << elongation_output(model, 0, 1), relative_output(model, 0, 1, 1),
        node_output(model, middle_node(model.mesh()), 0);
  }
  SolidStatics statics() {
    SolidStatics s(model, support, outputs);
    s.set_loads(loads);
    return s;
  }
  Fractions fractions() const { return volume_fractions(model.mesh(), *shape); }

  levelset::LevelSetPtr shape;
  SolidModel model;
  SolidSupport support;
  Eigen::MatrixXd loads, outputs;

 private:
  static int middle_node(const SolidMesh& mesh) {
    return nodes_where(mesh, [](const Eigen::Vector3d& x) { return x[0] > 0.1 && x[1] > 0.005; })
        .front();
  }
  /// All but two holes, one of which crosses the upper side.
  static levelset::LevelSetPtr make_shape() {
    using namespace levelset;
    std::vector<Operand> operands;
    operands.push_back({"plate", placed_in_plane(0.1, 0, 0, rectangle(0.3, 0.051, 0.002))});
    operands.push_back(
        {"one", placed_in_plane(0.071, 0.002, 0.2, super_ellipse(0.03, 0.013, 3, 2.5))});
    operands.push_back({"two", placed_in_plane(0.141, 0.019, 0, levelset::circle(0.0131))});
    return subtract(std::move(operands), 0.003);
  }
  static SolidModel make_model(const PlateCase& c) {
    const SolidMesh mesh = c.dim == 2 ? quad_grid({0, -0.03}, {0.2, 0.03}, 27, 9)
                                      : hex_grid({0, -0.03, -0.01}, {0.2, 0.03, 0.01}, 17, 6, 2);
    SolidModel::Options options;
    options.thickness = 0.02;
    return SolidModel(mesh, {"steel", 210e9, 0.3, 7850},
                      {{"left", mesh.sets.at("x_min"), {0, 0, 0}, c.tie},
                       {"right", mesh.sets.at("x_max"), {0.2, 0, 0}, c.tie}},
                      options);
  }
  static SolidSupport make_support(const PlateCase& c, const SolidModel& model) {
    if (c.relief) return SolidSupport::relief();
    SolidSupport s;
    fix_port(s, model, 0, c.dim == 2 ? "xyr" : "xyzr");
    return s;
  }
};

}  // namespace liesl::test
