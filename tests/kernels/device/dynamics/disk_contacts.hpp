// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "tests/kernels/device/neighbors/lists.hpp"
#include "tests/reference/scenes.hpp"
#include "tests/support/typed.hpp"

/// The forces on the disks of a state, as the kernels find them.
namespace bagnold::test {

using reference::Model;

/// What acts on one disk, and what its pairs add up to.
template <bool Rotates>
struct DiskContacts {
  Load<Rotates> load;
  Vec2<Real> elastic{};
  Vec2<Real> dissipative{};
  Real moment = 0;  ///< sum of r_ij x f_ij
  int contacts = 0;

  Real torque() const {
    if constexpr (Rotates)
      return load.torque;
    else
      return 0;
  }
};

template <bool Rotates>
struct Observer {
  DiskContacts<Rotates>& on_disks;
  template <class Pair>
  KOKKOS_FUNCTION void operator()(Pair const& pair) const {
    on_disks.elastic += pair.elastic;
    on_disks.dissipative += pair.dissipative;
    on_disks.moment += cross(pair.separation, pair.elastic + pair.dissipative);
    ++on_disks.contacts;
  }
};

template <class Space, class Forces>
std::vector<DiskContacts<Forces::rotates>> evaluate(Forces const& forces) {
  constexpr bool rotates = Forces::rotates;
  Kokkos::View<DiskContacts<rotates>*, Space> const on_disks("test::on_disks",
                                                             forces.position.extent(0));
  Kokkos::parallel_for(
      "test::evaluate", Kokkos::RangePolicy<Space>(0, on_disks.extent(0)),
      KOKKOS_LAMBDA(std::int64_t i) {
        DiskContacts<rotates> found;
        found.load = forces(static_cast<std::uint32_t>(i), Observer<rotates>{found});
        on_disks(i) = found;
      });
  return to_host(on_disks);
}

/// The forces in a state, in the box, at Q = 2, through a list with a skin of 0.3.
template <class Space, class Law, class Repulsion>
auto contacts_of(State state, double strain_rate) {
  VerletList<Space> list;
  Disks const disks{vectors(state.position), state.diameter};
  rebuild(list, disks, state.box_length, state.offset, 0.3);
  state.spin.resize(state.count());
  return evaluate<Space>(ContactForces<Law, Repulsion, Space>{
      to_device<Space>("test::position", disks.position),
      to_device<Space>("test::motion", motions<Law::rotates>(state)),
      to_device<Space>("test::species", species_of(state.diameter)), list.rows,
      make_species_table(false), ShearedBox{state.box_length, state.offset, strain_rate},
      law_at<Law>(2.0), Repulsion{}});
}

/// Tests of forces, for every law on every backend. The laws are those of reference::parameters().
template <class LawOnSpace>
class ForcesOn : public testing::Test {
 public:
  using Law = typename LawOnSpace::Law;

  static reference::Parameters parameters() { return reference::parameters(Law::name); }

  template <class Repulsion = HarmonicRepulsion>
  static auto on_disks(State const& state, double rate) {
    return contacts_of<typename LawOnSpace::Space, Law, Repulsion>(state, rate);
  }
};

}  // namespace bagnold::test
