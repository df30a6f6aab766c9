// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>

#include "src/config/errors.hpp"

namespace bagnold {

/// Writes down each number that an engine names.
struct WriteDown {
  std::map<std::string, double>& to;

  template <class Value>
  void operator()(char const* name, Value const& value) const {
    to[name] = static_cast<double>(value);
  }
};

/// Restores what an engine's bits depend on. InputError where one is not among the saved ones.
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

/// Restores what an engine counts for reports; 0 what was not counted yet when it was saved.
struct RestoreCounter {
  std::map<std::string, double> const& from;

  template <class Value>
  void operator()(char const* name, Value& value) const {
    auto const saved = from.find(name);
    value = saved == from.end() ? Value{} : static_cast<Value>(saved->second);
  }
};

}  // namespace bagnold
