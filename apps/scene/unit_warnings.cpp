/// @file
/// Values that are possible but look like another unit than SI.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/scene/reader.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl {

namespace {

// Bulk solids are between rubber and diamond, foam and (ten times) lead; nothing falls a hundred
// times faster than here.
constexpr double kSoftest = 5e5, kStiffest = 2e12;   // Pa
constexpr double kLightest = 10, kHeaviest = 1.2e5;  // kg/m^3
constexpr double kStrongestGravity = 1e3;            // m/s^2

std::string modulus(const Material& m) {
  const double E = m.E;
  if (E >= kSoftest && E <= kStiffest) return "";
  if (E > kStiffest)
    return fmt::format("materials.{}.E = {:g} Pa is stiffer than diamond: steel has 2.1e11", m.name,
                       E);
  const bool giga = E < 2000;
  return fmt::format("materials.{}.E = {:g} Pa is softer than rubber: {:g} {} is {:g} Pa", m.name,
                     E, E, giga ? "GPa" : "MPa", E * (giga ? 1e9 : 1e6));
}

std::string density(const Material& m) {
  if (m.rho == 0 || (m.rho >= kLightest && m.rho <= kHeaviest)) return "";
  const bool light = m.rho < kLightest;
  return fmt::format("materials.{}.rho = {:g} kg/m^3 is {}: {}", m.name, m.rho,
                     light ? "lighter than foam" : "heavier than any solid",
                     light && m.rho > 0.1
                         ? fmt::format("{:g} g/cm^3 is {:g} kg/m^3", m.rho, 1e3 * m.rho)
                         : "densities are in kg/m^3");
}

/// Largest dimension of a section against the size of the whole mechanism.
std::string breadth(const Section& section, double size) {
  for (const auto name : dimensions(section.shape)) {
    const double d = dimension(section.shape, name);
    if (d > size)
      return fmt::format(
          "sections.{}.{} = {:g} m is larger than the whole mechanism ({:.3g} m): "
          "{:g} mm is {:g} m",
          section.name, name, d, size, d, 1e-3 * d);
  }
  return "";
}

/// Thickness of a planar part against the size of the whole mechanism.
std::string thickness(const BodySpec& body, double size) {
  const auto* part = std::get_if<SolidSpec>(&body.kind);
  if (!part || !part->model || part->mesh().cell_count() == 0 || part->mesh().dim != 2) return "";
  const double t = part->model->thickness();
  if (t <= size) return "";
  return fmt::format(
      "bodies.{}.solid.thickness = {:g} m is larger than the whole mechanism ({:.3g} m): "
      "{:g} mm is {:g} m",
      body.name, t, size, t, 1e-3 * t);
}

/// A turn of a screw against the size of the whole mechanism, 1 m if it is a single point.
std::string pitch(const JointSpec& joint, double size) {
  if (std::abs(joint.pitch) <= (size > 0 ? size : 1)) return "";
  return fmt::format("joints.{}.pitch = {:g} m in one turn is {}: {:g} mm is {:g} m", joint.name,
                     joint.pitch,
                     size > 0 ? fmt::format("larger than the whole mechanism ({:.3g} m)", size)
                              : "more than a metre",
                     joint.pitch, 1e-3 * joint.pitch);
}

constexpr double kFast = 1000;  // rad/s: some 10,000 turns a minute, as rpm mistaken for rad/s are

std::string in_rpm(double rate) {
  return fmt::format("turns at {0:g} rad/s, that is {1:.4g} rpm: {0:g} rpm is {2:.4g} rad/s", rate,
                     rate * 30 / M_PI, rate * M_PI / 30);
}

/// Of a body at the start.
std::string rate_of(const BodySpec& body) {
  const double rate = body.angular_velocity.norm();
  return rate < kFast ? "" : fmt::format("bodies.{}.angular_velocity {}", body.name, in_rpm(rate));
}

/// Of a drive, the largest.
std::string rate_of(const Mechanism& mechanism, const DriveSpec& drive, double duration) {
  const JointSpec& joint = mechanism.joints[static_cast<std::size_t>(drive.joint)];
  const JointKind& kind = kind_of(joint.type);
  const bool there = drive.coordinate < kind.coordinate_count();  // or it is refused
  if (!there || kind.unit(drive.coordinate) != std::string_view("rad")) return "";
  constexpr int kSamples = 32;
  double rate = 0;
  for (int k = 0; k <= kSamples; ++k)
    rate = std::max(rate, std::abs(drive.motion.rate(duration * k / kSamples)));
  if (rate < kFast) return "";
  return fmt::format("joints.{}.drive {}", joint.name, in_rpm(rate));
}

}  // namespace

std::vector<std::string> unit_warnings(const Reader& reader) {
  std::vector<std::string> warnings;
  const auto add = [&warnings](std::string text) {
    if (!text.empty()) warnings.push_back(std::move(text));
  };
  for (const auto& [name, material] : reader.materials) {
    add(modulus(material));
    add(density(material));
  }
  const double size = reader.scene.mechanism.size();
  for (const auto& [name, section] : reader.sections)
    if (size > 0) add(breadth(section, size));
  for (const BodySpec& body : reader.scene.mechanism.bodies)
    if (size > 0 && !reader.fixed_loads) add(thickness(body, size));
  for (const BodySpec& body : reader.scene.mechanism.bodies) add(rate_of(body));
  for (const JointSpec& joint : reader.scene.mechanism.joints) add(pitch(joint, size));
  for (const DriveSpec& drive : reader.scene.mechanism.drives)
    add(rate_of(reader.scene.mechanism, drive, reader.scene.simulation.duration));
  if (const double g = reader.scene.mechanism.gravity.norm(); g > kStrongestGravity)
    add(fmt::format("gravity = {:g} m/s^2: {:g} mm/s^2 is {:g} m/s^2", g, g, 1e-3 * g));
  return warnings;
}

}  // namespace liesl
