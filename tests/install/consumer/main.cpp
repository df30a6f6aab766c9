// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/physics/laws/cd_n.hpp"

/// Two disks approach head on, at speed 1, damping 2: the force on i is 2 along the normal.
int main() {
  bagnold::CDn const law{2.0};  // damping
  bagnold::Contact<double> const contact{.normal = {1.0, 0.0},
                                         .velocity = {-1.0, 3.0},
                                         .relative_overlap = 0.01,
                                         .inverse_distance = 1.0};
  bagnold::Vec2<double> const force = law.dissipative_force(contact);
  return force.x == 2.0 && force.y == 0.0 ? 0 : 1;
}
