// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// What is summed over the contacts of a measurement window, behind the columns of SumColumns.
struct ContactColumns {
  enum : int {
    normal2,      ///< sum v_N^2 over contacts in the evaluated configurations, [d_s^2 / tau_e^2]
    tangential2,  ///< sum v_T^2
    begun,        ///< contacts
    ended,        ///< contacts whose beginning was seen
    duration,     ///< of these, whole, [steps]
    binary,       ///< of these, those in which neither disk ever touched a third one
    steps,        ///< configurations looked at for all this
    count
  };
};

}  // namespace bagnold
