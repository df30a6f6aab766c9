// SPDX-License-Identifier: BSD-3-Clause
//
// Laws that two-stage damping cannot do are refused by name, not run.
#include "src/engine/with_physics.hpp"

#include "tests/support/typed.hpp"

namespace bagnold::test {
namespace {

/// Drag by the square of the normal velocity.
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static constexpr bool rotates = false;
  static constexpr bool linear = false;
  static constexpr bool separate_constants = false;
  Real damping;

  static Quadratic make(DampingInput const& input) { return {1 / input.elasticity}; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p1(elasticity); }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    T const approach = dot(c.velocity, c.normal);
    return T(-damping) * (approach < T(0) ? -approach : approach) * approach * c.normal;
  }
};

/// CD_nt without its spins: two weights, but room for one.
struct Sliding : CDnt {
  static constexpr std::string_view name = "sliding";
  static constexpr bool rotates = false;

  static Sliding make(DampingInput const& input) { return {CDnt::make(input)}; }
};

static_assert(ContactLaw<Quadratic> && !TwoStageLaw<Quadratic>);
static_assert(ContactLaw<Sliding> && !TwoStageLaw<Sliding>);

template <class... Law>
constexpr bool all_do_two_stages(std::tuple<Law...> const*) {
  return (TwoStageLaw<Law> && ...);
}
static_assert(all_do_two_stages(static_cast<Laws const*>(nullptr)));

constexpr auto as_it_is = [](auto const&, auto const&, auto scheme) {
  return decltype(scheme)::name;
};

template <class Law>
void expect_refusal(char const* scheme) {
  Scene scene;
  scene.integration.scheme = scheme;
  try {
    with_physics_of<Law>(physics_input(scene), as_it_is);
    FAIL() << Law::name << " is run with " << scheme;
  } catch (InputError const& error) {
    std::string const said = error.what();
    for (std::string_view word :
         {"integration.scheme", scheme, Law::name.data(), papers_scheme.data()})
      EXPECT_NE(said.find(word), std::string::npos) << word << " in: " << said;
  }
}

}  // namespace

TEST(WithScheme, ALawThatTwoStagesCannotDoIsRefused) {
  for (auto const* scheme : {"auto", two_stage_scheme.data()}) {
    expect_refusal<Quadratic>(scheme);
    expect_refusal<Sliding>(scheme);
  }
}

TEST(WithScheme, ThePapersSchemeDoesEveryLaw) {
  Scene scene;
  scene.integration.scheme = papers_scheme;
  EXPECT_EQ(with_physics_of<Quadratic>(physics_input(scene), as_it_is), papers_scheme);
  EXPECT_EQ(with_physics_of<Sliding>(physics_input(scene), as_it_is), papers_scheme);
  EXPECT_EQ(with_physics_of<CDrot>(physics_input(scene), as_it_is), papers_scheme);
}

TEST(WithScheme, TheLawsOfTheProgramDoTwoStages) {
  EXPECT_EQ(with_physics_of<CDnt>(physics_input(Scene{}), as_it_is), two_stage_scheme);
}

}  // namespace bagnold::test
