// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/engine/contacts/contact_record.hpp"
#include "src/measure/frames.hpp"

namespace bagnold {

/// Record of contacts for the windows of a system, from the end of the discarded strain on. Its
/// results are saved and reported with `frames`, though it is shown no frame. columns:
/// Simulation::columns(); seed: of this system.
std::shared_ptr<ContactRecord> watch_contacts(Scene const& scene, Plan const& plan, int columns,
                                              std::int64_t seed, Frames& frames);

}  // namespace bagnold
