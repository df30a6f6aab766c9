// SPDX-License-Identifier: BSD-3-Clause
//
// A drive that is not in the program's list: known once registered, and run as the others are.
#include <gtest/gtest.h>

#include "kernels/physics/drives/thermal_bath.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/engine/register_drive.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// A bath under another name: must have its bits.
struct CopiedDrive : ThermalBath {
  static constexpr std::string_view name = "copy of thermal";
  static CopiedDrive make(DriveInput const& input) { return {ThermalBath::make(input)}; }
};
static_assert(OneBodyDrive<CopiedDrive>);

Scene parse(std::string_view kind) {
  return parse_scene(
      "[disks]\nmodel = \"CD_rot\"\ncount = 200\npacking_fraction = 0.78\nelasticity = 2\n"
      "mass = \"equal\"\n[shear]\nstrain_rate = 1e-3\nstrain = 1\n[drive]\ndrag = 0.1\n"
      "temperature = 1e-4\nkind = \"" +
          std::string(kind) + "\"\n",
      "scene", {});
}

TEST(OwnDrive, HasTheBitsOfTheProgramsDriveInEveryEngineByEveryScheme) {
  EXPECT_THROW(parse(CopiedDrive::name), InputError);
  register_drive<CopiedDrive>();
  EXPECT_THROW(register_drive<CopiedDrive>(), InputError);
  EXPECT_THROW(register_drive<ThermalBath>(), InputError);
  Scene listed = parse("thermal"), own = parse(CopiedDrive::name);
  auto const start = shaken_start(listed);
  for (auto const scheme : explicit_schemes())
    for (std::string const engine : {"reference", "many-contacts"})
      for (auto const& backend : backend_names()) {
        for (Scene* scene : {&listed, &own}) {
          scene->integration.scheme = scheme;
          scene->integration.engine = engine;
        }
        auto const one = simulate(listed, start, backend), other = simulate(own, start, backend);
        EXPECT_EQ(advance(*one, 300, 10).sums, advance(*other, 300, 10).sums) << engine;
        EXPECT_EQ(one->state().position, other->state().position) << engine << scheme;
        EXPECT_EQ(one->state().spin, other->state().spin) << engine << scheme;
      }
}

}  // namespace
}  // namespace bagnold::test
