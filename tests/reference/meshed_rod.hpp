#pragma once
/// @file
/// A slider-crank with a slender rod of rectangular section, as a beam or as a mesh.

#include "mbs/model/response.hpp"
#include "reference/mechanisms.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test {

inline constexpr double kRodLength = 0.3, kRodHeight = 0.014, kRodThickness = 0.01;

/// The rod as a mesh from the pin of the crank to the slider; interfaces start, end, mid.
/// @param nz layers of hexahedra through the thickness; 0: quadrilaterals
inline SolidSpec meshed_rod(const Vec3& from, int nx, int ny, int modes, int nz = 0) {
  SolidSpec s;
  s.frame.x = from;
  const Vec3 half(0, kRodHeight / 2, kRodThickness / 2), end(kRodLength, 0, 0);
  SolidMesh mesh = nz > 0 ? hex_grid(-half, end + half, nx, ny, nz)
                          : quad_grid(-half.head<2>(), (end + half).head<2>(), nx, ny);
  const auto at = [&mesh](double x) {
    return nodes_where(mesh, [x](const Vec3& p) { return std::abs(p[0] - x) < 1e-9; });
  };
  std::vector<Interface> interfaces = {
      {"start", at(0), {0, 0, 0}, Tie::Rigid},
      {"end", at(kRodLength), {kRodLength, 0, 0}, Tie::Rigid},
      {"mid", at(kRodLength / 2), {kRodLength / 2, 0, 0}, Tie::Averaged}};
  s.model = std::make_shared<const SolidModel>(std::move(mesh), steel(), std::move(interfaces),
                                               SolidModel::Options{kRodThickness, {}});
  s.modes = modes;
  return s;
}

/// Rigid crank, driven at 150 rad/s after a ramp of 0.04 s.
template <class Rod>
Mechanism slider_crank_with(const Rod& rod, int last) {
  Mechanism m;
  m.name = "slider-crank";
  m.bodies = {{"crank", block({0, 0, 0}, 1, 1e-3)},
              {"rod", rod},
              {"slider", block({0.15 + kRodLength, 0, 0}, 0.2, 1e-4)}};
  const Port pin{0, 0, SE3(Mat3::Identity(), {0.15, 0, 0})};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}},
              {"pin", JointType::Revolute, pin, {1, 0}},
              {"wrist", JointType::Revolute, {1, last}, {2, 0}},
              {"guide", JointType::Prismatic, {}, {2, 0}, Vec3::UnitX()}};
  m.drives = {{0, 0, TimeFunction::rate(150, 0.04)}};
  return m;
}

inline Mechanism slider_crank_with_mesh(int nx = 60, int ny = 4, int modes = 6, int nz = 0) {
  return slider_crank_with(meshed_rod({0.15, 0, 0}, nx, ny, modes, nz), 1);
}

inline Mechanism slider_crank_with_beam(int n = 16) {
  Section s;
  s.shape = Rectangle{kRodHeight, kRodThickness};  // width along y, in the plane
  s.shear_factor = {5. / 6, 5. / 6};
  return slider_crank_with(straight_beam({0.15, 0, 0}, {0.15 + kRodLength, 0, 0}, n, s, steel()),
                           n);
}

/// What the middle of the rod bends by, across it.
inline ResponseSpec bend_of_the_rod(const Mechanism& m) {
  ResponseSpec bend;
  bend.kind = ResponseKind::Displacement;
  bend.at = *m.port("rod.mid");
  bend.axis = Vec3::UnitY();
  return bend;
}

}  // namespace liesl::test
