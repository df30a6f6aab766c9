// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/config/scene.hpp"
#include "src/engine/contacts/contact_record.hpp"
#include "src/measure/frame_observer.hpp"
#include "src/state/frame_contact.hpp"

namespace bagnold {

/// Contacts of a frame with their forces by the scene's law, by i, then j. record: of its run, from
/// which ages follow; null: ages are NaN. time_step: dt, [tau_e].
FrameContacts frame_contacts(Scene const& scene, Frame const& frame, ContactRecord const* record,
                             double time_step);

}  // namespace bagnold
