// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/device/neighbors/neighbor_search.hpp"
#include "kernels/physics/sums/sums.hpp"
#include "src/engine/blocks/make_block_engine.hpp"
#include "src/engine/engine_input.hpp"
#include "src/engine/ensemble/ensemble.hpp"
#include "src/engine/simulation.hpp"
#include "src/state/frame_contact.hpp"

namespace bagnold {

/// Search in a state on one thread of the host, as for frames.
using HostSearch = NeighborSearch<Kokkos::Serial>;

/// Functions compiled for each law, in a source file of its own.
struct LawEngines {
  std::string_view name;  ///< of the law

  /// Step of the scheme of an input on blocks.
  MakeStepper stepper;

  /// The plain engine; nullptr if the build has no such backend.
  std::unique_ptr<Simulation> (*reference)(EngineInput const&, Snapshot const&,
                                           std::string const& backend);

  /// Systems that share launches; nullptr if the build has no such backend, or it is not a device.
  std::shared_ptr<Ensemble> (*ensemble)(EngineInput const&, std::vector<Snapshot> const&,
                                        std::string const& backend);

  /// Contribution of each disk to the sums over pairs, in the step that begins at a state, see
  /// src/measure/disk_stress.hpp. search: finds all pairs that touch.
  std::vector<Sums<false>> (*disk_sums)(EngineInput const&, State const&, HostSearch const& search);

  /// Contacts of a state, by i, then j, of unknown age. search: finds all pairs that touch.
  FrameContacts (*contacts)(EngineInput const&, State const&, HostSearch const& search);
};

template <class Law>
LawEngines engines_of();

/// Functions of a law by its name: of the list in kernels/physics/laws/laws.hpp, or registered.
LawEngines const& engines_for(std::string_view model);

/// Registers a law (register_law.hpp), under a name that is not taken.
void register_engines(LawEngines const& added);

}  // namespace bagnold
