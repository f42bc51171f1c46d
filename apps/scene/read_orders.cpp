/// @file
/// The order of the elements of beams, which by default loads over them have a say in.
#include <fmt/format.h>

#include "apps/scene/reader.hpp"
#include "mbs/model/beam_order.hpp"

namespace liesl {

namespace {

/// What a beam that is asked to be of order 4 cannot be.
void refuse_order_4(Reader& reader, int body, const toml::node& order) {
  const Mechanism& m = reader.scene.mechanism;
  const BodySpec& spec = m.bodies[static_cast<std::size_t>(body)];
  for (const auto& [what, expected] : against_order_4(std::get<BeamSpec>(spec.kind), m.formalism))
    reader.problems.add(order, fmt::format("beam '{}' of order 4 {}", spec.name, what), expected);
}

}  // namespace

void read_orders(Reader& reader) {
  auto& bodies = reader.scene.mechanism.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    auto* beam = std::get_if<BeamSpec>(&bodies[b].kind);
    if (!beam) continue;
    const int body = static_cast<int>(b);
    const toml::node* order = reader.root["bodies"][bodies[b].name]["beam"]["order"].node();
    beam->order = order ? order->value_or(0) : default_order(reader.scene.mechanism, body);
    if (!order || beam->order == 2) continue;
    if (beam->order == 4)
      refuse_order_4(reader, body, *order);
    else
      reader.problems.add(
          *order, fmt::format("beam '{}' has order {}", bodies[b].name, beam->order), "2 or 4");
  }
}

}  // namespace liesl
