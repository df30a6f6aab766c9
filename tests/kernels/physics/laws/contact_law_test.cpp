// SPDX-License-Identifier: BSD-3-Clause
//
// What a law must say of itself: each fact missing is missed.
#include <gtest/gtest.h>

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"

namespace bagnold::test {
namespace {

/// A whole law, that is not linear and has no constants: it needs none.
struct Whole {
  static constexpr std::string_view name = "whole";
  static constexpr bool rotates = false;
  static constexpr bool linear = false;
  static constexpr bool separate_constants = false;
  Real damping;

  static Whole make(DampingInput const& input) { return {1 / input.elasticity}; }
  static Real paper_time_step(Real elasticity) { return time_step_of_p2(elasticity); }

  template <class T>
  KOKKOS_FUNCTION Vec2<T> dissipative_force(Contact<T> const& c) const {
    return T(-damping) * dot(c.velocity, c.velocity) * c.velocity;
  }
};
static_assert(is_contact_law<Whole>());
static_assert(!TwoStageLaw<Whole>);

/// A law whose parts are hidden one at a time, as private members of a class derived from it.
struct Nameless : Whole {
  static Nameless make(DampingInput const& input) { return {Whole::make(input)}; }

 private:
  using Whole::name;
};
struct NotMade : Whole {};  // Whole::make makes another law
struct PaperLess : Whole {
  static PaperLess make(DampingInput const& input) { return {Whole::make(input)}; }

 private:
  using Whole::paper_time_step;
};
struct SilentOnSpins : Whole {
  static SilentOnSpins make(DampingInput const& input) { return {Whole::make(input)}; }

 private:
  using Whole::rotates;
};
struct SilentOnLinearity : Whole {
  static SilentOnLinearity make(DampingInput const& input) { return {Whole::make(input)}; }

 private:
  using Whole::linear;
};
struct Forceless : Whole {
  static Forceless make(DampingInput const& input) { return {Whole::make(input)}; }

 private:
  using Whole::dissipative_force;
};
static_assert(!ContactLaw<Nameless>);
static_assert(!ContactLaw<NotMade>);
static_assert(!ContactLaw<PaperLess>);
static_assert(!ContactLaw<SilentOnSpins>);
static_assert(!ContactLaw<SilentOnLinearity>);
static_assert(!ContactLaw<Forceless>);

/// Linear, it must tell its constants: k_n and k_t, and whether one weight is enough.
struct LinearWithoutConstants : Whole {
  static constexpr bool linear = true;
  static LinearWithoutConstants make(DampingInput const& input) { return {Whole::make(input)}; }
};
struct LinearButSilentOnOneConstant : LinearWithoutConstants {
  static LinearButSilentOnOneConstant make(DampingInput const&) { return {}; }
  Real normal_damping() const { return damping; }
  Real tangential_damping() const { return 2 * damping; }
};
struct LinearWithTwoConstants : LinearButSilentOnOneConstant {
  static constexpr bool one_constant = false;
  static LinearWithTwoConstants make(DampingInput const&) { return {}; }
};
struct RollsWithTwoConstants : LinearWithTwoConstants {
  static constexpr bool rotates = true;
  static RollsWithTwoConstants make(DampingInput const&) { return {}; }
};
static_assert(!ContactLaw<LinearWithoutConstants>);
static_assert(!ContactLaw<LinearButSilentOnOneConstant>);
static_assert(ContactLaw<LinearWithTwoConstants> && !TwoStageLaw<LinearWithTwoConstants>);
static_assert(TwoStageLaw<RollsWithTwoConstants>);

static_assert(ModifiedVelocityVerlet::can_step<Whole> && !TwoStageLeapfrog::can_step<Whole>);
static_assert(!RepulsionLaw<Whole> && !SteppingScheme<Whole>);

/// P1 and P2 Eqs. (6), (9): constants are k_d = 1/Q times those of the input.
TEST(Laws, AreMadeFromTheInput) {
  for_each_type<Laws>([]<class Law>(std::type_identity<Law>) {
    auto const law = Law::make({4, 0.5, 3});
    EXPECT_EQ(law.normal_damping(), Law::separate_constants ? 0.125 : 0.25) << Law::name;
    double const expected = std::is_same_v<Law, CDn> ? 0 : Law::separate_constants ? 0.75 : 0.25;
    EXPECT_EQ(law.tangential_damping(), expected) << Law::name;
  });
}

/// The stiffness is the slope of the force: k_e = 1, d_ij = 1.
TEST(Repulsions, StiffnessIsTheSlopeOfTheForce) {
  for_each_type<Repulsions>([]<class R>(std::type_identity<R>) {
    auto const force = [](Real overlap) {
      return R{}.magnitude(Contact<Real>{{1, 0}, {}, overlap, 1});
    };
    for (Real const overlap : {0.01, 0.2}) {
      Real const slope = (force(overlap + 1e-5) - force(overlap - 1e-5)) / 2e-5;
      EXPECT_NEAR(R::stiffness(overlap), slope, 1e-6) << R::name;
    }
  });
}

}  // namespace
}  // namespace bagnold::test
