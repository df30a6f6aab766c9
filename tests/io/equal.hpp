// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "src/io/checkpoint.hpp"

namespace bagnold::io {

// Equality of bits: -0.0 is not 0.0, and a NaN is itself.

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Row>
bool same(std::vector<Row> const& a, std::vector<Row> const& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0);
}

inline bool same(State const& a, State const& b) {
  return same(a.position, b.position) && same(a.velocity, b.velocity) && same(a.spin, b.spin) &&
         same(a.diameter, b.diameter) && same(a.box_length, b.box_length) &&
         same(a.box_aspect, b.box_aspect) && same(a.offset, b.offset) && same(a.time, b.time) &&
         a.strain_rate.has_value() == b.strain_rate.has_value() &&
         same(a.strain_rate.value_or(0.0), b.strain_rate.value_or(0.0));
}

inline bool same(std::vector<State> const& a, std::vector<State> const& b) {
  bool equal = a.size() == b.size();
  for (std::size_t r = 0; equal && r < a.size(); ++r) equal = same(a[r], b[r]);
  return equal;
}

inline bool same(SystemCheckpoint const& a, SystemCheckpoint const& b) {
  bool records = a.start_record.size() == b.start_record.size();
  for (auto const& [name, value] : a.start_record)
    records = records && b.start_record.contains(name) && same(value, b.start_record.at(name));
  bool frames = a.frames.size() == b.frames.size();
  for (auto const& [name, numbers] : a.frames)
    frames = frames && b.frames.contains(name) && same(numbers, b.frames.at(name));
  return records && frames && same(a.state, b.state) && same(a.list_position, b.list_position) &&
         a.list_step == b.list_step && a.step == b.step &&
         same(a.initial_offset, b.initial_offset) && same(a.initial_time, b.initial_time) &&
         same(a.window_sums, b.window_sums) && a.columns == b.columns &&
         same(a.window_weight, b.window_weight) && same(a.open_sums, b.open_sums) &&
         same(a.open_weight, b.open_weight) && a.list_builds == b.list_builds &&
         a.memory == b.memory && a.counters == b.counters;
}

inline bool same(Checkpoint const& a, Checkpoint const& b) {
  bool equal = a.systems.size() == b.systems.size();
  for (std::size_t r = 0; equal && r < a.systems.size(); ++r)
    equal = same(a.systems[r], b.systems[r]);
  return equal && a.scene == b.scene && same(a.wall_seconds, b.wall_seconds);
}

}  // namespace bagnold::io
