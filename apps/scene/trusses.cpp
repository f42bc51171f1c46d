#include "apps/scene/trusses.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <set>

#include "apps/input/values.hpp"

namespace liesl {
namespace {

constexpr double kTiny = 1e-12;  // m; shorter is no length

struct Bar {
  std::string name, from, to;
  Vec3 axis;  ///< unit
};

toml::array array_of(const Vec3& v) { return toml::array{v[0], v[1], v[2]}; }

/// Expands one truss.
class Truss {
 public:
  Truss(const std::string& name, toml::table& root, toml::table& table, Problems& problems)
      : name_(name), root_(root), table_(table), problems_(problems) {}

  /// Writes its bars and joints; nothing (and reported) if something is wrong.
  bool expand(toml::table& bodies, toml::table& joints, TrussNames& names) {
    read_nodes();
    read_bars(names);
    read_held();
    check_properties();
    if (!ok_) return false;
    for (const Bar& bar : bars_) write(bar, bodies);
    join(joints);
    for (const auto& [node, port] : port_) names.nodes[name_ + "." + node] = port;
    return true;
  }

 private:
  void refuse(const toml::node& at, const std::string& what, const std::string& expected,
              const std::string& hint = "") {
    problems_.add(at, fmt::format("truss '{}' {}", name_, what), expected, hint);
    ok_ = false;
  }

  void read_nodes() {
    for (auto&& [key, value] : *table_["nodes"].as_table())
      place_[std::string(key.str())] = vec3(value);
  }

  bool is_node(const toml::node& node) {
    const std::string name = node.value_or(std::string());
    if (place_.contains(name)) return true;
    std::vector<std::string> known;
    for (const auto& [other, at] : place_) known.push_back(other);
    refuse(node, fmt::format("has no node '{}'", name), "a node of the truss",
           suggestion(name, known));
    return false;
  }

  void read_bars(TrussNames& names) {
    std::set<std::pair<std::string, std::string>> known;
    for (Entry& group : groups()) {
      const std::string whole = name_ + "." + group.name;
      if (place_.contains(group.name))
        refuse(*(*table_["bars"].as_table()).get(group.name),
               fmt::format("has a node and a group of bars '{}'", group.name), "different names");
      for (const toml::node& pair : *(*table_["bars"].as_table())[group.name].as_array()) {
        const toml::array* ends = pair.as_array();
        if (!ends || ends->size() != 2) {
          refuse(pair, "has a bar that is no pair of nodes", "[\"n1\", \"n2\"]");
          continue;
        }
        if (!is_node((*ends)[0]) || !is_node((*ends)[1])) continue;
        Bar bar{"", (*ends)[0].value_or(std::string()), (*ends)[1].value_or(std::string()), {}};
        const Vec3 along = place_[bar.to] - place_[bar.from];
        if (along.norm() < kTiny) {
          refuse(pair, "has a bar of zero length", "two nodes at different places");
          continue;
        }
        if (!known.insert(std::minmax(bar.from, bar.to)).second)
          refuse(pair, fmt::format("has two bars from '{}' to '{}'", bar.from, bar.to),
                 "each bar once");
        bar.axis = along.normalized();
        bar.name = fmt::format("{}_{}{}", name_, group.name, names.bars[whole].size() + 1);
        section_[bar.name] = group.name;
        names.bars[whole].push_back(bar.name);
        names.bars[name_].push_back(bar.name);
        bars_.push_back(std::move(bar));
      }
    }
    if (ok_ && bars_.empty()) refuse(table_, "has no bars", "a group of them in 'bars'");
    for (const auto& [node, at] : place_)
      if (ok_ && std::none_of(bars_.begin(), bars_.end(), [&node = node](const Bar& b) {
            return b.from == node || b.to == node;
          }))
        refuse(*(*table_["nodes"].as_table()).get(node),
               fmt::format("has a node '{}' without a bar", node), "a bar to every node");
  }

  std::vector<Entry> groups() {
    std::vector<Entry> list;
    for (auto&& [key, value] : *table_["bars"].as_table()) {
      if (value.is_array() && !value.as_array()->empty())
        list.push_back({std::string(key.str()), &key, nullptr});
      else
        refuse(value, fmt::format("has no bars in the group '{}'", std::string(key.str())),
               "a list of pairs of nodes", "[[\"n1\", \"n2\"], [\"n2\", \"n3\"]]");
    }
    return list;
  }

  void read_held() {
    if (const toml::table* own = table_["sections"].as_table())
      for (auto&& [key, value] : *own)
        if (!table_["bars"].as_table()->contains(key))
          refuse(value, fmt::format("has no group of bars '{}'", std::string(key.str())),
                 "a group of 'bars'");
    if (!table_.contains("held")) return;
    for (const toml::node* node : strings(table_, "held"))
      if (is_node(*node)) held_.insert(node->value_or(std::string()));
  }

  /// Section and material of its bars are entries of the scene.
  void check_properties() {
    entry_of("materials", "material", *table_.get("material"));
    entry_of("sections", "section", *table_.get("section"));
    if (const toml::table* own = table_["sections"].as_table())
      for (auto&& [key, value] : *own) entry_of("sections", "section", value);
  }

  void entry_of(const char* group, const char* kind, const toml::node& node) {
    const std::string name = node.value_or(std::string());
    if (const toml::table* all = root_[group].as_table(); all && all->contains(name)) return;
    std::vector<std::string> known;
    for (const Entry& entry : entries_at(root_, group)) known.push_back(entry.name);
    refuse(node, fmt::format("is of {} '{}', which the scene has not", kind, name),
           fmt::format("a {}", kind), suggestion(name, known));
  }

  void write(const Bar& bar, toml::table& bodies) {
    toml::table beam;
    beam.insert("from", array_of(place_[bar.from]));
    beam.insert("to", array_of(place_[bar.to]));
    const toml::table* own = table_["sections"].as_table();
    const std::string group = section_[bar.name];
    beam.insert("section",
                own && own->contains(group) ? text(*own, group) : text(table_, "section"));
    beam.insert("material", text(table_, "material"));
    beam.insert("elements", 1);
    beam.insert("order", 2);
    if (number(table_, "damping") > 0) beam.insert("damping", number(table_, "damping"));
    if (bodies.contains(bar.name))
      return refuse(table_, fmt::format("has a bar '{}', as a body is called", bar.name),
                    "another name of the body");
    bodies.insert(bar.name, toml::table{{"beam", std::move(beam)}});
  }

  /// A joint of bar b at one of its ends, with a bar before it or with the ground (a = -1).
  struct Joint {
    int a, b;
    std::string port_a, port_b;
    bool tree = false;
  };

  void join(toml::table& out) {
    std::map<std::string, int> owner;
    std::vector<Joint> joints;
    for (std::size_t k = 0; k < bars_.size(); ++k)
      for (const bool last : {false, true}) {
        const std::string& node = last ? bars_[k].to : bars_[k].from;
        const std::string port = bars_[k].name + (last ? ".end" : ".start");
        const int b = static_cast<int>(k);
        const auto [first, fresh] = owner.try_emplace(node, b);
        if (fresh) port_[node] = port;
        if (held_.contains(node))
          joints.push_back({-1, b, "ground", port});
        else if (!fresh)
          joints.push_back({first->second, b, port_[node], port});
      }
    grow_tree(joints);
    int number = 0;
    for (const Joint& j : joints) {
      const std::string name = fmt::format("{}_j{}", name_, ++number);
      if (!out.insert(name, joint_table(j)).second)
        refuse(table_, fmt::format("has a hinge '{}', as a joint is called", name),
               "another name of the joint");
    }
  }

  /// The joints that keep bars from spinning: a tree from the ground, or from the first bar.
  void grow_tree(std::vector<Joint>& joints) const {
    std::set<int> reached;
    std::deque<int> next;
    const auto visit = [&](int bar) {
      if (reached.insert(bar).second) next.push_back(bar);
    };
    visit(held_.empty() ? 0 : -1);
    while (!next.empty()) {
      const int from = next.front();
      next.pop_front();
      for (Joint& j : joints) {
        if (j.a != from && j.b != from) continue;
        const int to = j.a == from ? j.b : j.a;
        if (to < 0 || reached.contains(to)) continue;
        j.tree = true;
        if (j.a == to) {
          std::swap(j.a, j.b);
          std::swap(j.port_a, j.port_b);
        }
        visit(to);
      }
    }
  }

  toml::table joint_table(const Joint& j) const {
    const toml::array ports{j.port_a, j.port_b};
    if (!j.tree) return toml::table{{"spherical", ports}};
    const Vec3 e = bars_[static_cast<std::size_t>(j.b)].axis;
    const Vec3 across = e.unitOrthogonal();
    return toml::table{
        {"universal", ports}, {"axis", array_of(e.cross(across))}, {"axis2", array_of(across)}};
  }

  const std::string& name_;
  toml::table &root_, &table_;
  Problems& problems_;
  std::map<std::string, Vec3> place_;
  std::map<std::string, std::string> section_, port_;  ///< group of a bar; port of a node
  std::vector<Bar> bars_;
  std::set<std::string> held_;
  bool ok_ = true;
};

}  // namespace

TrussNames expand_trusses(toml::table& root, const Broken& broken, Problems& problems) {
  TrussNames names;
  toml::table* bodies = root["bodies"].as_table();
  if (!bodies) return names;
  std::vector<std::string> trusses;
  for (auto&& [key, value] : *bodies)
    if (const std::string name(key.str()); value.is_table() &&
                                           value.as_table()->contains("truss") &&
                                           !broken.contains("bodies." + name))
      trusses.push_back(name);
  for (const std::string& name : trusses) {
    toml::table& body = *(*bodies)[name].as_table();
    for (const char* key : {"velocity", "angular_velocity"})
      if (const toml::node* node = body.get(key); node && written(*node))
        problems.add(*node, fmt::format("truss '{}' starts at rest", name),
                     "no '" + std::string(key) + "'");
    toml::table& table = *body.get("truss")->as_table();
    if (!root.contains("joints")) root.insert("joints", toml::table());
    toml::table expanded;
    if (!Truss(name, root, table, problems).expand(expanded, *root["joints"].as_table(), names))
      continue;
    bodies->erase(name);
    for (auto&& [key, value] : expanded)
      if (!bodies->insert(key.str(), value).second)
        problems.add(
            *bodies->get(key.str()),
            fmt::format("truss '{}' has a bar of the name '{}'", name, std::string(key.str())),
            "another name");
  }
  return names;
}

}  // namespace liesl
