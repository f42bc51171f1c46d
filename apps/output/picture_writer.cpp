#include "apps/output/picture_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "apps/output/csv_writer.hpp"
#include "apps/output/cut_mesh.hpp"
#include "apps/output/enlarged.hpp"
#include "apps/output/file.hpp"
#include "liegroup/smallest_rotation.hpp"

namespace liesl::output {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const double kSharp = std::cos(30 * M_PI / 180);  // of the angle between two normals

/// Extent of a section along a direction (d_y, d_z) of its plane; 0 if it has no shape.
double extent(const std::string& shape, const double* dimensions, double dy, double dz) {
  if (shape == "circle" || shape == "tube") return dimensions[0];
  if (shape == "rectangle" || shape == "box" || shape == "I")
    return std::abs(dy) * dimensions[0] + std::abs(dz) * dimensions[1];
  return 0;
}

/// What is seen of an element along axis `k` of the scene: its extent across itself and across the
/// line of sight.
double seen_along(const BodyResult& body, std::size_t e, int k) {
  const auto node = static_cast<std::size_t>(body.elements[e][0]);
  const Matrix3d R = axes_at(body.reference_rotations, node);
  const double* d = &body.dimensions[kMostDimensions * e];
  const Vector3d across = R.col(0).cross(Vector3d::Unit(k));
  if (across.norm() < 1e-6)
    return std::max(extent(body.shapes[e], d, 1, 0), extent(body.shapes[e], d, 0, 1));
  const Vector3d n = across.normalized();
  return extent(body.shapes[e], d, R.col(1).dot(n), R.col(2).dot(n));
}

/// Lines of a mesh at rest, by vertices.
std::vector<std::vector<std::uint32_t>> closed_sides(const CutMesh& mesh) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : mesh.sides) next[a] = b;  // a vertex that two lines share ends one
  std::vector<std::vector<std::uint32_t>> lines;
  while (!next.empty()) {
    auto& line = lines.emplace_back();
    for (auto at = next.begin(); at != next.end(); at = next.find(line.back())) {
      if (line.empty()) line.push_back(at->first);
      line.push_back(at->second);
      next.erase(at);
    }
  }
  return lines;
}

std::vector<std::vector<std::uint32_t>> sharp_edges(const CutMesh& mesh,
                                                    const std::vector<Vector3d>& x) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector3d> normals;
  std::vector<std::vector<std::uint32_t>> lines;
  for (const auto& t : mesh.triangles) {
    const Vector3d n = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      const auto [at, first] = normals.try_emplace(std::minmax(a, b), n);
      if (!first && at->second.dot(n) < kSharp) lines.push_back({a, b});
    }
  }
  return lines;
}

/// A row of part_lines.csv. @param bending what of the place is drawn larger
void put_point(std::string& text, const std::string& start, const std::string& name,
               std::size_t line, const Vector3d& x, const Vector3d& bending) {
  fmt::format_to(std::back_inserter(text), "{},{},{},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n",
                 start, name, line, x[0], x[1], x[2], bending[0], bending[1], bending[2]);
}

/// A meshed part, ready to be drawn at any record.
class PartLines {
 public:
  PartLines(const MeshResult& mesh, const BodyResult& body)
      : mesh_(mesh),
        body_(body),
        cut_(
            cut_mesh(cell_kind(mesh.dim(), mesh.corners), mesh.cells, mesh.reference, mesh.level)) {
    const auto rest = places(mesh.reference);
    far_ = farthest_interface();
    lines_ = mesh.dim() == 2 ? closed_sides(cut_) : sharp_edges(cut_, rest);
  }

  /// @param row where the series of bodies hold the record  @param from_rest see enlarged.hpp
  void put(std::string& text, const std::string& start, const std::string& name, std::size_t record,
           std::size_t row, bool from_rest) const {
    const std::vector<Vector3d> x = at(record, row), rest = places(mesh_.reference);
    const Chord chord = from_rest && !body_.reference_positions.empty() ? at_rest() : chord_at(row);
    for (std::size_t l = 0; l < lines_.size(); ++l)
      for (const std::uint32_t v : lines_[l])
        put_point(text, start, name, l, x[v], x[v] - chord.carry(rest[v]));
  }

  void put_at_rest(std::string& text, const std::string& start, const std::string& name) const {
    const std::vector<Vector3d> rest = places(mesh_.reference);
    for (std::size_t l = 0; l < lines_.size(); ++l)
      for (const std::uint32_t v : lines_[l])
        put_point(text, start, name, l, at_rest().carry(rest[v]), Vector3d::Zero());
  }

 private:
  /// The line from the first interface to the one farthest from it: where it is, and how long.
  struct Chord {
    Vector3d x0, rest, stretch;  ///< m; at rest in the axes of the first interface
    Matrix3d turn;
    /// A place at rest, carried along without bending.
    Vector3d carry(const Vector3d& x) const {
      const double square = rest.squaredNorm();
      return x0 + turn * x + (square > 0 ? x.dot(rest) / square : 0) * stretch;
    }
  };

  std::size_t farthest_interface() const {
    std::size_t far = 0;
    for (std::size_t i = 0; 3 * i < mesh_.interfaces.size(); ++i)
      if (vector_at(mesh_.interfaces, i).norm() > vector_at(mesh_.interfaces, far).norm()) far = i;
    return far;
  }

  Chord at_rest() const {
    return {vector_at(body_.reference_positions, 0), Vector3d::Zero(), Vector3d::Zero(),
            axes_at(body_.reference_rotations, 0)};
  }

  Chord chord_at(std::size_t row) const {
    const std::size_t frame = row * static_cast<std::size_t>(body_.nodes);
    const Matrix3d R0 = axes_at(body_.rotations, frame);
    Chord out{vector_at(body_.positions, frame), Vector3d::Zero(), Vector3d::Zero(), R0};
    if (far_ == 0) return out;
    const Vector3d now = vector_at(body_.positions, frame + far_) - out.x0;
    out.rest = vector_at(mesh_.interfaces, far_);
    out.turn = smallest_rotation((R0 * out.rest).normalized(), now.normalized()) * R0;
    out.stretch = now - out.turn * out.rest;
    return out;
  }

  std::vector<Vector3d> places(const std::vector<double>& nodes) const {
    std::vector<Vector3d> out;
    for (const auto& v : cut_.vertices)
      out.push_back((1 - v.t) * vector_at(nodes, std::size_t(v.i)) +
                    v.t * vector_at(nodes, std::size_t(v.j)));
    return out;
  }

  /// x_0 + R_0 (reference + basis amplitudes) of the vertices.
  std::vector<Vector3d> at(std::size_t record, std::size_t row) const {
    const std::size_t size = mesh_.reference.size(), k = mesh_.basis.size() / size;
    std::vector<double> nodes = mesh_.reference;
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t i = 0; i < size; ++i)
        nodes[i] += mesh_.amplitudes[record * k + j] * mesh_.basis[j * size + i];
    const std::size_t frame = row * static_cast<std::size_t>(body_.nodes);
    const Vector3d x0 = vector_at(body_.positions, frame);
    const Matrix3d R0 = axes_at(body_.rotations, frame);
    std::vector<Vector3d> out = places(nodes);
    for (Vector3d& x : out) x = x0 + R0 * x;
    return out;
  }

  const MeshResult& mesh_;
  const BodyResult& body_;
  CutMesh cut_;
  std::size_t far_ = 0;  ///< interface at the other end of the chord; 0: there is no other
  std::vector<std::vector<std::uint32_t>> lines_;
};

/// Which of the instants are pictured, as `few` of apps/plot/mechanism.py has it: those nearest to
/// five that are evenly spread, where they grow; else spread by their number.
std::vector<int> few(const std::vector<double>& instants) {
  const int n = static_cast<int>(instants.size());
  if (n == 0 || !std::is_sorted(instants.begin(), instants.end()))
    return spread_records(n, kPictured);
  std::vector<int> out;
  for (int i = 0; i < kPictured; ++i) {
    const double at = instants.front() + (instants.back() - instants.front()) * i / (kPictured - 1);
    const auto nearer = [at](double a, double b) { return std::abs(a - at) < std::abs(b - at); };
    out.push_back(static_cast<int>(std::min_element(instants.begin(), instants.end(), nearer) -
                                   instants.begin()));
  }
  return out;
}

/// Records of the pictured instants: few of those of frames.csv, and the peaks. Of modes, each of
/// which has a panel, all of those.
std::vector<int> pictured(const Results& results) {
  const std::vector<int> frames = frame_records(results, kFrames);
  if (results.abscissa == "frequency") return frames;
  std::vector<int> out = results.peaks;
  std::vector<double> instants;
  for (const int record : frames)
    instants.push_back(results.times[static_cast<std::size_t>(record)]);
  for (const int i : few(instants)) out.push_back(frames[static_cast<std::size_t>(i)]);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// From the centre of mass of a rigid body to its points and joints, in its axes; not those that
/// are there.
std::vector<Vector3d> arms_of(const BodyResult& body, const std::vector<JointResult>& joints) {
  std::vector<Vector3d> arms;
  for (std::size_t i = 1; 3 * i < body.points.size(); ++i)
    arms.push_back(vector_at(body.points, i));
  for (const JointResult& joint : joints)
    for (std::size_t end = 0; end < joint.bodies.size() && !joint.places.empty(); ++end)
      if (joint.bodies[end] == body.name) arms.push_back(vector_at(joint.places, end));
  const Vector3d centre = vector_at(body.points, 0);
  std::erase_if(arms, [&](const Vector3d& arm) { return arm.isApprox(centre); });
  return arms;
}

/// A place on a node of a body, and what of it is drawn larger.
void put_place(std::string& text, const std::string& start, const std::string& name,
               std::size_t line, const BodyResult& body, std::size_t row, int node,
               const Vector3d& place, const Enlarged& bending) {
  const std::size_t at =
      row * static_cast<std::size_t>(body.nodes) + static_cast<std::size_t>(node);
  put_point(text, start, field(name), line,
            vector_at(body.positions, at) + axes_at(body.rotations, at) * place,
            bending.at(node, place));
}

/// @param row where the series of bodies hold the record
void put_rigid(std::string& text, const std::string& start, const Results& results,
               const BodyResult& body, const std::vector<Vector3d>& arms, std::size_t row) {
  const Enlarged bending(results, body, row);
  for (std::size_t l = 0; l < arms.size(); ++l)
    for (const Vector3d& end : {vector_at(body.points, 0), arms[l]})
      put_place(text, start, body.name, l, body, row, 0, end, bending);
}

/// A joint that is a body without mass, from port to port.
void put_link(std::string& text, const std::string& start, const Results& results,
              const JointResult& joint, std::size_t row) {
  for (std::size_t end = 0; end < 2; ++end) {
    const Vector3d place = vector_at(joint.places, end);
    const auto body = std::ranges::find(results.bodies, joint.bodies[end], &BodyResult::name);
    if (body == results.bodies.end())  // the ground
      put_point(text, start, field(joint.name), 0, place, Vector3d::Zero());
    else
      put_place(text, start, joint.name, 0, *body, row, joint.nodes[end], place,
                Enlarged(results, *body, row));
  }
}

}  // namespace

void write_sections_csv(const std::filesystem::path& path, const Results& results) {
  std::string text = "body,element,along x [m],along y [m],along z [m]\n";
  const std::size_t head = text.size();
  for (const BodyResult& body : results.bodies) {
    std::vector<Vector3d> seen;
    for (std::size_t e = 0; e < body.shapes.size() && !body.reference_rotations.empty(); ++e)
      seen.emplace_back(seen_along(body, e, 0), seen_along(body, e, 1), seen_along(body, e, 2));
    if (std::all_of(seen.begin(), seen.end(), [](const Vector3d& s) { return s.isZero(0); }))
      continue;
    for (std::size_t e = 0; e < seen.size(); ++e)
      fmt::format_to(std::back_inserter(text), "{},{},{:.6g},{:.6g},{:.6g}\n", field(body.name), e,
                     seen[e][0], seen[e][1], seen[e][2]);
  }
  if (text.size() > head) write_file(path, text);
}

void write_part_lines_csv(const std::filesystem::path& path, const Results& results) {
  std::string text = heading(results.abscissa, results.abscissa_unit) +
                     ",body,line,x [m],y [m],z [m],"
                     "bending x [m],bending y [m],bending z [m]\n";
  const std::size_t head = text.size();
  for (const MeshResult& mesh : results.meshes) {
    const auto body = std::find_if(results.bodies.begin(), results.bodies.end(),
                                   [&](const BodyResult& b) { return b.name == mesh.name; });
    if (body == results.bodies.end() || mesh.reference.empty()) continue;
    const PartLines lines(mesh, *body);
    if (results.abscissa == "frequency" && !body->reference_positions.empty())
      lines.put_at_rest(text, kAtRest, field(mesh.name));
    for (const int record : pictured(results))
      lines.put(text, fmt::format("{}", results.times[std::size_t(record)]), field(mesh.name),
                std::size_t(record), results.row(record), from_rest(results));
  }
  for (const BodyResult& body : results.bodies)
    if (body.kind == "rigid" && body.nodes == 1 && !body.points.empty())
      for (const int record : pictured(results))
        put_rigid(text, fmt::format("{}", results.times[std::size_t(record)]), results, body,
                  arms_of(body, results.joints), results.row(record));
  for (const JointResult& joint : results.joints)
    if ((joint.type == "rod" || joint.type == "cylinder") && joint.places.size() == 6)
      for (const int record : pictured(results))
        put_link(text, fmt::format("{}", results.times[std::size_t(record)]), results, joint,
                 results.row(record));
  if (text.size() > head) write_file(path, text);
}

}  // namespace liesl::output
