#include "apps/output/picture_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"
#include "tests/apps/output_sample.hpp"

namespace liesl::test::picture_writer_test {
namespace {

using namespace output;

const std::vector<double> kIdentity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// A flat bar of 20 mm (y) by 5 mm (z) along x; `turned` about its axis by 90 degrees.
BodyResult flat_bar(bool turned) {
  BodyResult bar;
  bar.name = turned ? "turned" : "flat, bar";
  bar.kind = "beam";
  bar.nodes = 2;
  bar.elements = {{0, 1}};
  for (int k = 0; k < 2; ++k)
    for (const double x : turned ? std::vector<double>{1, 0, 0, 0, 0, -1, 0, 1, 0} : kIdentity)
      bar.reference_rotations.push_back(x);
  bar.shapes = {"rectangle"};
  bar.dimensions = {0.02, 0.005, 0, 0};
  return bar;
}

TEST(PictureWriter, ThicknessIsThatAcrossTheLineOfSight) {
  const TemporaryFolder folder;
  Results r;
  r.bodies = {flat_bar(false), flat_bar(true)};
  write_sections_csv(folder.path() / "sections.csv", r);
  EXPECT_EQ(read_file(folder.path() / "sections.csv"),
            "body,element,along x [m],along y [m],along z [m]\n"
            "\"flat, bar\",0,0.02,0.005,0.02\n"
            "turned,0,0.02,0.02,0.005\n");
  r.bodies = {flat_bar(false)};
  r.bodies[0].shapes = {"full"};
  write_sections_csv(folder.path() / "none.csv", r);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "none.csv"));
}

/// Two squares side by side in a frame at (5, 0, 0), turned by 90 degrees about z; the amplitude
/// stretches them, the level set takes half of the right one.
Results moved_plate(int records = 3) {
  Results r;
  for (int n = 0; n < records; ++n) r.times.push_back(0.5 * n);
  BodyResult frame;
  frame.name = "plate";
  frame.nodes = 1;
  MeshResult mesh;
  mesh.thickness = 0.01;
  mesh.name = "plate";
  mesh.cells = {0, 1, 4, 3, 1, 2, 5, 4};
  mesh.reference = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
  mesh.level = {1, 1, -1, 1, 1, -1};
  mesh.basis = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0};
  for (int n = 0; n < records; ++n) {
    for (const double x : {5., 0., 0.}) frame.positions.push_back(x);
    for (const double x : {0., -1., 0., 1., 0., 0., 0., 0., 1.}) frame.rotations.push_back(x);
    mesh.amplitudes.push_back(0.1 * n);
  }
  r.bodies = {frame};
  r.meshes = {mesh};
  return r;
}

TEST(PictureWriter, LinesOfAPartAreItsDeformedOutline) {
  const TemporaryFolder folder;
  write_part_lines_csv(folder.path() / "lines.csv", moved_plate());
  const std::string text = read_file(folder.path() / "lines.csv");
  EXPECT_TRUE(
      text.starts_with("time [s],body,line,x [m],y [m],z [m],bending x [m],bending y [m],"
                       "bending z [m]\n0,plate,0,"));
  // Its right end, at 1.5 of the mesh, goes to y = 1.5 (1 + amplitude).
  for (const char* corner :
       {"0,plate,0,5,1.5,0,0,0,0", "0,plate,0,4,1.5,0,0,0,0", "1,plate,0,5,1.8,0,0,0.3,0"})
    EXPECT_NE(text.find(std::string("\n") + corner + "\n"), std::string::npos) << text;
  EXPECT_EQ(text.find(",plate,1,"), std::string::npos) << "one closed line";
  EXPECT_EQ(text.find(",2,0\n"), std::string::npos) << "nothing where there is no material";
}

/// Five instants of a motion are pictured, but every mode.
TEST(PictureWriter, EveryModeHasTheLinesOfItsParts) {
  const TemporaryFolder folder;
  Results r = moved_plate(10);
  const auto pictured = [&] {
    write_part_lines_csv(folder.path() / "lines.csv", r);
    std::set<std::string> records;
    std::istringstream lines(read_file(folder.path() / "lines.csv"));
    std::string line;
    std::getline(lines, line);  // heading
    while (std::getline(lines, line)) records.insert(line.substr(0, line.find(',')));
    return records.size();
  };
  EXPECT_EQ(pictured(), 5u);
  r.abscissa = "frequency";
  EXPECT_EQ(pictured(), 10u);
  r.bodies[0].reference_positions = {5, 0, 0};
  r.bodies[0].reference_rotations = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  r.times.front() = 0.25;  // before, as frequency 0, the part at rest
  EXPECT_EQ(pictured(), 11u);
  EXPECT_NE(read_file(folder.path() / "lines.csv").find("\n0,plate,0,5,"), std::string::npos);
}

/// A rod from the ground to a node of a beam that bends: its end bends with the beam.
TEST(PictureWriter, RodsAreLinesFromPortToPort) {
  const TemporaryFolder folder;
  Results r = moved_plate();
  r.meshes.clear();
  BodyResult& beam = r.bodies[0];
  beam.name = "boom", beam.kind = "beam", beam.nodes = 3;
  beam.elements = {{0, 1}, {1, 2}};
  beam.reference_positions = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  for (int k = 0; k < 3; ++k)
    beam.reference_rotations.insert(beam.reference_rotations.end(), kIdentity.begin(),
                                    kIdentity.end());
  beam.positions.clear(), beam.rotations.clear();
  for (std::size_t n = 0; n < r.times.size(); ++n)
    for (int k = 0; k < 3; ++k) {
      beam.positions.insert(beam.positions.end(), {1.0 * k, k == 1 ? 0.5 : 0, 0});
      beam.rotations.insert(beam.rotations.end(), {0, -1, 0, 1, 0, 0, 0, 0, 1});
    }
  r.joints.resize(2);
  r.joints[0].name = "lift", r.joints[0].type = "rod";
  r.joints[0].bodies = {"ground", "boom"}, r.joints[0].nodes = {0, 1};
  r.joints[0].places = {7, 8, 9, 0.25, 0, 0};
  r.joints[1] = r.joints[0];
  r.joints[1].name = "pin", r.joints[1].type = "revolute";
  write_part_lines_csv(folder.path() / "lines.csv", r);
  const std::string text = read_file(folder.path() / "lines.csv");
  EXPECT_NE(text.find("\n0,lift,0,7,8,9,0,0,0\n0,lift,0,1,0.75,0,0,0.5,0\n"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("pin"), std::string::npos);
}

/// A bow turned by 90 degrees, its middle moved by 0.1: that alone is drawn larger of a motion; in
/// statics it is the whole displacement, of rigid bodies and meshed parts, too.
TEST(PictureWriter, WhatIsDrawnLargerIsDeformationOrDisplacement) {
  const TemporaryFolder folder;
  Results r = moved_plate(1);
  r.bodies[0].reference_positions = {5, 0, 0.25};
  r.bodies[0].reference_rotations = r.bodies[0].rotations;
  r.bodies.resize(3);
  BodyResult &bow = r.bodies[1], &block = r.bodies[2];
  bow.name = "bow", bow.kind = "beam", bow.nodes = 3;
  bow.elements = {{0, 1}, {1, 2}};
  bow.reference_positions = {0, 0, 0, 1, 1, 0, 2, 0, 0};
  bow.positions = {0, 0, 0, -1, 1.125, 0, 0, 2, 0};
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 9; ++i) {
      bow.reference_rotations.push_back(kIdentity[i]);
      bow.rotations.push_back(r.bodies[0].rotations[i]);
    }
  block.name = "block", block.kind = "rigid", block.nodes = 1;
  block.points = {0, 0, 0, 2, 0, 0};
  block.positions = {1, 0, 0}, block.reference_positions = {0, 0, 0};
  block.rotations = r.bodies[0].rotations, block.reference_rotations = kIdentity;
  const auto has = [&](const std::string& row) {
    write_frames_csv(folder.path() / "frames.csv", r);
    write_part_lines_csv(folder.path() / "lines.csv", r);
    return (read_file(folder.path() / "frames.csv") + read_file(folder.path() / "lines.csv"))
               .find("\n" + row + "\n") != std::string::npos;
  };
  EXPECT_TRUE(has("0,bow,beam,1,-1,1.125,0,0,0.125,0") && has("0,block,0,1,2,0,0,0,0"));
  EXPECT_TRUE(has("0,plate,0,5,1.5,0,0,0,0"));
  r.abscissa = "load_factor";
  EXPECT_TRUE(has("0,bow,beam,1,-1,1.125,0,-2,0.125,0") && has("0,block,0,1,2,0,-1,2,0"));
  EXPECT_TRUE(has("0,plate,0,5,1.5,0,0,0,-0.25"));
}

/// Turned by 90 degrees about z at (5, 0, 0): from its centre of mass to a point and a joint; not
/// to a joint at the centre.
TEST(PictureWriter, RigidBodiesReachFromTheirCentreToPointsAndJoints) {
  const TemporaryFolder folder;
  Results r = moved_plate();
  r.meshes.clear();
  r.bodies[0].name = "crank";
  r.bodies[0].kind = "rigid";
  r.bodies[0].points = {1, 0, 0, 2, 0, 0};
  r.joints.resize(2);
  r.joints[0].bodies = {"crank", "rod"};
  r.joints[0].places = {0, 3, 0, 7, 7, 7};
  r.joints[1].bodies = {"ground", "crank"};
  r.joints[1].places = {7, 7, 7, 1, 0, 0};
  write_part_lines_csv(folder.path() / "lines.csv", r);
  const std::string text = read_file(folder.path() / "lines.csv");
  EXPECT_NE(text.find("\n0,crank,0,5,1,0,0,0,0\n0,crank,0,5,2,0,0,0,0\n"
                      "0,crank,1,5,1,0,0,0,0\n0,crank,1,2,0,0,0,0,0\n0.5,crank,0,"),
            std::string::npos)
      << text;
}

/// The record nearest to a peak is among the instants, however many are left out.
TEST(PictureWriter, PeaksAreAmongTheInstants) {
  const TemporaryFolder folder;
  Results r = moved_plate(1000);
  EXPECT_EQ(r.record_near(-1), 0);
  EXPECT_EQ(r.record_near(1e9), 999);
  EXPECT_EQ(r.record_near(100.6), 201);
  r.peaks = {r.record_near(100.6)};
  write_part_lines_csv(folder.path() / "lines.csv", r);
  EXPECT_NE(read_file(folder.path() / "lines.csv").find("\n100.5,plate,0,"), std::string::npos);
  const std::vector<int> frames = frame_records(r, kFrames);
  EXPECT_EQ(frames.size(), 14u);
  EXPECT_TRUE(std::ranges::is_sorted(frames) && std::ranges::count(frames, 201) == 1);
}

TEST(PictureWriter, NoFileWithoutMeshedParts) {
  const TemporaryFolder folder;
  Results r = moved_plate();
  r.meshes.clear();
  write_part_lines_csv(folder.path() / "lines.csv", r);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "lines.csv"));
}

}  // namespace
}  // namespace liesl::test::picture_writer_test
