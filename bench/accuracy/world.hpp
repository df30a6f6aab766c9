// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "bench/accuracy/near_pairs.hpp"
#include "kernels/cpu/blocks/blocks.hpp"
#include "kernels/device/neighbors/verlet_list.hpp"
#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/schemes/flight_and_kick.hpp"
#include "src/config/errors.hpp"
#include "src/engine/clock.hpp"
#include "src/state/state.hpp"

namespace bagnold::accuracy {

template <class T>
struct Moving {
  Vec2<T> velocity;  ///< lab frame, [d_s / tau_e]
  T spin;            ///< thetadot, [1 / tau_e]; 0 and never touched where the law does not rotate
};

/// A pair in contact, as far as positions alone tell.
template <class T>
struct Touch {
  std::uint32_t i, j;
  std::uint8_t big;    ///< how many of the two are big
  T velocity_shift;    ///< v_x of the image of j less that of j, [d_s / tau_e]
  Vec2<T> separation;  ///< r_ij, [d_s]
  Vec2<T> normal;      ///< r_ij / |r_ij|
  T relative_overlap;  ///< 1 - r_ij / d_ij
  T inverse_distance;  ///< 1 / d_ij
};

/// What a run has asked for: noise-free measures of cost.
struct Counts {
  std::int64_t steps = 0;
  std::int64_t searches = 0;        ///< of the near pairs for contacts, elastic force included
  std::int64_t damping_passes = 0;  ///< over the contacts found
  std::int64_t touches = 0;         ///< contacts found, summed over searches
  std::int64_t builds = 0;          ///< of the list
};

/// One system on the host, stepped by a scheme.
///
/// position and motion belong to the configuration before `step`; what else a scheme keeps between
/// steps is its own. Disks keep their index; positions are wrapped when the list is renewed.
template <ContactLaw L, class R, class P>
class World {
 public:
  using Law = L;
  using Kept = typename P::Kept;
  using Pair = typename P::Pair;
  using Positions = std::vector<Vec2<Kept>>;
  using Motions = std::vector<Moving<Kept>>;
  using Touches = std::vector<Touch<Pair>>;
  static constexpr bool rotates = Law::rotates;

  Law law;
  R repulsion;
  SpeciesTable table;
  Clock clock;
  Real skin = 0.35;
  Arrangement arrangement;
  Positions position;
  Motions motion;
  std::vector<Species> species;
  std::int64_t step = 0;
  Counts counts;

  World(Law law_, SpeciesTable const& table_, State const& state, double strain_rate,
        double time_step)
      : law(law_),
        table(table_),
        clock{strain_rate, time_step, state.box_length, state.offset, state.time, state.box_aspect},
        position(state.count()),
        motion(state.count()),
        species(state.count()) {
    for (std::size_t i = 0; i < state.count(); ++i) {
      position[i] = {static_cast<Kept>(state.position[i][0]),
                     static_cast<Kept>(state.position[i][1])};
      motion[i].velocity = {static_cast<Kept>(state.velocity[i][0]),
                            static_cast<Kept>(state.velocity[i][1])};
      motion[i].spin = rotates ? static_cast<Kept>(state.spin[i]) : Kept(0);
      species[i] = state.diameter[i] > (small_diameter + big_diameter) / 2;
    }
  }

  /// As a start for another world, disks in the box.
  State state() const {
    State s;
    ShearedBox const box = clock.box(step, step);
    for (std::size_t i = 0; i < size(); ++i) {
      Vec2<Real> r{position[i].x, position[i].y};
      Vec2<Real> v{motion[i].velocity.x, motion[i].velocity.y};
      wrap(box, r, v.x);
      s.position.push_back({r.x, r.y});
      s.velocity.push_back({v.x, v.y});
      if (rotates) s.spin.push_back(motion[i].spin);
      s.diameter.push_back(table.diameter[species[i]]);
    }
    s.box_length = clock.box_length;
    s.box_aspect = clock.box_aspect;
    s.offset = box.offset;
    s.time = clock.time(step);
    s.strain_rate = clock.strain_rate;
    return s;
  }

  std::size_t size() const { return position.size(); }
  Kept time_step() const { return static_cast<Kept>(clock.time_step); }

  /// The pairs of `at` in contact, at the strain of step `at_step`, in the order of the list.
  void find_touches(Positions const& at, std::int64_t at_step, Touches& touches) {
    if (near_.pairs.empty() && counts.builds == 0) renew_list();
    touches.clear();
    ShearedBox const box = clock.box(at_step, list_step_);
    across_ = 0;
    for (std::size_t k = 0; k < near_.pairs.size(); ++k) {
      if (k == near_.across) across_ = touches.size();
      NearPair const& pair = near_.pairs[k];
      Vec2<Real> const shift = box.shift(pair.image);
      Kept const shift_x = static_cast<Kept>(shift.x), shift_y = static_cast<Kept>(shift.y);
      Vec2<Pair> const separation{static_cast<Pair>((at[pair.i].x - at[pair.j].x) - shift_x),
                                  static_cast<Pair>((at[pair.i].y - at[pair.j].y) - shift_y)};
      Pair const distance2 = dot(separation, separation);
      Pair const reach = static_cast<Pair>(class_distance(pair.big));
      if (distance2 >= reach * reach) continue;
      Pair const distance = std::sqrt(distance2);
      touches.push_back({pair.i, pair.j, pair.big,
                         static_cast<Pair>(box.velocity_shift(pair.image)), separation,
                         Pair(1) / distance * separation, 1 - distance / reach, 1 / reach});
    }
    if (near_.across == near_.pairs.size()) across_ = touches.size();
    ++counts.searches;
    counts.touches += static_cast<std::int64_t>(touches.size());
  }

  /// Of the touches found last, how many of the first lie across an edge between blocks.
  std::size_t across() const { return across_; }

  /// r_n+1 = r_n + v dt
  void fly() {
    for (std::size_t i = 0; i < size(); ++i)
      position[i] = flown(position[i], motion[i].velocity, time_step());
  }

  /// After position and motion have been brought to the next step. Throws NumericalError where a
  /// disk left reason.
  void finish_step() {
    ++step;
    ++counts.steps;
    double const strain = clock.strain_between(list_step_, step);
    double const next = clock.strain_between(list_step_, step + 1);
    Real largest2 = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      Vec2<Real> const r{position[i].x, position[i].y};
      Vec2<Real> const v{motion[i].velocity.x, motion[i].velocity.y};
      Real const now2 = nonaffine2(r, at_build_[i], strain);
      Real const next2 = nonaffine2(flown(r, v, clock.time_step), at_build_[i], next);
      if (!(next2 < 1e6))
        throw NumericalError("a disk has left reason: the time step is too large");
      largest2 = std::max({largest2, now2, next2});
    }
    if (!list_holds(std::max(std::abs(strain), std::abs(next)), largest2, skin)) renew_list();
  }

 private:
  void renew_list() {
    list_step_ = step;
    ShearedBox const box = clock.box(step, step);
    at_build_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) {
      Vec2<Real> r{position[i].x, position[i].y};
      Real vx = motion[i].velocity.x;
      Real const before = vx;
      wrap(box, r, vx);
      position[i] = {static_cast<Kept>(r.x), static_cast<Kept>(r.y)};
      if (vx != before) motion[i].velocity.x = static_cast<Kept>(vx);
      at_build_[i] = {position[i].x, position[i].y};
    }
    near_ = find_near_pairs(at_build_, species, box, skin, arrangement);
    ++counts.builds;
  }

  NearPairs near_;
  std::vector<Vec2<Real>> at_build_;
  std::int64_t list_step_ = 0;
  std::size_t across_ = 0;
};

}  // namespace bagnold::accuracy
