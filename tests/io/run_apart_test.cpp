// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/run_apart.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace bagnold::io {
namespace {

using Bytes = std::vector<std::byte>;

TEST(RunApart, WhatTheChildFindsComesBack) {
  Bytes many(3'000'000);
  for (std::size_t k = 0; k < many.size(); ++k) many[k] = static_cast<std::byte>(k * k >> 3);
  EXPECT_EQ(run_apart([&] { return many; }), many);
  EXPECT_EQ(run_apart([] { return Bytes{}; }), Bytes{});
}

TEST(RunApart, ItsDeathIsNotOurs) {
  EXPECT_EQ(run_apart([]() -> Bytes {
              std::raise(SIGSEGV);
              return Bytes(1);
            }),
            std::nullopt);
  EXPECT_EQ(run_apart([]() -> Bytes { throw std::runtime_error("no"); }), std::nullopt);
}

TEST(RunApart, WhatItChangesStaysThere) {
  int number = 1;
  run_apart([&] {
    number = 2;
    return Bytes{};
  });
  EXPECT_EQ(number, 1);
}

}  // namespace
}  // namespace bagnold::io
