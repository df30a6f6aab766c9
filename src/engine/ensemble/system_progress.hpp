// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/species.hpp"
#include "src/engine/clock.hpp"

/// Messages between host and device about the systems of an ensemble.
namespace bagnold {

/// Constants of one system of an ensemble.
struct SystemConstants {
  Clock clock;
  std::int64_t rate_end;  ///< step up to which it is valid
  int columns, rows;      ///< of its cells
};

/// Progress of a system, and what it waits for.
struct SystemProgress {
  enum class List { lost, missing, stands };                              ///< lost: to be built
  enum class Wait { none, for_samples, for_entries, too_fast, unsound };  ///< last two: final

  std::int64_t step = 0;
  ShearMark list_mark;  ///< of the list's build
  std::int64_t list_builds = 0;
  Real factor = 1;  ///< of the strain rate, by which motions are to be scaled
  List list = List::lost;
  Wait wait = Wait::none;
  std::int32_t samples = 0;                             ///< measured since the host took them
  std::uint32_t entries = 0;                            ///< neighbours in its list, or wanted
  Kokkos::ValLocScalar<Real, std::int64_t> farthest{};  ///< |w|^2 of a disk too fast, [d_s^2]
};

/// Forces, masses and lists of all systems.
template <ContactLaw Law>
struct EnsembleRules {
  Law law;
  SpeciesTable table;
  Real skin;  ///< [d_s]
};

}  // namespace bagnold
