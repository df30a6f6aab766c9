// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "kernels/cpu/contacts/contact_event.hpp"
#include "kernels/physics/closed_form/contact_class.hpp"
#include "src/engine/contacts/contact_record.hpp"

namespace bagnold::events {

/// Begins and ends of contacts on their way to a ContactRecord, which counts steps: a contact is
/// there from the first step at or after its begin to the first one at or after its end. One that
/// no step sees is not told of.
class ContactLog {
 public:
  bool on = false;         ///< whether there is a record
  ContactMotion motion{};  ///< integrals over the contacts of the window under way

  void begins(std::uint32_t i, std::uint32_t j, Real time, Vec2<Real> const& separation,
              Vec2<Real> const& velocity) {
    if (on) now_.push_back(happening(true, i, j, time, separation, velocity));
  }
  void ends(std::uint32_t i, std::uint32_t j, Real time, Vec2<Real> const& separation,
            Vec2<Real> const& velocity) {
    if (on) now_.push_back(happening(false, i, j, time, separation, velocity));
  }

  /// A contact of two alone will end at a time, if it is not cut short: its number.
  std::uint64_t expect_end(std::uint32_t i, std::uint32_t j, Real time,
                           Vec2<Real> const& separation, Vec2<Real> const& velocity);
  void cut(std::uint64_t number) {
    if (on) cut_.insert(number);
  }

  /// Tells of all up to a time, the end of a step. step_of(t): the first one at or after t.
  template <class StepOf>
  void tell(Real until, StepOf const& step_of, Sampling const& sampling, OpenWindows& windows) {
    take_ends(until);
    for (auto& one : now_) one.event.step = step_of(one.time);
    tell(sampling, windows);
  }

  /// Times are counted from a time on.
  void shift(Real time);

 private:
  struct Happening {
    Real time;
    ContactEvent event;
    std::uint64_t number = 0;

    friend bool operator>(Happening const& l, Happening const& r) {
      return std::tie(l.time, l.event.a, l.event.b) > std::tie(r.time, r.event.a, r.event.b);
    }
  };

  static Happening happening(bool begins, std::uint32_t i, std::uint32_t j, Real time,
                             Vec2<Real> const& separation, Vec2<Real> const& velocity) {
    return {time, contact_event(0, begins, i, j, separation, velocity)};
  }
  void take_ends(Real until);
  void tell(Sampling const& sampling, OpenWindows& windows);

  std::vector<Happening> now_;   ///< not told of
  std::vector<Happening> ends_;  ///< a heap, the first one on top
  std::unordered_set<std::uint64_t> cut_;
  std::uint64_t numbers_ = 0;
};

}  // namespace bagnold::events
