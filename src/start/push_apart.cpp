// SPDX-License-Identifier: BSD-3-Clause
#include "src/start/push_apart.hpp"

#include <algorithm>
#include <utility>

#include "kernels/device/dynamics/relaxation.hpp"
#include "kernels/device/side_by_side.hpp"
#include "src/engine/device_copy.hpp"

namespace bagnold {

namespace {

/// Disks at rest that push each other apart, whatever their overlap.
template <class Space>
class Relaxer {
 public:
  Relaxer(State const& state, double skin)
      : box_{state.box_length, state.offset, 0.0, state.box_height()},
        position_(to_device<Space>("start::position", vectors(state.position))),
        next_position_("start::next_position", state.count()),
        motion_("start::motion", state.count()),
        species_(to_device<Space>("start::species", species_of(state.diameter))) {
    list_.skin = skin;
    list_.at_build = Positions("start::at_build", state.count());
    renew_list();
  }

  void iterate() {
    Real largest2 = 0;
    side_by_side::parallel_reduce("start::Relax", policy(),
                                  Relax<Space>{forces(), motion_, next_position_, list_.at_build},
                                  Kokkos::Max<Real>(largest2));
    std::swap(position_, next_position_);
    if (!list_holds(0.0, largest2, list_.skin)) renew_list();
  }

  double largest_overlap() const {
    using Overlap = LargestOverlap<NoDissipation, HarmonicRepulsion, Space>;
    typename Overlap::Value deepest{};
    side_by_side::parallel_reduce("start::LargestOverlap", policy(), Overlap{forces()},
                                  Kokkos::MaxLoc<Real, std::int64_t>(deepest));
    return std::max(0.0, deepest.val);
  }

  void write_to(State& state) {
    renew_list();  // takes the disks into the box
    state.position = pairs(to_host(position_));
  }

 private:
  using Positions = Kokkos::View<Vec2<Real>*, Space>;
  using Policy = Kokkos::RangePolicy<Space, Kokkos::IndexType<std::int64_t>>;

  Policy policy() const { return Policy(0, static_cast<std::int64_t>(position_.extent(0))); }

  ContactForces<NoDissipation, HarmonicRepulsion, Space> forces() const {
    return {position_, motion_, species_, list_.rows, table_, box_, {}, {}};
  }

  void renew_list() {
    side_by_side::parallel_for("start::wrap", policy(), WrapDisks{box_, position_});
    Kokkos::deep_copy(list_.at_build, position_);
    build_list(Space{}, list_, species_, table_, box_);
  }

  struct WrapDisks {
    ShearedBox box;
    Positions position;
    KOKKOS_FUNCTION void operator()(std::int64_t i) const {
      Real none = 0;
      wrap(box, position(i), none);
    }
  };

  SpeciesTable table_ = make_species_table(false);
  ShearedBox box_;
  Positions position_;
  Positions next_position_;
  Kokkos::View<Motion<false>*, Space> motion_;
  Kokkos::View<Species*, Space> species_;
  VerletList<Space> list_;
};

/// One iteration at a time.
template <class Space>
Relaxation push_apart_on(State& state, double overlap, std::int64_t iterations, double skin,
                         std::function<bool()> const& go_on) {
  Relaxer<Space> relaxer(state, skin);
  std::int64_t done = 0;
  double left = relaxer.largest_overlap();
  while (left > overlap && done < iterations) {
    if (!go_on()) throw StartStopped{};
    std::int64_t const more = std::min(between_checks, iterations - done);
    for (std::int64_t k = 0; k < more; ++k) relaxer.iterate();
    done += more;
    left = relaxer.largest_overlap();
  }
  relaxer.write_to(state);
  return {done, left};
}

}  // namespace

Relaxation push_apart(State& state, double overlap, std::int64_t iterations, double skin,
                      bool threads, std::function<bool()> const& go_on) {
#ifdef KOKKOS_ENABLE_SERIAL
  if (!threads) return push_apart_on<Kokkos::Serial>(state, overlap, iterations, skin, go_on);
#else
  (void)threads;  // there is no other host
#endif
  return push_apart_on<Kokkos::DefaultHostExecutionSpace>(state, overlap, iterations, skin, go_on);
}

}  // namespace bagnold
