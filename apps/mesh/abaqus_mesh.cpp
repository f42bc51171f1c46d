#include "apps/mesh/abaqus_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "apps/input/problem.hpp"
#include "apps/mesh/mesh_builder.hpp"

namespace liesl {
namespace {

constexpr std::size_t kMostGenerated = 10'000'000;

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return "";
  return std::string(text.substr(from, text.find_last_not_of(" \t\r") - from + 1));
}

/// Fields of a line between commas; without one behind the last comma.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> out;
  while (true) {
    const auto comma = line.find(',');
    out.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (out.size() > 1 && out.back().empty()) out.pop_back();
  return out;
}

/// "*NSET, NSET=left, GENERATE": keyword and parameters, in capitals but for what a name is.
struct Keyword {
  std::string name;
  std::map<std::string, std::string> parameters;

  bool has(const char* key) const { return parameters.contains(key); }
  std::string of(const char* key) const { return has(key) ? parameters.at(key) : ""; }
};

Keyword keyword_of(std::string_view line) {
  const auto fields = fields_of(line);
  Keyword out{upper(fields[0]), {}};
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto sign = fields[i].find('=');
    const std::string key = upper(trimmed(fields[i].substr(0, sign)));
    out.parameters[key] = sign == std::string::npos ? "" : trimmed(fields[i].substr(sign + 1));
  }
  return out;
}

/// Corners of a kind of cell; 0: a solid that liesl has not; -1: no solid.
int corners_of(const std::string& type) {
  const auto is = [&](std::string_view kind) {
    return type == kind || type == std::string(kind) + "R" || type == std::string(kind) + "I";
  };
  if (is("CPS4") || is("CPE4")) return 4;
  if (is("C3D8")) return 8;
  const bool solid = type.starts_with("C3D") || type.starts_with("CPS") || type.starts_with("CPE");
  return solid ? 0 : -1;
}

class AbaqusReader {
 public:
  AbaqusReader(std::string_view text, Problems& problems)
      : text_(text),
        mesh_(problems, {"", "an element may be in two *ELEMENT blocks",
                         "reverse the order of its nodes", "*ELEMENT, TYPE=CPS4 or C3D8"}) {}

  SolidMesh read() {
    for (std::size_t at = 0; at < text_.size(); ++line_) {
      const auto end = std::min(text_.find('\n', at), text_.size());
      const std::string line = trimmed(text_.substr(at, end - at));
      at = end + 1;
      if (line.empty() || line.starts_with("**")) continue;
      line.starts_with("*") ? begin(keyword_of(line)) : data(fields_of(line));
    }
    finish_cell();
    return mesh_.build();
  }

 private:
  void begin(const Keyword& keyword) {
    finish_cell();
    keyword_ = keyword;
    corners_ = -1;
    if (keyword.name == "*INCLUDE" || keyword.name == "*INSTANCE")
      mesh_.problem(line_, keyword.name + " is not read", "a flat file with nodes and elements",
                    "let the preprocessor write it without parts and instances");
    if (keyword.name == "*NSET" && keyword.of("NSET").empty())
      mesh_.problem(line_, "*NSET without a name", "*NSET, NSET=NAME");
    if (keyword.name != "*ELEMENT") return;
    const std::string type = upper(keyword.of("TYPE"));
    corners_ = corners_of(type);
    if (corners_ == 0)
      mesh_.problem(line_, fmt::format("elements of type '{}'", type),
                    "CPS4, CPE4 or C3D8, also with R or I at their end",
                    "mesh with quadrilaterals or hexahedra of first order");
  }

  void data(const std::vector<std::string>& fields) {
    if (keyword_.name == "*NODE") add_node(fields);
    if (keyword_.name == "*NSET") add_to_set(fields);
    if (keyword_.name == "*ELEMENT" && corners_ > 0) {
      if (cell_.empty()) cell_line_ = line_;
      for (const std::string& field : fields)
        if (const auto tag = tag_of(field)) cell_.push_back(*tag);
      if (static_cast<int>(cell_.size()) > corners_) finish_cell();
    }
  }

  void add_node(const std::vector<std::string>& fields) {
    const auto tag = tag_of(fields[0]);
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < std::min<std::size_t>(fields.size(), 4); ++i) {
      if (fields[i].empty()) continue;
      const char* end = fields[i].data() + fields[i].size();
      const char* from = fields[i].data() + (fields[i][0] == '+');
      if (const auto [to, error] = std::from_chars(from, end, x[static_cast<int>(i) - 1]);
          error != std::errc() || to != end)
        return mesh_.problem(line_, fmt::format("'{}' is not a number", fields[i]), "a number");
    }
    if (!tag) return;
    mesh_.add_node(*tag, x, line_);
    if (keyword_.has("NSET")) put(keyword_.of("NSET"), *tag);
  }

  void add_to_set(const std::vector<std::string>& fields) {
    const std::string name = keyword_.of("NSET");
    if (keyword_.has("GENERATE")) return generate(name, fields);
    for (const std::string& field : fields) {
      const bool number = !field.empty() && std::isdigit(static_cast<unsigned char>(field[0]));
      if (number) {
        if (const auto tag = tag_of(field)) put(name, *tag);
        continue;
      }
      const auto set = sets_.find(upper(field));
      if (set == sets_.end()) {
        mesh_.problem(line_, fmt::format("there is no node set '{}'", field),
                      "a set that stands above this line");
        continue;
      }
      for (const std::size_t tag : std::vector<std::size_t>(set->second)) put(name, tag);
    }
  }

  /// "first, last, step"
  void generate(const std::string& name, const std::vector<std::string>& fields) {
    const auto first = tag_of(fields[0]), last = fields.size() > 1 ? tag_of(fields[1]) : first,
               step = fields.size() > 2 ? tag_of(fields[2]) : std::optional<std::size_t>(1);
    if (!first || !last || !step) return;
    if (*step == 0 || *last < *first || (*last - *first) / *step > kMostGenerated)
      return mesh_.problem(line_, "GENERATE that generates nothing, or too much",
                           "first, last, step above 0");
    for (std::size_t tag = *first; tag <= *last; tag += *step)
      if (mesh_.has_node(tag)) put(name, tag);
  }

  /// Names of sets are the same in any case; the mesh has them as they were first written.
  void put(const std::string& name, std::size_t tag) {
    if (!mesh_.has_node(tag))
      return mesh_.problem(line_, fmt::format("node {} of set '{}' does not exist", tag, name),
                           "a node of *NODE above this line");
    sets_[upper(name)].push_back(tag);
    mesh_.add_to_set(spelling_.try_emplace(upper(name), name).first->second, tag);
  }

  void finish_cell() {
    if (cell_.empty()) return;
    std::vector<std::size_t> corners(cell_.begin() + 1, cell_.end());
    cell_.clear();
    if (static_cast<int>(corners.size()) != corners_)
      return mesh_.problem(cell_line_, fmt::format("an element has {} nodes", corners.size()),
                           fmt::format("{}", corners_));
    mesh_.add_cell(std::move(corners), cell_line_);
  }

  std::optional<std::size_t> tag_of(const std::string& field) {
    std::size_t tag = 0;
    const char* end = field.data() + field.size();
    const auto [to, error] = std::from_chars(field.data(), end, tag);
    if (error == std::errc() && to == end) return tag;
    mesh_.problem(line_, fmt::format("'{}' is no number of a node", field), "a whole number");
    return {};
  }

  std::string_view text_;
  MeshBuilder mesh_;
  int line_ = 1, cell_line_ = 0;
  Keyword keyword_;
  int corners_ = -1;               ///< of the cells that are read; -1: none are
  std::vector<std::size_t> cell_;  ///< number and nodes so far
  std::map<std::string, std::vector<std::size_t>> sets_;
  std::map<std::string, std::string> spelling_;
};

}  // namespace

SolidMesh read_abaqus(const std::string& file, std::string_view text) {
  Problems problems(file);
  return AbaqusReader(text, problems).read();
}

}  // namespace liesl
