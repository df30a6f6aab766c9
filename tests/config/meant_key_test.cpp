// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/meant_key.hpp"

#include <gtest/gtest.h>

#include "tests/config/scenes.hpp"

namespace bagnold {
namespace {

TEST(MeantKey, KnowsWhatPeopleComeWith) {
  struct Case {
    char const *word, *key;
  };
  for (auto const& [word, key] : std::vector<Case>{{"dt", "integration.time_step"},
                                                   {"timestep", "integration.time_step"},
                                                   {"integration.dt", "integration.time_step"},
                                                   {"N", "disks.count"},
                                                   {"disks.n", "disks.count"},
                                                   {"number_of_particles", "disks.count"},
                                                   {"phi", "disks.packing_fraction"},
                                                   {"volume_fraction", "disks.packing_fraction"},
                                                   {"disks.phi", "disks.packing_fraction"},
                                                   {"gammadot", "shear.strain_rate"},
                                                   {"gamma_dot", "shear.strain_rate"},
                                                   {"shear.rate", "shear.strain_rate"},
                                                   {"shear_rate", "shear.strain_rate"},
                                                   {"gamma", "shear.strain"},
                                                   {"confining_pressure", "shear.pressure"},
                                                   {"shear_stress", "shear.stress"},
                                                   {"sigma", "shear.stress"},
                                                   {"gamma_0", "shear.amplitude"},
                                                   {"shear.pieces_per_cycle", "shear.cycle_pieces"},
                                                   {"n_cycles", "shear.cycles"},
                                                   {"Q", "disks.elasticity"},
                                                   {"restart", "start.file"},
                                                   {"seed", "disks.seed"},
                                                   {"strian", "shear.strain"},
                                                   {"shear.strain_rte", "shear.strain_rate"},
                                                   {"output.seed", "disks.seed"},
                                                   {"mesure.evry", "measure.every"}}) {
    auto const meant = meant_key(word);
    EXPECT_EQ(meant.key, key) << word;
    EXPECT_EQ(meant.remark, "; did you mean " + std::string(key) + "?") << word;
  }
}

TEST(MeantKey, SaysWhyThereIsNone) {
  struct Case {
    char const *word, *why;
  };
  for (auto const& [word, why] : std::vector<Case>{{"friction", "no friction"},
                                                   {"disks.friction", "no friction"},
                                                   {"mu", "mu = sigma/p is measured"},
                                                   {"steps", "as long as its shear.strain"},
                                                   {"nsteps", "as long as its shear.strain"},
                                                   {"omega", "shear.period"},
                                                   {"shear.frequency", "2 pi/omega"},
                                                   {"k_n", "k_e = 1"},
                                                   {"disks.damping", "disks.elasticity"},
                                                   {"restitution", "k_d = 1/Q"},
                                                   {"L", "disks.box_aspect"},
                                                   {"radius", "the diameter 1, half 1.4"},
                                                   {"gravity", "there is none"},
                                                   {"threads", "--threads"}}) {
    auto const meant = meant_key(word);
    EXPECT_EQ(meant.key, "") << word;
    EXPECT_TRUE(has(meant.remark, why)) << word << meant.remark;
  }
}

TEST(MeantKey, WhatNobodyKnowsIsLikeNothing) {
  for (auto const* word : {"xyzzy", "disks.frobnicate", "shear.banana"}) {
    EXPECT_EQ(meant_key(word).key, "") << word;
    EXPECT_TRUE(has(meant_key(word).remark, "inputs/reference.toml")) << word;
  }
}

TEST(MeantKey, OfTables) {
  EXPECT_EQ(meant_table("disk", {"disks", "shear"}).key, "disks");
  EXPECT_EQ(meant_table("particles", {"disks", "shear"}).key, "disks");
  EXPECT_EQ(meant_table("xyzzy", {"disks", "shear"}).remark, "; there are disks, shear");
}

/// A key that is there is never another's name.
TEST(MeantKey, EveryKeyIsItself) {
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) {
    EXPECT_EQ(meant_key(std::string(key.name)).key, key.name);
    auto const part = std::string(key.name.substr(key.name.rfind('.') + 1));
    EXPECT_EQ(meant_key(part).key.substr(meant_key(part).key.rfind('.') + 1), part);
  });
}

}  // namespace
}  // namespace bagnold
