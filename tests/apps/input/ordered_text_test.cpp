/// @file
/// Tables written as text: the same table when it is read, with its keys in the order they had.
#include "apps/input/ordered_text.hpp"

#include <gtest/gtest.h>

#include "apps/input/document.hpp"
#include "apps/input/values.hpp"

namespace liesl::test::ordered_text_test {
namespace {

std::vector<std::string> names(toml::table& table) {
  std::vector<std::string> list;
  for (const Entry& entry : entries_of(table)) list.push_back(entry.name);
  return list;
}

TEST(OrderedText, IsReadAsTheSameTableInTheSameOrder) {
  Document given = parse_document(R"(
name = "it's a \"name\""
gravity = [0, -9.81, 0]
[bodies.zeta.solid.interfaces]   # a head before the inline tables below
shoulder = { circle = { centre = [0, 0], radius = 0.1 } }
elbow = { circle = { centre = [1.0, 0], radius = 1e-3 } }
[bodies]
beta = { rigid = { at = [0, 0, 0], mass = 1 } }
alpha.rigid = { at = [0, 0, 0], mass = 2.0, "odd key" = true }
[joints]
)",
                                  "a");
  Document again = parse_document(ordered_text(given.root), "b");
  EXPECT_EQ(again.root, given.root) << ordered_text(given.root);
  EXPECT_EQ(names(again.root), names(given.root));
  for (Document* document : {&given, &again}) {
    toml::table& bodies = *document->root["bodies"].as_table();
    EXPECT_EQ(names(bodies), (std::vector<std::string>{"zeta", "beta", "alpha"}));
    EXPECT_EQ(names(*bodies["zeta"]["solid"]["interfaces"].as_table()),
              (std::vector<std::string>{"shoulder", "elbow"}));
  }
}

TEST(OrderedText, NumbersAreTheShortestAndNewKeysComeLast) {
  Document document = parse_document("b = 9.81\na = 1.0\n", "a");
  document.root.insert("aa", 2.7e-300);
  EXPECT_EQ(ordered_text(document.root), "b = 9.81\na = 1.0\naa = 2.7e-300\n");
}

}  // namespace
}  // namespace liesl::test::ordered_text_test
