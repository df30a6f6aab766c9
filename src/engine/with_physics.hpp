// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <type_traits>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/schemes/schemes.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/errors.hpp"
#include "src/config/names.hpp"
#include "src/engine/engine_input.hpp"

namespace bagnold {

/// Names of the schemes that can step a law.
template <ContactLaw Law>
Names schemes_for() {
  Names names;
  for_each_type<Schemes>([&]<class S>(std::type_identity<S>) {
    if (S::template can_step<Law>) names.push_back(S::name);
  });
  return names;
}

/// Calls use(law, repulsion, scheme) with the constants of an input, for one law; scheme: a value
/// of its type. Throws InputError if the scheme cannot step the law.
template <ContactLaw Law, class Use>
auto with_physics_of(PhysicsInput const& input, Use const& use) {
  auto const law = Law::make(input.damping);
  auto const under = [&](auto scheme) {
    return with_repulsion(input.force_exponent,
                          [&](auto const& repulsion) { return use(law, repulsion, scheme); });
  };
  using Made = decltype(under(ModifiedVelocityVerlet{}));
  return with_named<Schemes>(input.scheme, [&]<class S>(std::type_identity<S>) -> Made {
    if constexpr (S::template can_step<Law>)
      return under(S{});
    else
      throw InputError(fmt::format(
          "integration.scheme = \"{}\" ({} cannot do model {}, whose {}); set integration.scheme = "
          "{}",
          input.asked_scheme, S::name, Law::name, S::cannot_step, choice(schemes_for<Law>())));
  });
}

}  // namespace bagnold
