/// @file
/// Loads of a meshed part by the sets of its file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "apps/input/problem.hpp"
#include "apps/study/load_study.hpp"

namespace liesl::test::part_loads_test {
namespace {

/// A prism of three tetrahedra in a file, of which the node 7 and with it the set 'bare' is no
/// part.
class PartLoads : public testing::Test {
 protected:
  PartLoads() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "part.inp")
        << "*NODE\n1, 0, 0, 0\n2, 0, 1, 0\n3, 0, 0, 1\n4, 2, 0, 0\n5, 2, 1, 0\n6, 2, 0, 1\n7, 9, "
           "9, 9\n"
           "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n2, 2, 5, 3, 4\n3, 3, 5, 6, 4\n"
           "*NSET, NSET=left\n1, 2, 3\n*NSET, NSET=right\n4, 5, 6\n*NSET, NSET=bare\n7\n";
    std::ofstream(folder_ / "scene.toml") << R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.prism.solid]
mesh = { file = "part.inp" }
material = "steel"
modes = 0
interfaces = { left = { set = "left" } }
)";
  }
  ~PartLoads() override { std::filesystem::remove_all(folder_); }

  /// What a study with a load on `set` is told; empty: it is read.
  std::string told(const std::string& set) const;

 private:
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("liesl_part_loads_" + std::to_string(::getpid()));
};

std::string PartLoads::told(const std::string& set) const {
  const std::string text =
      "scene = \"scene.toml\"\n[objective]\nof = \"prism\"\n[loads]\npull = { on = \"prism." + set +
      "\", traction = [1e6, 0, 0] }\n";
  try {
    read_study(text, "study.toml", folder_);
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems)
      if (problem.text().find("set") != std::string::npos) return problem.text();
  }
  return {};
}

TEST_F(PartLoads, SetsWithoutNodesOfCellsAreToldFromThoseThatThereAreNot) {
  EXPECT_EQ(told("right"), "");
  EXPECT_NE(told("rigth").find("the part has no set of nodes 'rigth'"), std::string::npos)
      << told("rigth");
  EXPECT_NE(told("rigth").find("did you mean 'right'?"), std::string::npos) << told("rigth");
  EXPECT_NE(
      told("bare").find("the set 'bare' of the part has no node of a cell; expected a side of "
                        "the grid, a physical group or an *NSET, with nodes of cells"),
      std::string::npos)
      << told("bare");
}

}  // namespace
}  // namespace liesl::test::part_loads_test
