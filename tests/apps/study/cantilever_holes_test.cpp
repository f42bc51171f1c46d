/// @file
/// The shipped cantilever with holes against a published level-set result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "mbs/solids/solid_model.hpp"
#include "reference/bilinear_plate.hpp"
#include "reference/shipped.hpp"
#include "reference/solved.hpp"

namespace liesl::test::cantilever_holes_test {
namespace {

using Eigen::VectorXd;

constexpr int kNx = 40, kNy = 20;
constexpr double kNu = 0.3;

/// OpenLSTO (M2DO Lab, 2018) on 40 x 20 unit squares: E = 1, nu = 0.3, force 0.5 on the node in the
/// middle of the right side, stiffness of a cell max(v, 1e-3), f^T u at half of the area. Published
/// in JuliaTopOpt/TopOpt.jl, test/OpenLSTO/reference_40x20.txt: of the last ten of its 40
/// iterations, between which it swings by 0.4 %, the one whose area is nearest to a half.
struct OpenLsto {
  static constexpr double force = 0.5, void_stiffness = 1e-3;
  static constexpr double area = 5.0005472815654495e-01, compliance = 1.6346519358482819e+01;
};

/// Of the study, in the units of the publication: E t / F^2 f^T u F_published^2.
double normalised(const StudySpec& spec, const SolidSpec& solid, double compliance) {
  const double force = spec.loads.at(0).force.norm();
  return compliance * solid.model->material().E * solid.model->thickness() / (force * force) *
         OpenLsto::force * OpenLsto::force;
}

/// Fractions of the cells, row by row from below.
VectorXd fractions_of(const std::filesystem::path& table) {
  std::ifstream in(table);
  std::string line;
  std::getline(in, line);
  const std::string before = line.substr(0, line.find("fraction"));
  const auto commas = std::count(before.begin(), before.end(), ',');
  std::vector<double> v;
  while (std::getline(in, line)) {
    std::size_t at = 0;
    for (long i = 0; i < commas; ++i) at = line.find(',', at) + 1;
    v.push_back(std::stod(line.substr(at)));
  }
  return Eigen::Map<VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

TEST(CantileverHolesSlow, IsAsStiffAsThePublishedLevelSetResult) {
  const Study study = shipped_study("cantilever_holes");
  const int body = study.spec.shapes.begin()->first;
  const auto& solid = std::get<SolidSpec>(study.scene.mechanism.bodies[body].kind);
  const VectorXd v = fractions_of(solved_folder("cantilever_holes") / "plate_cells.csv");
  ASSERT_EQ(v.size(), kNx * kNy);
  EXPECT_LE(v.mean(), OpenLsto::area) << "no more material than there";

  // What liesl says of its design: the force on three nodes, an element with incompatible modes.
  const VectorXd law = (1e-3 + (1 - 1e-3) * v.array()).matrix();
  const double compliance = solved_summary("cantilever_holes").at("objective").at("final");
  const double own = normalised(study.spec, solid, compliance);
  EXPECT_NEAR(own / cantilever_compliance(kNx, kNy, kNu, OpenLsto::force, 1, law), 1, 0.01)
      << "the plain element agrees";

  // The same design as OpenLSTO measures its own.
  const double theirs = cantilever_compliance(kNx, kNy, kNu, OpenLsto::force, 0,
                                              v.cwiseMax(OpenLsto::void_stiffness));
  EXPECT_LE(theirs, OpenLsto::compliance);
  const double least =
      least_compliance(kNx, kNy, kNu, OpenLsto::force, 0,
                       v.cwiseMax(OpenLsto::void_stiffness).mean(), OpenLsto::void_stiffness);
  EXPECT_GE(theirs, least) << "stiffer than any sheet of this area can be";
  EXPECT_GE(OpenLsto::compliance, least);
  EXPECT_GT(least, 0);
  RecordProperty("published", std::to_string(OpenLsto::compliance));
  RecordProperty("own", std::to_string(own));
  RecordProperty("least_compliance", std::to_string(least));
  RecordProperty("compliance", std::to_string(theirs));
}

/// The element in closed form bends as it should: Timoshenko's cantilever, shear factor 5/6.
TEST(CantileverHoles, ReferenceElementIsRightForASlenderBar) {
  const double L = 160, h = 16, P = 1;
  const double I = h * h * h / 12, G = 1 / (2 * (1 + kNu));
  const double beam = P * P * (L * L * L / (3 * I) + L / (5. / 6 * G * h));
  const VectorXd full = VectorXd::Ones(160 * 16);
  EXPECT_NEAR(cantilever_compliance(160, 16, kNu, P, 8, full) / beam, 1, 0.005);
}

}  // namespace
}  // namespace liesl::test::cantilever_holes_test
