// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/quasi_static_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/engine/device_copy.hpp"
#include "src/engine/engine_memory.hpp"
#include "src/engine/failure.hpp"
#include "src/engine/quasi_static/step_sums.hpp"
#include "src/engine/wrap_state.hpp"

namespace bagnold {

namespace {

constexpr double list_share = 0.6;  ///< of the skin, up to which a list is kept for another step
constexpr double shortest_part = 1e-5;  ///< of a step

template <bool Rotates>
Eigen::VectorXd motion_of(State const& state) {
  constexpr int unknowns = Rotates ? 3 : 2;
  Eigen::VectorXd motion(unknowns * static_cast<Eigen::Index>(state.count()));
  for (std::size_t i = 0; i < state.count(); ++i) {
    auto const at = unknowns * static_cast<Eigen::Index>(i);
    motion[at] = state.velocity[i][0];
    motion[at + 1] = state.velocity[i][1];
    if (Rotates) motion[at + 2] = state.spin[i];
  }
  return motion;
}

}  // namespace

template <bool Rotates>
QuasiStaticEngine<Rotates>::QuasiStaticEngine(quasi_static::Material material,
                                              StrainRates const& rates, double time_step,
                                              double skin, Snapshot const& snapshot, Real tolerance)
    : material_(std::move(material)),
      tolerance_(tolerance),
      clock_(rates, time_step, snapshot),
      step_(snapshot.step),
      diameter_(snapshot.state.diameter),
      position_(vectors(snapshot.state.position)),
      motion_(motion_of<Rotates>(snapshot.state)),
      list_(skin),
      builds_(snapshot.list_builds),
      equations_(material_) {
  visit_counters(*this, RestoreCounter{snapshot.counters});
  if (snapshot.list_position.empty()) {
    renew_list(0);
  } else {
    list_.build(material_, vectors(snapshot.list_position),
                {clock_.at(snapshot.list_step), snapshot.list_step});
    matrix_.order(count(), list_.contacts());
  }
}

template <bool Rotates>
int QuasiStaticEngine<Rotates>::columns() const {
  return Sums<Rotates>::columns;
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::advance(std::int64_t steps, Sampling const& sampling,
                                         OpenWindows& windows) {
  for (auto const end = std::min(step_ + steps, sampling.last_step); step_ < end;) {
    auto const step = step_;
    do_step();
    if (sampling.sampled(step)) add_sums(sampling.window(step), windows);
  }
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::do_step() {
  if (!list_.holds(position_, moment(0), list_share)) renew_list(0);
  do_parts();
  ++step_;
  check_overlaps();
  if (list_.is_within_a_step()) renew_list(0);  // snapshots have lists of whole steps
}

/// Does one step, in parts if Newton's iterations do not converge or a disk outruns a new list:
/// each part is half as long as the one before; later ones double again.
template <bool Rotates>
void QuasiStaticEngine<Rotates>::do_parts() {
  Eigen::VectorXd solved;
  for (double done = 0, part = 1; done < 1;) {
    part = std::min(part, 1 - done);
    auto const end = moment(done + part);
    equations_.begin(
        {position_, motion_, part * clock_.time_step, list_.box(moment(done)), list_.box(end)},
        list_.pairs());
    bool const converged = solve_step(equations_, matrix_, tolerance_, solved, counts_);
    if (converged && list_.holds(equations_.position(), end)) {
      position_ = equations_.position();
      motion_ = solved;
      done += part;
      part *= 2;
      continue;
    }
    if (converged && !list_.is_of(moment(done))) {
      renew_list(done);
      continue;
    }
    if (part / 2 < shortest_part) stop(converged, end);
    ++halved_;
    part /= 2;
  }
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::stop(bool converged, quasi_static::Moment const& end) const {
  if (converged) {
    auto const [moved2, disk] = list_.farthest(equations_.position(), end);
    failure::too_fast(clock_, step_, disk, std::sqrt(moved2), list_.skin());
  }
  throw NumericalError(fmt::format(
      "{}: the equations of the step have no solution that Newton's iterations find, nor those of "
      "steps down to {} of it (integration.time_step = {:.6g}); set integration.engine = \"auto\"",
      failure::where(clock_, step_), shortest_part, clock_.time_step));
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::renew_list(double part) {
  auto const now = moment(part);
  ShearedBox const box = quasi_static::PairList::box(now, clock_.mark(step_));
  for (std::size_t i = 0; i < position_.size(); ++i)
    wrap(box, position_[i], motion_[unknowns * static_cast<Eigen::Index>(i)]);
  list_.build(material_, position_, now);
  matrix_.order(count(), list_.contacts());
  ++builds_;
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::check_overlaps() const {
  for (auto const& pair : equations_.active())
    if (pair.touches && pair.force.relative_overlap > largest_relative_overlap)
      failure::too_deep(clock_, step_, pair.i, pair.force.relative_overlap);
}

template <bool Rotates>
void QuasiStaticEngine<Rotates>::add_sums(std::int64_t window, OpenWindows& windows) const {
  auto const sums = quasi_static::step_sums<Rotates>(material_, equations_.active(), position_,
                                                     motion_, clock_.strain_rate);
  windows.add(window, sums.value, 1);
}

template <bool Rotates>
Snapshot QuasiStaticEngine<Rotates>::snapshot() const {
  Snapshot s = clock_.snapshot(step_, list_.step(), builds_);
  s.state = raw_state();
  s.list_position = pairs(list_.position());
  visit_counters(*this, WriteDown{s.counters});
  return s;
}

template <bool Rotates>
State QuasiStaticEngine<Rotates>::state() const {
  return wrap_state(raw_state());
}

template <bool Rotates>
State QuasiStaticEngine<Rotates>::raw_state() const {
  State state;
  state.position = pairs(position_);
  state.velocity.resize(position_.size());
  if (Rotates) state.spin.resize(position_.size());
  for (std::size_t i = 0; i < position_.size(); ++i) {
    auto const at = unknowns * static_cast<Eigen::Index>(i);
    state.velocity[i] = {motion_[at], motion_[at + 1]};
    if (Rotates) state.spin[i] = motion_[at + 2];
  }
  state.diameter = diameter_;
  clock_.tell(state, step_);
  return state;
}

template class QuasiStaticEngine<false>;
template class QuasiStaticEngine<true>;

}  // namespace bagnold
