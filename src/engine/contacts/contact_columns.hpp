// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cpu/contacts/contact_sample.hpp"

namespace bagnold {

/// Sums over the contacts of a measurement window, behind the columns of SumColumns.
struct ContactColumns {
  enum : int {
    motion = 0,  ///< columns of ContactMotion, over contacts in the evaluated configurations
    begun = ContactMotion::count,  ///< contacts
    ended,                         ///< contacts whose beginning was seen
    duration,                      ///< of these, whole, [steps]
    binary,  ///< of these, those in which neither disk ever touched a third one
    steps,   ///< configurations evaluated for all this
    count
  };
};

}  // namespace bagnold
