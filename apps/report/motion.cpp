#include "apps/report/motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/output/cut_mesh.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/results.hpp"

namespace liesl::report {
namespace {

using output::cut_mesh;
using output::CutMesh;
using output::Hdf5Input;
using output::Hdf5Numbers;

/// Reads the data sets of one body, one meshed part or one joint.
class Group {
 public:
  Group(const Hdf5Input& file, std::string name, const std::vector<int>& records)
      : file_(file), name_(std::move(name)), records_(records) {}

  bool has(const std::string& set) const { return file_.has(name_ + set); }
  std::vector<std::size_t> shape(const std::string& set) const { return file_.shape(name_ + set); }
  std::string attribute(const std::string& key) const { return file_.attribute(name_, key); }
  std::vector<std::string> texts(const std::string& set) const { return file_.texts(name_ + set); }
  Hdf5Numbers whole(const std::string& set) const { return file_.numbers(name_ + set); }
  Hdf5Numbers shown(const std::string& set) const { return file_.numbers(name_ + set, records_); }

 private:
  const Hdf5Input& file_;
  std::string name_;
  const std::vector<int>& records_;
};

std::vector<int> integers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Rotation matrices by rows as quaternions x, y, z, w, each near the one before it of its node.
std::vector<double> quaternions(const std::vector<double>& R, std::size_t nodes) {
  std::vector<double> out;
  for (std::size_t i = 0; i < R.size() / 9; ++i) {
    using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Vector4d q = Eigen::Quaterniond(Eigen::Matrix3d(Rows::Map(&R[9 * i]))).coeffs();
    if (i >= nodes && q.dot(Eigen::Vector4d::Map(&out[4 * (i - nodes)])) < 0) q = -q;
    out.insert(out.end(), q.data(), q.data() + 4);
  }
  return out;
}

Json body(const Group& group, const std::string& name, Blob& blob) {
  const Hdf5Numbers x = group.shown("/position");
  const std::size_t N = x.shape.at(1);
  Json json = {{"name", name}, {"kind", group.attribute("kind")}, {"nodes", N}};
  json["x"] = blob.components(x.values, 3, Blob::Digits::Seven);
  json["q"] =
      blob.components(quaternions(group.shown("/rotation").values, N), 4, Blob::Digits::Five);
  json["x0"] = blob.f32(group.whole("/reference_position").values);
  json["q0"] = blob.f32(quaternions(group.whole("/reference_rotation").values, N));
  json["elements"] = integers(group.whole("/elements").values);
  json["shapes"] = group.texts("/shape");
  json["dimensions"] = group.whole("/dimension").values;
  json["points"] = group.whole("/point").values;
  if (const Hdf5Numbers force = group.shown("/node_force"); !force.empty())
    json["force"] = blob.components(force.values, 6, Blob::Digits::Five);
  if (const Hdf5Numbers stress = group.shown("/stress"); !stress.empty())
    json["stress"] = blob.i16(stress.values);
  return json;
}

/// Values [N, 3] of nodes at the vertices of a cut mesh.
std::vector<double> at_vertices(const CutMesh& mesh, const double* nodes) {
  std::vector<double> out;
  for (const auto& v : mesh.vertices)
    for (int c = 0; c < 3; ++c)
      out.push_back((1 - v.t) * nodes[3 * v.i + c] + v.t * nodes[3 * v.j + c]);
  return out;
}

/// Values [M, C] of cells at the nodes [N, 3]: component c and the two after it, weighted by how
/// much of each cell is material.
std::vector<double> from_cells(const double* values, std::size_t C, std::size_t c,
                               const Hdf5Numbers& cells, const std::vector<double>& fractions,
                               std::size_t N) {
  std::vector<double> sum(3 * N, 0.0), weight(N, 0.0);
  const std::size_t per_cell = cells.shape[1];
  for (std::size_t i = 0; i < cells.values.size(); ++i) {
    const std::size_t cell = i / per_cell, node = static_cast<std::size_t>(cells.values[i]);
    weight.at(node) += fractions.at(cell);
    for (std::size_t k = 0; k < 3; ++k)
      sum[3 * node + k] += fractions[cell] * values[C * cell + c + k];
  }
  for (std::size_t i = 0; i < 3 * N; ++i) sum[i] /= std::max(weight[i / 3], 1e-12);
  return sum;
}

/// Components of the stress at the vertices by amplitude: 3 or 6 arrays each.
Json stress_basis(const Group& group, const CutMesh& cut, const Hdf5Numbers& cells, std::size_t N,
                  Blob& blob) {
  Json list = Json::array();
  const Hdf5Numbers basis = group.whole("/stress_basis");
  const auto fractions = group.whole("/fraction").values;
  for (std::size_t k = 0; !basis.empty() && k < basis.shape[0]; ++k) {
    Json components = Json::array();
    for (std::size_t c = 0; c < basis.shape.at(2); c += 3) {
      const auto nodes =
          from_cells(&basis.values[k * basis.row()], basis.shape[2], c, cells, fractions, N);
      for (auto& array : blob.components(at_vertices(cut, nodes.data()), 3, Blob::Digits::Five))
        components.push_back(array);
    }
    list.push_back(std::move(components));
  }
  return list;
}

template <class Polygons>
Json indices(const Polygons& polygons, Blob& blob) {
  std::vector<std::uint32_t> out;
  for (const auto& polygon : polygons) out.insert(out.end(), polygon.begin(), polygon.end());
  return blob.u32(out);
}

/// A meshed part: what is material at rest, and how it moves with the amplitudes. A part without
/// cells is drawn as a rigid body is.
Json solid(const Group& group, const std::string& name, Blob& blob) {
  const Hdf5Numbers reference = group.whole("/reference"), cells = group.whole("/cells");
  if (reference.empty() || cells.empty()) return nullptr;
  const CellKind& kind =
      output::stored_cells(group.attribute("cell"), static_cast<int>(cells.shape[1]));
  const CutMesh cut =
      cut_mesh(kind, integers(cells.values), reference.values, group.whole("/level").values);
  const auto thickness = group.whole("/thickness").values;
  Json json = {{"name", name}, {"planar", kind.dim == 2}};
  json["thickness"] = thickness.empty() ? 0 : thickness[0];
  json["interfaces"] = group.whole("/interface").values;
  json["x0"] = blob.components(at_vertices(cut, reference.values.data()), 3, Blob::Digits::Seven);
  json["triangles"] = indices(cut.triangles, blob);
  json["sides"] = indices(cut.sides, blob);
  json["basis"] = Json::array();
  const Hdf5Numbers basis = group.whole("/basis");
  for (std::size_t k = 0; !basis.empty() && k < basis.shape[0]; ++k)
    json["basis"].push_back(
        blob.components(at_vertices(cut, &basis.values[k * basis.row()]), 3, Blob::Digits::Five));
  json["stress"] = stress_basis(group, cut, cells, reference.shape[0], blob);
  json["amplitude"] = blob.f32(group.shown("/amplitude").values);
  return json;
}

Json joint(const Group& group, const std::string& name) {
  return {{"name", name},
          {"type", group.attribute("type")},
          {"bodies", {group.attribute("a"), group.attribute("b")}},
          {"nodes", integers(group.whole("/node").values)},
          {"places", group.whole("/place").values},
          {"axis", group.whole("/axis").values}};
}

/// Bytes of an instant: nodes with places, turns, forces and stresses, and amplitudes.
double bytes_an_instant(const Hdf5Input& file) {
  constexpr double kPlanarNode = 24, kSpatialNode = 36;
  const double node = file.attribute("/", "space") == "planar" ? kPlanarNode : kSpatialNode;
  double bytes = 4;
  for (const std::string& name : file.children("/bodies"))
    bytes += node * static_cast<double>(file.shape("/bodies/" + name + "/position").at(1));
  for (const std::string& name : file.children("/meshes"))
    if (const auto shape = file.shape("/meshes/" + name + "/amplitude"); shape.size() == 2)
      bytes += 4 * static_cast<double>(shape[1]);
  return bytes;
}

/// The record nearest to an instant: the first, as load factors may fall again.
int record_near(const std::vector<double>& t, double at) {
  const auto off = [&](double a, double b) { return std::abs(a - at) < std::abs(b - at); };
  return static_cast<int>(std::min_element(t.begin(), t.end(), off) - t.begin());
}

/// Is a limit one of the motion that is shown?
bool is_shown(const std::string& limit, const Json& scenarios) {
  return scenarios.empty() || limit.ends_with(" (" + scenarios.at(0).get<std::string>() + ")");
}

}  // namespace

std::optional<double> opening(const Json& summary) {
  const Json none = Json::object(), scenarios = summary.value("scenarios", Json::array());
  Json peak;
  double worst = -std::numeric_limits<double>::infinity();
  const Json limits = summary.value("constraints", none);
  for (const auto& [name, limit] : limits.items()) {
    const Json violation = limit.value("violation", Json());
    if (!is_shown(name, scenarios) || !violation.is_number() || violation <= worst) continue;
    worst = violation;
    peak = limit;
  }
  const Json at = peak.is_object() ? peak.value("at_time", Json()) : Json();
  if (!at.is_number() || at <= 0) return std::nullopt;
  return at.get<double>();
}

Json motion(const Hdf5Input& file, std::optional<double> opening, double bytes, Blob& blob) {
  output::prepare_hdf5();  // another thread may have opened it
  if (file.attribute("/", "program") != "liesl")
    throw output::IoError("report", file.path(), "it is not of liesl");
  const auto records = file.shape("/time");
  const auto bodies = file.children("/bodies");
  if (records.empty() || records[0] == 0 || bodies.empty()) return nullptr;
  for (const std::string& name : bodies)
    if (!file.has("/bodies/" + name + "/reference_position"))
      throw output::IoError("report", file.path(),
                            "an earlier version wrote it, without shapes at rest; run it again");
  const int n = static_cast<int>(records[0]);
  const int shown =
      std::clamp(static_cast<int>(std::clamp(bytes, kLeastMotionBytes, kMostMotionBytes) /
                                  bytes_an_instant(file)),
                 kFewestInstants, kMostInstants);
  std::vector<int> instants = output::spread_records(n, opening && n > shown ? shown - 1 : shown);
  Json opens;
  if (opening) {
    const int record = record_near(file.numbers("/time").values, *opening);
    auto place = std::lower_bound(instants.begin(), instants.end(), record);
    if (place == instants.end() || *place != record) place = instants.insert(place, record);
    opens = place - instants.begin();
  }
  const std::string abscissa = file.attribute("/", "abscissa");
  Json json = {{"abscissa", abscissa},
               {"unit", file.attribute("/time", "unit")},
               {"space", file.attribute("/", "space")},
               {"records", n},
               {"opens", opens}};
  json["t"] = blob.f32(file.numbers("/time", instants).values);
  json["bodies"] = json["meshes"] = json["joints"] = Json::array();
  for (const std::string& name : bodies)
    json["bodies"].push_back(body(Group(file, "/bodies/" + name, instants), name, blob));
  for (const std::string& name : file.children("/meshes"))
    if (Json part = solid(Group(file, "/meshes/" + name, instants), name, blob); !part.is_null())
      json["meshes"].push_back(std::move(part));
  for (const std::string& name : file.children("/joints"))
    json["joints"].push_back(joint(Group(file, "/joints/" + name, instants), name));
  return json;
}

}  // namespace liesl::report
