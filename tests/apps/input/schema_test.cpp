/// @file
/// The table of keys: complete, well formed, and printed in docs/scene_reference.md.
#include "apps/input/schema.hpp"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "apps/input/problem.hpp"
#include "reference/places.hpp"

namespace liesl::test::schema_test {
namespace {

std::vector<Key> all_keys() {
  auto keys = schema(FileKind::Scene);
  for (const FileKind kind : kFileKinds)
    if (kind != FileKind::Scene) keys.insert(keys.end(), schema(kind).begin(), schema(kind).end());
  return keys;
}

/// With LIESL_WRITE_REFERENCE set, the page is written first.
TEST(Schema, PageIsCurrent) {
  const std::string path = std::string(test::kDataDir) + "/../docs/scene_reference.md";
  if (std::getenv("LIESL_WRITE_REFERENCE")) std::ofstream(path) << schema_markdown();
  std::ifstream file(path);
  std::ostringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), schema_markdown()) << "write it again: LIESL_WRITE_REFERENCE=1 test_apps";
}

TEST(Schema, EveryKeyIsExplained) {
  for (const Key& key : all_keys()) {
    EXPECT_FALSE(key.doc.empty()) << key.path;
    EXPECT_EQ(key.type == Type::Choice, !key.options.empty()) << key.path;
    const bool sized =
        key.type == Type::Vector || key.type == Type::Rows || key.type == Type::Matrix;
    if (sized) {
      EXPECT_GT(key.size, 1) << key.path;
    }
    const bool physical = key.type == Type::Number || key.type == Type::Vector ||
                          key.type == Type::Point || key.type == Type::Matrix ||
                          key.type == Type::Rows;
    if (physical) {
      EXPECT_FALSE(key.unit.empty()) << key.path;
    }
  }
}

TEST(Schema, EveryParentIsATable) {
  for (const FileKind kind : kFileKinds)
    for (const Key& key : schema(kind)) {
      if (key.parent().empty() || key.parent() == "(function)") continue;
      const Key* parent = find_key(kind, key.parent());
      ASSERT_NE(parent, nullptr) << key.path;
      const bool table = parent->type == Type::Table || parent->type == Type::TableOrList ||
                         parent->type == Type::Named;
      EXPECT_TRUE(table) << key.path;
      EXPECT_EQ(parent->type == Type::Named, key.leaf() == "*") << key.path;
    }
}

TEST(Schema, DefaultsAreInRange) {
  for (const Key& key : all_keys()) {
    if (key.preset == kRequired || key.preset == kOptional || key.preset == kOneOf) continue;
    const toml::table value = toml::parse("v = " + std::string(key.preset));
    if (key.type == Type::Number || key.type == Type::Integer) {
      EXPECT_TRUE(key.range.contains(*value["v"].value<double>())) << key.path;
    }
    if (key.type == Type::Choice) {
      const auto options = words(key.options);
      EXPECT_EQ(std::count(options.begin(), options.end(), *value["v"].value<std::string>()), 1)
          << key.path;
    }
  }
}

TEST(Range, SaysWhatItHolds) {
  EXPECT_EQ(kPositive.text(), "> 0");
  EXPECT_FALSE(kPositive.contains(0));
  EXPECT_EQ((Range{0, 1e-2, true}.text()), "in (0, 0.01]");
  EXPECT_TRUE((Range{0, 1e-2, true}.contains(1e-2)));
  EXPECT_EQ(kAny.text(), "");
}

TEST(Nearest, IsByEditDistance) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("ruond", "round"), 1);  // neighbours swapped
  EXPECT_EQ(edit_distance("Steel", "steel"), 0);
  EXPECT_EQ(nearest("diamter", {"radius", "diameter", "thickness"}), "diameter");
  EXPECT_EQ(nearest("body", {"bodies", "loads"}), "bodies");  // a plural is one slip
  EXPECT_EQ(nearest("materiel", {"materials", "loads"}), "materials");
  EXPECT_EQ(nearest("colour", {"radius", "diameter"}), "");
  EXPECT_EQ(suggestion("colour", {"radius", "diameter"}), "known: radius, diameter");
}

}  // namespace
}  // namespace liesl::test::schema_test
