// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// phi_J of frictionless disks, half of them 1.4 times as big, under continued shear: P1 Sec. III
/// B, there from its Ref. [5]; P2 Fig. 25 has 0.8433. It is a property of the packing and
/// independent of the law.
inline constexpr double jamming_fraction = 0.84335;

}  // namespace bagnold
