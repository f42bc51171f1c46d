#include "apps/mesh/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

#include "apps/input/problem.hpp"
#include "apps/mesh/mesh_builder.hpp"

namespace liesl {
namespace {

/// What Gmsh calls element types that are no cells of liesl.
struct ElementType {
  int number, nodes;
  std::string_view name;
};
constexpr ElementType kOtherTypes[] = {{6, 6, "6-node prism"},
                                       {7, 5, "5-node pyramid"},
                                       {10, 9, "9-node quadrilateral"},
                                       {12, 27, "27-node hexahedron"},
                                       {13, 18, "18-node prism"},
                                       {14, 14, "14-node pyramid"},
                                       {15, 1, "point"},
                                       {18, 15, "15-node prism"},
                                       {19, 13, "13-node pyramid"}};
constexpr int kPoint = 15;

const CellKind* kind_of(int number) {
  for (const CellKind& kind : cell_kinds())
    if (kind.gmsh == number) return &kind;
  return nullptr;
}

std::optional<ElementType> type_of(int number) {
  if (const CellKind* kind = kind_of(number)) return ElementType{number, kind->nodes, kind->name};
  for (const ElementType& t : kOtherTypes)
    if (t.number == number) return t;
  return {};
}

/// The words of a file, with their places. Reading on after the end, or a number that is none,
/// ends the reading: what follows would be guessed.
class Words {
 public:
  Words(std::string_view text, Problems& problems) : text_(text), problems_(problems) {}

  int line() const { return line_; }
  bool at_end() {
    skip_blanks();
    return next_ == text_.size();
  }
  std::string_view word() {
    skip_blanks();
    if (next_ == text_.size()) fail("the file ends early", "more numbers");
    word_column_ = column();
    const std::size_t begin = next_;
    if (text_[next_] == '"') {
      const std::size_t end = text_.find('"', next_ + 1);
      next_ = end == std::string_view::npos ? text_.size() : end + 1;
    } else {
      while (next_ < text_.size() && !blank(text_[next_])) ++next_;
    }
    return text_.substr(begin, next_ - begin);
  }
  template <class Number>
  Number number() {
    const std::string_view w = word();
    Number x{};
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), x);
    if (error != std::errc() || end != w.data() + w.size())
      fail(fmt::format("'{}' is not a number", w), "a number");
    return x;
  }
  int integer() { return number<int>(); }
  double real() { return number<double>(); }
  void skip(int count) {
    for (int i = 0; i < count; ++i) word();
  }
  /// A count, which the rest of the file must be able to hold.
  int count() {
    const int n = integer();
    if (n < 0 || static_cast<std::size_t>(n) > text_.size())
      fail(fmt::format("{} cannot be a count here", n), "a count that fits the file");
    return n;
  }
  [[noreturn]] void fail(std::string what, std::string expected, std::string hint = "") {
    problems_.add({problems_.file(), line_, word_column_, std::move(what), std::move(expected),
                   std::move(hint)});
    problems_.throw_if_any();
    std::abort();  // not reached: there is one
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  int column() const { return static_cast<int>(next_ - line_start_) + 1; }
  void skip_blanks() {
    for (; next_ < text_.size() && blank(text_[next_]); ++next_)
      if (text_[next_] == '\n') ++line_, line_start_ = next_ + 1;
  }

  std::string_view text_;
  Problems& problems_;
  std::size_t next_ = 0, line_start_ = 0;
  int line_ = 1, word_column_ = 1;
};

struct Element {
  const CellKind* kind;  ///< nothing: a point
  int entity_dim, entity, line;
  std::vector<std::size_t> nodes;
};

class Reader {
 public:
  Reader(std::string_view text, Problems& problems)
      : words_(text, problems),
        problems_(problems),
        mesh_(problems, {"Coherence Mesh of Gmsh unites nodes",
                         "a surface in two physical groups may be saved twice",
                         "reverse the surface's orientation",
                         "move it there, straighten edges with Mesh.SecondOrderLinear = 1, make "
                         "cells smaller where the outline is curved, or mesh without nodes at "
                         "edges, Mesh.ElementOrder = 1",
                         "physical groups must include the surface or volume",
                         "set Mesh.RecombineAll to 1 or 0, so that all cells are alike"}) {}

  SolidMesh read() {
    read_sections();
    int dim = 2;
    for (const Element& e : elements_) dim = std::max(dim, e.kind ? e.kind->dim : 0);
    name_sets(dim);
    for (const Element& e : elements_)
      if (e.kind && e.kind->dim > 1) add_cell(e);
    return mesh_.build();
  }

 private:
  void read_sections() {
    bool format = false;
    while (!words_.at_end()) {
      const std::string section(words_.word());
      if (!format && section != "$MeshFormat")
        words_.fail("this is not a Gmsh file", "$MeshFormat at its start");
      format = true;
      if (section == "$MeshFormat") read_format();
      if (section == "$PhysicalNames") read_names();
      if (section == "$Entities") read_entities();
      if (section == "$Nodes") read_nodes();
      if (section == "$Elements") read_elements();
      const std::string end = "$End" + section.substr(1);
      const bool known = section == "$MeshFormat" || section == "$PhysicalNames" ||
                         section == "$Entities" || section == "$Nodes" || section == "$Elements";
      std::string_view w = words_.word();
      while (!known && w != end) w = words_.word();
      if (w != end) words_.fail(fmt::format("'{}' in section {}", w, section), end);
    }
    if (!format) words_.fail("the file is empty", "$MeshFormat");
    if (elements_.empty()) words_.fail("the file has no elements", "a section $Elements");
  }

  void read_format() {
    const double version = words_.real();
    if (version != 4.1)
      words_.fail(fmt::format("format {} of Gmsh", version), "format 4.1",
                  "gmsh file.geo -format msh41");
    if (words_.integer() != 0)
      words_.fail("the file is binary", "ASCII", "gmsh -format msh41, without -bin");
    words_.skip(1);
  }

  void read_names() {
    for (int n = words_.count(); n > 0; --n) {
      const int dim = words_.integer(), tag = words_.integer();
      std::string name(words_.word());
      name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
      names_[{dim, tag}] = name;
    }
  }

  void read_entities() {
    int counts[4];
    for (int& c : counts) c = words_.count();
    for (int dim = 0; dim < 4; ++dim) {
      for (int n = counts[dim]; n > 0; --n) {
        const int tag = words_.integer();
        words_.skip(dim == 0 ? 3 : 6);
        for (int g = words_.count(); g > 0; --g)
          groups_[{dim, tag}].push_back(std::abs(words_.integer()));
        if (dim > 0) words_.skip(words_.count());
      }
    }
  }

  void read_nodes() {
    const int blocks = words_.count();
    words_.skip(3);
    for (int b = 0; b < blocks; ++b) {
      words_.skip(2);
      if (words_.integer() != 0)
        words_.fail("nodes with parametric coordinates", "0",
                    "gmsh -setnumber Mesh.SaveParametric 0");
      const int n = words_.count();
      std::vector<std::size_t> tags;
      for (int i = 0; i < n; ++i) tags.push_back(words_.number<std::size_t>());
      for (std::size_t tag : tags) {
        Eigen::Vector3d x;
        for (double& xi : x) xi = words_.real();
        mesh_.add_node(tag, x, words_.line());
      }
    }
    problems_.throw_if_any();
  }

  void read_elements() {
    const int blocks = words_.count();
    words_.skip(3);
    for (int b = 0; b < blocks; ++b) {
      const int dim = words_.integer(), entity = words_.integer(), number = words_.integer();
      const auto type = type_of(number);
      if (!type)
        words_.fail(fmt::format("elements of type {}", number),
                    "lines, triangles, quadrilaterals, tetrahedra or hexahedra");
      const CellKind* kind = kind_of(number);
      const bool usable = kind || number == kPoint;
      const int n = words_.count();
      if (!usable && n > 0)
        mesh_.problem(words_.line(), fmt::format("{} {}s", n, type->name),
                      "triangles, quadrilaterals, tetrahedra or hexahedra of order 1 or 2",
                      "set Mesh.SecondOrderIncomplete = 1; prisms and pyramids come with layers");
      for (int i = 0; i < n; ++i) {
        words_.skip(1);
        Element e{kind, dim, entity, words_.line(), {}};
        for (int k = 0; k < type->nodes; ++k) e.nodes.push_back(words_.number<std::size_t>());
        if (usable) elements_.push_back(std::move(e));
      }
    }
  }

  void add_cell(const Element& e) {
    std::vector<std::size_t> nodes;
    for (const int at : gmsh_order(*e.kind)) nodes.push_back(e.nodes[std::size_t(at)]);
    mesh_.add_cell(*e.kind, std::move(nodes), e.line);
  }

  void name_sets(int dim) {
    for (const Element& e : elements_) {
      const auto groups = groups_.find({e.entity_dim, e.entity});
      if (e.entity_dim >= dim || groups == groups_.end()) continue;
      for (int group : groups->second) {
        const auto name = names_.find({e.entity_dim, group});
        if (name == names_.end()) continue;
        for (std::size_t tag : e.nodes) mesh_.add_to_set(name->second, tag);
      }
    }
  }

  Words words_;
  Problems& problems_;
  std::map<std::pair<int, int>, std::string> names_;        // (dim, physical tag)
  std::map<std::pair<int, int>, std::vector<int>> groups_;  // (dim, entity) -> physical tags
  MeshBuilder mesh_;
  std::vector<Element> elements_;
};

}  // namespace

SolidMesh read_gmsh(const std::string& file, std::string_view text) {
  Problems problems(file);
  return Reader(text, problems).read();
}

}  // namespace liesl
