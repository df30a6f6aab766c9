// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/device/dynamics/contact_forces.hpp"
#include "tests/kernels/device/neighbors/lists.hpp"
#include "tests/reference/scenes.hpp"
#include "tests/support/typed.hpp"

/// The forces on the disks of a state, as the kernels find them.
namespace bagnold::test {

using reference::Model;

/// What one disk feels, and what its pairs add up to.
template <bool Rotates>
struct Felt {
  Load<Rotates> action;
  Vec2<Real> elastic{};
  Vec2<Real> dissipative{};
  Real moment = 0;  ///< sum of r_ij x f_ij
  int contacts = 0;

  Real torque() const {
    if constexpr (Rotates)
      return action.torque;
    else
      return 0;
  }
};

template <bool Rotates>
struct Watch {
  Felt<Rotates>& felt;
  template <class Pair>
  KOKKOS_FUNCTION void operator()(Pair const& pair) const {
    felt.elastic += pair.elastic;
    felt.dissipative += pair.dissipative;
    felt.moment += cross(pair.separation, pair.elastic + pair.dissipative);
    ++felt.contacts;
  }
};

template <class Space, class Forces>
std::vector<Felt<Forces::rotates>> feel(Forces const& forces) {
  constexpr bool rotates = Forces::rotates;
  Kokkos::View<Felt<rotates>*, Space> const felt("test::felt", forces.position.extent(0));
  Kokkos::parallel_for(
      "test::feel", Kokkos::RangePolicy<Space>(0, felt.extent(0)), KOKKOS_LAMBDA(std::int64_t i) {
        Felt<rotates> found;
        found.action = forces(static_cast<std::uint32_t>(i), Watch<rotates>{found});
        felt(i) = found;
      });
  return to_host(felt);
}

/// The forces in a state, in the box, at Q = 2, through a list with a skin of 0.3.
template <class Space, class Law, class Repulsion>
auto felt_in(State state, double strain_rate) {
  VerletList<Space> list;
  Disks const disks{vectors(state.position), state.diameter};
  rebuild(list, disks, state.box_length, state.offset, 0.3);
  state.spin.resize(state.count());
  return feel<Space>(ContactForces<Law, Repulsion, Space>{
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
  static auto felt(State const& state, double rate) {
    return felt_in<typename LawOnSpace::Space, Law, Repulsion>(state, rate);
  }
};

}  // namespace bagnold::test
