// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/frame_contacts.hpp"

#include "src/engine/law_engines.hpp"
#include "src/measure/disk_search.hpp"

namespace bagnold {

FrameContacts frame_contacts(Scene const& scene, Frame const& frame, ContactRecord const* record,
                             double time_step) {
  auto contacts = engines_for(scene.disks.model)
                      .contacts(engine_input(scene), frame.state, disk_search(frame.state, 0.0));
  if (record == nullptr || frame.step == 0) return contacts;
  for (auto& contact : contacts) {
    auto const* const open = record->table.find(contact.i, contact.j);
    if (open != nullptr && open->begin == 0) continue;  // since the start, or longer
    // not recorded yet: it begins in this configuration
    auto const steps = open == nullptr ? 0 : frame.step - open->begin;
    contact.age = time_step * static_cast<double>(steps);
  }
  return contacts;
}

}  // namespace bagnold
