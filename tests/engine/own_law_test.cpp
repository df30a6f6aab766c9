// SPDX-License-Identifier: BSD-3-Clause
//
// A law that is not in the program's list: known once registered, and run as the others are.
#include <gtest/gtest.h>

#include "src/config/abilities.hpp"
#include "src/config/errors.hpp"
#include "src/config/plan.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/stability.hpp"
#include "src/engine/register_law.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

/// CD_rot under another name: must have its bits.
struct CopiedLaw : CDrot {
  static constexpr std::string_view name = "copy of CD_rot";
  static CopiedLaw make(DampingInput const& input) { return {CDrot::make(input)}; }
};
static_assert(is_contact_law<CopiedLaw>());

/// Drag by the square of the normal velocity: no constants, and no two stages.
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr bool rotates = false;
  static constexpr bool linear = false;
  static constexpr bool separate_constants = true;
  Real damping;

  static Quadratic make(DampingInput const& input) { return {input.normal / input.elasticity}; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const approach = dot(c.velocity, c.normal);
    return T(-damping) * sqrt(approach * approach) * approach * c.normal;
  }
};

class OwnLaw : public testing::Test {
 public:
  static void SetUpTestSuite() {
    EXPECT_THROW(parse(CopiedLaw::name), InputError);
    register_law<CopiedLaw>();
    register_law<Quadratic>();
  }

  static Scene parse(std::string_view model, std::string const& more = "") {
    return parse_scene(
        "[disks]\nmodel = \"" + std::string(model) +
            "\"\ncount = 256\npacking_fraction = 0.78\nelasticity = 2\nmass = \"equal\"\n" + more +
            "\n[shear]\nstrain_rate = 1e-3\nstrain = 1\n",
        "scene", {});
  }

  /// Both scenes from one start, by every engine: state and sums are the same to the last bit.
  static void expect_same(Scene a, Scene b) {
    auto const start = shaken_start(a);
    for (std::string const engine : {"reference", "few-contacts", "many-contacts", "lookahead"}) {
      a.integration.engine = b.integration.engine = engine;
      if (!why_not(a).empty()) continue;  // no scheme for all disks at once by engines of some
      auto const one = simulate(a, start, backend_names().front());
      auto const other = simulate(b, start, backend_names().front());
      EXPECT_EQ(advance(*one, 400, 10).sums, advance(*other, 400, 10).sums) << engine;
      EXPECT_EQ(one->state().position, other->state().position) << engine;
      EXPECT_EQ(one->state().velocity, other->state().velocity) << engine;
      EXPECT_EQ(one->state().spin, other->state().spin) << engine;
    }
  }
};

TEST_F(OwnLaw, HasTheBitsOfTheProgramsLawInEveryEngineByEveryScheme) {
  for (auto const scheme : names_of<Schemes>()) {
    Scene listed = parse("CD_rot"), own = parse(CopiedLaw::name);
    listed.integration.scheme = own.integration.scheme = scheme;
    EXPECT_EQ(time_step(own), time_step(listed)) << scheme;
    EXPECT_EQ(make_plan(own).steps, make_plan(listed).steps) << scheme;
    EXPECT_EQ(contact_spectral_radius(own, 1.0), contact_spectral_radius(listed, 1.0)) << scheme;
    expect_same(listed, own);
  }
}

/// Spins and separate constants are asked of the law, not looked up by name.
TEST_F(OwnLaw, IsAskedWhatItIs) {
  EXPECT_TRUE(parse(CopiedLaw::name).rotates());
  EXPECT_THROW(parse(CopiedLaw::name, "damping_normal = 2"), InputError);
  EXPECT_FALSE(parse(Quadratic::name).rotates());
  EXPECT_EQ(parse(Quadratic::name, "damping_normal = 2").disks.damping_normal, 2);
  EXPECT_THROW(register_law<CDn>(), InputError);
}

/// A law that is not linear: refused by two stages, run by the papers' scheme in every engine.
TEST_F(OwnLaw, RunsByTheSchemesThatCanStepIt) {
  Scene scene = parse(Quadratic::name);
  auto const start = shaken_start(scene);
  EXPECT_THROW(simulate(scene, start, backend_names().front()), InputError);
  scene.integration.scheme = papers_scheme;
  for (std::string const engine : {"few-contacts", "many-contacts", "lookahead"}) {
    scene.integration.engine = engine;
    auto const simulation = simulate(scene, start, backend_names().front());
    expect_the_reference_engines(*simulation, scene, start, 200);
  }
}

}  // namespace
}  // namespace bagnold::test
