// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/value_advice.hpp"

#include <gtest/gtest.h>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

TEST(ValueAdvice, SaysHowItIsWritten) {
  struct Case {
    char const *value, *advice;
  };
  for (auto const& [value, advice] : std::vector<Case>{{"40,0", "write 40.0"},
                                                       {"-0,5", "write -0.5"},
                                                       {"1,5e-3", "write 1.5e-3"},
                                                       {",5", "write 0.5"},
                                                       {" 40,0  # strain", "write 40.0"},
                                                       {"10,000", "write 10000, or 10.000"},
                                                       {"0,001", "write 0.001"},
                                                       {"1,000,000", "write 1000000"},
                                                       {"1d-3", "write 1e-3"},
                                                       {"1e400", "below 1.8e308"},
                                                       {"9223372036854775808", "below 2^63"},
                                                       {".5", "write 0.5"},
                                                       {"-.5e3", "write -0.5e3"},
                                                       {"5.", "write 5.0"},
                                                       {"5.e-3", "write 5.0e-3"},
                                                       {"010", "write 10"},
                                                       {"00.5", "write 0.5"},
                                                       {"1 000", "write 1000"},
                                                       {"1/2", "not a formula"},
                                                       {"2^10", "not a formula"},
                                                       {"50 %", "write 0.5"},
                                                       {"True", "write true"},
                                                       {"no", "write false"}})
    EXPECT_TRUE(has(value_advice(value), advice)) << value << ": " << value_advice(value);
}

TEST(ValueAdvice, KnowsNothingOfOthers) {
  for (auto const* value : {"", "# 40,0", "1.5", "1e-3", "0", "0.5", "-3", "1_000", "\"40,0\"",
                            "CD_n", "[1, 2]", "inf", "1979-05-27", "0x10"})
    EXPECT_EQ(value_advice(value), "") << value;
  EXPECT_EQ(value_advice(std::string(1000000, '1') + ",0"), "");
}

TEST(ValueAdvice, StandsInTheMessagesOfScenes) {
  struct Case {
    char const *key, *line, *place, *words;
  };
  for (auto const& [key, line, place, words] : std::vector<Case>{
           {"strain", "strain = 40,0",
            "strain = 40,0 (a number has its decimals behind a point; write 40.0)", ""},
           {"strain", "strain = .5  # half", "strain = .5", "write 0.5"},
           {"elasticity", "elasticity = 010", "elasticity = 010", "write 10"},
           {"mass", "mass = 1.0",
            "disks.mass = 1.0 (must be one of \"equal\", \"area\", in quotes)", "m = 1"},
           {"strain_rate", "strain_rate = [1e-3, 1e-4]",
            "shear.strain_rate = an array (must be a number", "shear.protocol = \"cascade\""},
           {"strain_rate", "strain_rate = [1e-3, 1e-4]", "shear.strain_rate", "[sweep] grid"},
           {"elasticity", "elasticity = [1, 10]", "disks.elasticity",
            "[sweep] grid = { \"disks.elasticity\""},
           {"count", "count = [16, 32]", "disks.count", "[sweep] grid"},
           {"count", "count = 1e3", "disks.count", "write 1000"},
           {"count", "count = \"16\"", "disks.count", "without quotes"},
           {"strain", "strain = \"40,0\"", "shear.strain", "write 40.0"}}) {
    auto const message = refusal(with_line(minimal_text, key, line));
    EXPECT_TRUE(has(message, place)) << message;
    EXPECT_TRUE(has(message, words)) << message;
  }
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.strain=40,0"}), "write 40.0"));
  EXPECT_TRUE(has(refusal(minimal_text, {"disks.count=16,0"}), "write 16)"));
  EXPECT_TRUE(has(refusal(minimal_text, {"integration.time_step=0,1"}), "write 0.1"));
  EXPECT_TRUE(has(refusal(minimal_text, {"shear.discard=0,5"}), "write 0.5"));
  EXPECT_TRUE(has(refusal(minimal_text, {"output.plot=False"}), "write false"));
  EXPECT_FALSE(has(refusal(minimal_text, {"disks.count=True"}), "write true"));
}

}  // namespace
}  // namespace bagnold
