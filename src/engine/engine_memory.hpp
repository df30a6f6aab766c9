// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "src/config/errors.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold {

/// Saves each number that an engine names.
struct WriteDown {
  std::map<std::string, double>& to;

  template <class Value>
  void operator()(char const* name, Value const& value) const {
    to[name] = static_cast<double>(value);
  }
};

/// Restores numbers on which an engine's bits depend. InputError where one is missing.
struct RestoreMemory {
  std::map<std::string, double> const& from;

  template <class Value>
  void operator()(char const* name, Value& value) const {
    auto const saved = from.find(name);
    if (saved == from.end())
      throw InputError(fmt::format(
          "the checkpoint lacks {}, which this engine goes on from; resume with the version that "
          "wrote it",
          name));
    value = static_cast<Value>(saved->second);
  }
};

/// Restores counters of an engine's reports; 0 for those that did not exist when they were saved.
struct RestoreCounter {
  std::map<std::string, double> const& from;

  template <class Value>
  void operator()(char const* name, Value& value) const {
    auto const saved = from.find(name);
    value = saved == from.end() ? Value{} : static_cast<Value>(saved->second);
  }
};

/// A snapshot that another engine goes on from: the state alone, with counters.
inline Snapshot handed_over(Snapshot&& snapshot) {
  Snapshot to = std::move(snapshot);
  to.list_position.clear();
  to.list_step = 0;
  to.memory.clear();
  to.arrays.clear();
  return to;
}

using Counters = std::map<std::string, double>;

/// Counters of the engine at work, joined with those of the engines before.
inline Counters joined(Counters of_engine, Counters const& before) {
  of_engine.insert(before.begin(), before.end());
  return of_engine;
}

}  // namespace bagnold
