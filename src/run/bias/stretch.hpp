// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "src/config/scene.hpp"
#include "src/engine/simulation.hpp"
#include "src/run/stretch_size.hpp"
#include "src/statistics/windows.hpp"

namespace bagnold::bias {

/// Averages over a stretch: its last two thirds, and T_g also over the first.
struct Averages {
  double p, sigma, contact_number, temperature, kinetic_pressure, temperature_before;

  static constexpr std::size_t count = 6;
  std::array<double, count> numbers() const {
    return {p, sigma, contact_number, temperature, kinetic_pressure, temperature_before};
  }
  static Averages of(std::array<double, count> const& n) {
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
  }
  bool operator==(Averages const&) const = default;
};

/// Averages of a stretch over every `stride`-th of its windows, each as long as the others.
Averages averages_of(Scene const& scene, double box_length, OpenWindows const& windows,
                     std::size_t stride = 1);

/// Averages of a stretch that the run itself steps, over its windows first .. last - 1.
Averages averages_of(Scene const& scene, double box_length, statistics::Windows const& windows,
                     std::size_t first, std::size_t last);

/// A state of a run that steps by the scene `from`, for steps of `to`: velocities at the time
/// before that of the positions at which `to` has them, interpolated in the next step of `from`,
/// where they are nearer. Else a finer method begins with those of another time, and its T_g is off
/// by some per cent for about a contact.
State handed_over(State start, Scene const& from, Scene const& to, std::string const& backend);

/// One method's steps from a state of the run, in a system of its own.
class Stretch {
 public:
  /// third: of the length, in instants; between two of them lie `every` steps.
  Stretch(Scene const& scene, State const& start, std::string const& backend, std::int64_t third,
          std::int64_t every);

  /// Steps on. Returns false if go_on, asked about twenty times a second, did before the end.
  bool advance(std::function<bool()> const& go_on);

  /// Averages over the instants, once it is done.
  Averages averages() const;

 private:
  Scene scene_;
  double box_length_;
  std::unique_ptr<Simulation> simulation_;
  Sampling sampling_;
  OpenWindows thirds_;
  StretchSize size_;
};

/// Two stretches from one state, looked at at the same instants; or the reason why there are none.
struct Pair {
  std::int64_t step;  ///< of the run, from which they begin
  Averages coarse, fine;

  /// None taken there: scheme = "auto" saw that the method does not serve at present, as inertia
  /// has a part in the flow or events step it.
  static Pair skipped(std::int64_t step, bool by_events = false) {
    return {step, {0, 0, 0, 0, 0, by_events ? 1.0 : 0.0}, {}};
  }
  bool is_skipped() const { return coarse.p == 0 && fine.p == 0; }
  bool skips_events() const { return is_skipped() && coarse.temperature_before != 0; }

  /// None taken there: it was seen that the method still serves.
  static Pair watched(std::int64_t step) { return {step, {-HUGE_VAL, 0, 0, 0, 0, 0}, {}}; }

  /// A step of one of them failed.
  static Pair failed(std::int64_t step) { return {step, {HUGE_VAL, 0, 0, 0, 0, 0}, {}}; }
  bool is_failed() const { return coarse.p == HUGE_VAL; }

  bool is_taken() const { return !is_skipped() && !std::isinf(coarse.p); }
};

}  // namespace bagnold::bias
