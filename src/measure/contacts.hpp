// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/engine/contacts/contact_record.hpp"
#include "src/measure/frames.hpp"

namespace bagnold {

/// A record of contacts for the windows of a system, counting from the end of the discarded strain
/// on. What it knows is saved and reported with `frames`, though no frame is shown to it. columns:
/// Simulation::columns(); seed: of this system.
std::shared_ptr<ContactRecord> watch_contacts(Scene const& scene, Plan const& plan, int columns,
                                              std::int64_t seed, Frames& frames);

}  // namespace bagnold
