#pragma once
/// @file
/// A scene without a fault, for tests that put one in.

#include <stdexcept>
#include <string>

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

}  // namespace liesl::test
