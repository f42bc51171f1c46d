#include "apps/mesh/abaqus_mesh.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <set>

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

/// The kind of cell of an element type: plane stress and plane strain alike; R, I and M at its end
/// name another integration of the same nodes.
const CellKind* kind_of(std::string type) {
  if (type.starts_with("CPE")) type[2] = 'S';
  for (const CellKind& kind : cell_kinds())
    for (const char* end : {"", "R", "I", "M"})
      if (!kind.abaqus.empty() && type == std::string(kind.abaqus) + end) return &kind;
  return nullptr;
}

bool is_solid(const std::string& type) {
  return type.starts_with("C3D") || type.starts_with("CPS") || type.starts_with("CPE");
}

/// "CPS3, ..., C3D20"
std::string known_types() {
  std::string out;
  for (const CellKind& kind : cell_kinds())
    if (!kind.abaqus.empty()) out += (out.empty() ? "" : ", ") + std::string(kind.abaqus);
  return out + ", also with R, I or M at their end";
}

/// Keywords that make nodes and elements, or move them, without listing them.
constexpr std::string_view kNotListed[] = {"*INCLUDE", "*INSTANCE", "*NGEN",   "*NFILL", "*NCOPY",
                                           "*NMAP",    "*ELGEN",    "*ELCOPY", "*SYSTEM"};

constexpr std::size_t kLongLine = 10;  // fields: longer lists are broken without a comma, too

/// What elements with so many nodes may be.
std::string types_of(std::size_t nodes) {
  std::vector<std::string> types;
  for (const CellKind& kind : cell_kinds())
    if (static_cast<std::size_t>(kind.nodes) == nodes && !kind.abaqus.empty())
      types.emplace_back(kind.abaqus);
  return types.empty() ? "" : fmt::format("of {} nodes are {}", nodes, fmt::join(types, ", "));
}

class AbaqusReader {
 public:
  AbaqusReader(std::string_view text, Problems& problems)
      : text_(text),
        mesh_(problems,
              {"", "an element may be in two *ELEMENT blocks", "reverse the order of its nodes",
               "move it there, straighten the edges, make elements smaller where the "
               "outline is curved, or mesh without nodes at edges",
               "*ELEMENT, TYPE=C3D10 or another",
               "let the preprocessor mesh with one element type"}) {}

  SolidMesh read() {
    for (std::size_t at = 0; at < text_.size(); ++line_) {
      const auto end = std::min(text_.find('\n', at), text_.size());
      const std::string line = trimmed(text_.substr(at, end - at));
      at = end + 1;
      if (line.empty() || line.starts_with("**")) continue;
      line.starts_with("*") ? begin(keyword_of(line)) : data(fields_of(line), line.ends_with(','));
    }
    finish_cell();
    SolidMesh mesh = mesh_.build();
    for (const auto& [key, name] : spelling_) mesh.sets.try_emplace(name);  // without nodes, too
    return mesh;
  }

 private:
  void begin(const Keyword& keyword) {
    finish_cell();
    keyword_ = keyword;
    kind_ = nullptr;
    refuse_what_is_not_listed(keyword);
    const bool set = keyword.name == "*NSET" || keyword.name == "*NODE";
    if (keyword.name == "*NSET" && keyword.of("NSET").empty())
      mesh_.problem(line_, "*NSET without a name", "*NSET, NSET=NAME");
    else if (set && !keyword.of("NSET").empty())
      spelling_.try_emplace(upper(keyword.of("NSET")), keyword.of("NSET"));
    if (keyword.has("ELSET")) of_elements_.insert(upper(keyword.of("ELSET")));
    if (keyword.name != "*ELEMENT") return;
    const std::string type = upper(keyword.of("TYPE"));
    kind_ = kind_of(type);
    if (!kind_ && is_solid(type))
      mesh_.problem(line_, fmt::format("elements of type '{}'", type), known_types(),
                    "let the preprocessor mesh with one of these");
  }

  void refuse_what_is_not_listed(const Keyword& keyword) {
    const auto refuse = [&](const std::string& what) {
      mesh_.problem(line_, what + " is not read", "a flat file that lists its nodes and elements",
                    "let the preprocessor write it without parts, instances and generation");
    };
    const std::string& name = keyword.name;
    if (std::find(std::begin(kNotListed), std::end(kNotListed), name) != std::end(kNotListed))
      return refuse(name);
    if (name == "*NODE" || name == "*ELEMENT" || name == "*NSET")
      for (const char* key : {"INPUT", "SYSTEM", "ELSET"})
        if (keyword.has(key) && !(name == "*ELEMENT" && std::string_view(key) == "ELSET") &&
            !(std::string_view(key) == "SYSTEM" && upper(keyword.of(key)) == "R"))
          refuse(fmt::format("{} of {}", key, name));
  }

  /// @param goes_on the line ends with a comma
  void data(const std::vector<std::string>& fields, bool goes_on) {
    if (keyword_.name == "*NODE") add_node(fields);
    if (keyword_.name == "*NSET") add_to_set(fields);
    if (kind_) {
      if (cell_.empty()) cell_line_ = line_;
      for (const std::string& field : fields)
        if (const auto tag = tag_of(field)) cell_.push_back(*tag);
      const bool broken = goes_on || fields.size() >= kLongLine;
      if (!broken || static_cast<int>(cell_.size()) > kind_->nodes) finish_cell();
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
    least_ = std::min(least_, *tag);
    most_ = std::max(most_, *tag);
    if (keyword_.has("NSET")) put(keyword_.of("NSET"), *tag);
  }

  /// Numbers of nodes, and names of sets above.
  void add_to_set(const std::vector<std::string>& fields) {
    const std::string name = keyword_.of("NSET");
    if (name.empty()) return;  // as its keyword says
    if (keyword_.has("GENERATE")) return generate(name, fields);
    for (const std::string& field : fields) {
      const bool name_like = field.find_first_of("+-.0123456789") != 0 && !field.empty();
      if (const auto tag = whole_number(field))
        put(name, *tag);
      else if (name_like || spelling_.contains(upper(field)))
        add_set(name, field);
      else
        refuse_in(name, fmt::format("'{}' of set '{}' is no number of a node", field, name),
                  "a whole number, or the name of a set that stands above this line");
    }
  }

  /// Nodes of another set.
  void add_set(const std::string& name, const std::string& other) {
    const auto set = sets_.find(upper(other));
    if (set != sets_.end()) {
      for (const std::size_t tag : std::vector<std::size_t>(set->second)) put(name, tag);
      return;
    }
    if (refused_.contains(upper(other))) return;  // as its own lines say
    std::vector<std::string> known;
    for (const auto& [key, nodes] : sets_) known.push_back(spelling_.at(key));
    const bool empty = spelling_.contains(upper(other)),
               elements = of_elements_.contains(upper(other));
    refuse_in(name,
              empty ? fmt::format("set '{}', a part of set '{}', has no nodes yet", other, name)
                    : fmt::format("there is no node set '{}', a part of set '{}'", other, name),
              "a set that stands above this line",
              elements ? fmt::format("'{}' is a set of elements", other)
                       : suggestion(other, known, "there is none above"));
  }

  /// "first, last, step"
  void generate(const std::string& name, const std::vector<std::string>& fields) {
    constexpr const char* kExpected =
        "first, last, step: whole numbers, last from first on, step above 0";
    std::vector<std::size_t> numbers;
    for (const std::string& field : fields)
      if (const auto number = whole_number(field)) numbers.push_back(*number);
    const std::string line =
        fmt::format("GENERATE of set '{}' by '{}'", name, fmt::join(fields, ", "));
    if (numbers.size() != fields.size() || numbers.size() > 3)
      return refuse_in(name, line + " is not read", kExpected);
    const std::size_t first = numbers[0], last = numbers.size() > 1 ? numbers[1] : first,
                      step = numbers.size() > 2 ? numbers[2] : 1;
    if (step == 0 || last < first || (last - first) / step > kMostGenerated)
      return refuse_in(name, line + " generates nothing, or too much", kExpected);
    bool found = false;
    for (std::size_t tag = first; tag <= last; tag += step) {
      if (!mesh_.has_node(tag)) continue;
      put(name, tag);
      found = true;
    }
    if (!found)
      refuse_in(name, line + " meets no node", "nodes of *NODE above this line", nodes_above());
  }

  /// Names of sets are the same in any case; the mesh has them as they were first written.
  void put(const std::string& name, std::size_t tag) {
    if (!mesh_.has_node(tag))
      return refuse_in(name, fmt::format("node {} of set '{}' does not exist", tag, name),
                       "a node of *NODE above this line", nodes_above());
    sets_[upper(name)].push_back(tag);
    mesh_.add_to_set(spelling_.try_emplace(upper(name), name).first->second, tag);
  }

  void refuse_in(const std::string& set, std::string what, std::string expected,
                 std::string hint = "") {
    refused_.insert(upper(set));
    mesh_.problem(line_, std::move(what), std::move(expected), std::move(hint));
  }

  std::string nodes_above() const {
    return most_ < least_ ? "there is none above"
                          : fmt::format("those above are {} to {}", least_, most_);
  }

  /// The first element of another number of nodes stands for its block: the rest is not read.
  void finish_cell() {
    if (cell_.empty()) return;
    std::vector<std::size_t> nodes(cell_.begin() + 1, cell_.end());
    cell_.clear();
    if (static_cast<int>(nodes.size()) == kind_->nodes)
      return mesh_.add_cell(*kind_, std::move(nodes), cell_line_);
    mesh_.problem(cell_line_, fmt::format("an element has {} nodes", nodes.size()),
                  fmt::format("{}, as its TYPE={} says", kind_->nodes, keyword_.of("TYPE")),
                  types_of(nodes.size()));
    kind_ = nullptr;
  }

  static std::optional<std::size_t> whole_number(const std::string& field) {
    std::size_t number = 0;
    const char* end = field.data() + field.size();
    const auto [to, error] = std::from_chars(field.data(), end, number);
    return error == std::errc() && to == end ? std::optional(number) : std::nullopt;
  }

  std::optional<std::size_t> tag_of(const std::string& field) {
    if (const auto tag = whole_number(field)) return tag;
    mesh_.problem(line_, fmt::format("'{}' is no number of a node", field), "a whole number");
    return {};
  }

  std::string_view text_;
  MeshBuilder mesh_;
  int line_ = 1, cell_line_ = 0;
  Keyword keyword_;
  const CellKind* kind_ = nullptr;  ///< of the cells that are read
  std::vector<std::size_t> cell_;   ///< number and nodes so far
  std::map<std::string, std::vector<std::size_t>> sets_;
  std::map<std::string, std::string> spelling_;  ///< of the sets of nodes
  std::set<std::string> of_elements_, refused_;  ///< sets of elements; sets with a problem
  std::size_t least_ = std::numeric_limits<std::size_t>::max(), most_ = 0;  ///< numbers of nodes
};

}  // namespace

SolidMesh read_abaqus(const std::string& file, std::string_view text) {
  Problems problems(file);
  return AbaqusReader(text, problems).read();
}

}  // namespace liesl
