// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "src/config/names.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

namespace {

struct Protocol {
  std::string_view name;
  bool run_per_rate = false, ramps = false, by_pieces = false, lists_pieces = false,
       oscillates = false, finds_rate = false, changes_box = false, lengthens = false;
};

/// Words of shear.protocol, each with all that the program asks of it.
constexpr Protocol protocols[] = {
    {.name = "steady", .lengthens = true},
    {.name = "cascade", .run_per_rate = true},
    {.name = "ramp", .ramps = true},
    {.name = "sequence", .by_pieces = true, .lists_pieces = true},
    {.name = "oscillate", .by_pieces = true, .oscillates = true},
    {.name = "stress", .by_pieces = true, .finds_rate = true},
    {.name = "pressure", .changes_box = true, .lengthens = true},
};

/// Protocol of a scene. Another word, which its key refuses, has no property.
Protocol const& of(Scene::Shear const& shear) {
  static constexpr Protocol none{};
  auto const* const found = std::ranges::find(protocols, shear.protocol, &Protocol::name);
  return found == std::end(protocols) ? none : *found;
}

}  // namespace

Names protocol_names() {
  Names names;
  for (auto const& protocol : protocols) names.push_back(protocol.name);
  return names;
}

bool Scene::Shear::run_per_rate() const { return of(*this).run_per_rate; }
bool Scene::Shear::ramps() const { return of(*this).ramps; }
bool Scene::Shear::by_pieces() const { return of(*this).by_pieces; }
bool Scene::Shear::lists_pieces() const { return of(*this).lists_pieces; }
bool Scene::Shear::oscillates() const { return of(*this).oscillates; }
bool Scene::Shear::finds_rate() const { return of(*this).finds_rate; }
bool Scene::Shear::changes_box() const { return of(*this).changes_box; }
bool Scene::Shear::lengthens() const { return of(*this).lengthens; }

}  // namespace bagnold
