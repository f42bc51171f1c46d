#pragma once
/// @file
/// A scene without a fault, for tests that put one in.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"

namespace liesl::test {

inline const std::string kGoodScene = R"toml(name = "good"
gravity = [0, -9.81, 0]

[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }

[sections]
round = { type = "circle", diameter = 0.02, shear_factor = 0.9 }
wall = { type = "tube", diameter = 0.02, thickness = 0.002 }

[bodies]
crank = { beam = { from = [0, 0, 0], to = [0.2, 0, 0], section = "round", material = "steel", elements = 4 } }
rod = { beam = { from = [0.2, 0, 0], to = [0.6, 0, 0], section = "wall", material = "steel", elements = 5 } }
slider = { rigid = { at = [0.6, 0, 0], mass = 0.2, inertia = [1e-4, 1e-4, 1e-4], points = { tip = [0.7, 0, 0] } } }

[joints]
motor = { revolute = ["ground", "crank.start"], axis = [0, 0, 2], drive = { rate = 10, ramp = 0.1 } }
pin = { revolute = ["crank.end", "rod.start"] }
wrist = { revolute = ["rod.end", "slider.origin"] }
guide = { prismatic = ["ground", "slider.origin"], axis = [1, 0, 0] }

[forces]
spring = { on = "guide", stiffness = 10, damping = 0.5, rest = 0.01 }
rope = { between = ["ground", "slider.tip"], stiffness = 2, force = "sin(2*pi*t)" }

[loads]
push = { at = "slider.tip", force = [1, 0, 0], scale = { table = [[0, 0], [1, 4]] } }
wind = { over = "rod", force = [0, 3, 0], follower = true }

[simulation]
duration = 0.5
step = 1e-3

[responses]
x = { response = "position", at = "slider.origin", axis = [1, 0, 0] }
bend = { response = "deflection", of = "crank" }
)toml";

/// The scene with the first occurrence of a text replaced.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("the scene has no '" + from + "'");
  return text.replace(at, from.size(), to);
}

/// A text whose '@' marks where a problem is expected, without it.
struct MarkedText {
  explicit MarkedText(std::string marked) : text(std::move(marked)) {
    const auto mark = text.find('@');
    if (mark == std::string::npos) throw std::invalid_argument("no '@' in the text");
    text.erase(mark, 1);
    line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(mark), '\n');
    const auto start = mark == 0 ? std::string::npos : text.rfind('\n', mark - 1);
    column = static_cast<long>(start == std::string::npos ? mark + 1 : mark - start);
  }

  std::string text;
  long line = 0, column = 0;
};

/// What an InputError of `read()` says; empty: there is none.
template <class Read>
std::string refusal_of(const Read& read) {
  try {
    read();
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// `read(text, file)` refuses the text with one problem at its mark, in these words.
template <class Read>
void expect_refused(const MarkedText& marked, const std::string& file, const Read& read,
                    const std::vector<const char*>& words) {
  try {
    read(marked.text, file);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems.size(), 1u) << error.what();
    const InputProblem& problem = error.problems.front();
    EXPECT_EQ(problem.file, file);
    EXPECT_EQ(problem.line, marked.line) << error.what();
    EXPECT_EQ(problem.column, marked.column) << error.what();
    for (const char* word : words)
      EXPECT_NE(problem.text().find(word), std::string::npos) << word << " in\n" << error.what();
  }
}

}  // namespace liesl::test
