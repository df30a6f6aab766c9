// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/skin.hpp"

#include <algorithm>

#include "kernels/physics/species.hpp"
#include "src/config/events.hpp"
#include "src/config/names.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

double skin(Scene const& scene) {
  if (auto const& given = scene.integration.skin.number) return *given;
  double const wide = has_events(scene) ? 0.7 : is_implicit(scheme_of(scene)) ? 0.5 : usual_skin;
  double const least = std::min(scene.box_length(), scene.box_height());
  return least >= 2 * (big_diameter + wide) ? wide : usual_skin;
}

}  // namespace bagnold
