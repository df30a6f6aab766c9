// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/checked_sweep.hpp"

#include <gtest/gtest.h>

#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

std::string note(std::string const& rates, std::string const& chain = "shear.strain_rate") {
  return rising_chain_note(expand("[sweep]\nchain = \"" + chain +
                                  "\"\ngrid = { \"shear.strain_rate\" = " + rates +
                                  ", \"disks.seed\" = [1, 2] }\n"));
}

TEST(RisingChain, IsToldWithItsRates) {
  auto const words = note("[1e-4, 1e-3]");
  for (auto const* part : {"0.0001", "0.001", "largest rate first", "disks.seed = 1"})
    EXPECT_NE(words.find(part), std::string::npos) << words;
  EXPECT_NE(note("[1e-3, 1e-4, 2e-4]").find("from 0.0001 to 0.0002"), std::string::npos);
}

TEST(RisingChain, OthersAreNot) {
  EXPECT_EQ(note("[1e-3, 1e-4]"), "");
  EXPECT_EQ(note("[1e-4, 1e-3]", "disks.seed"), "") << "the rate stays along the chain";
  EXPECT_EQ(rising_chain_note(expand("[sweep]\ngrid = { \"shear.strain_rate\" = [1e-4, 1e-3] }\n")),
            "");
}

}  // namespace
}  // namespace bagnold::sweep
