// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/cpu/steps/block_stepper.hpp"
#include "src/config/scene.hpp"
#include "src/engine/ensemble/ensemble.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// What is compiled for each law, in a source file of its own.
struct LawEngines {
  std::string_view name;  ///< of the law

  /// The step on blocks of the scene's scheme.
  std::unique_ptr<BlockStepper> (*stepper)(Scene const&);

  /// The plain engine; nullptr if the build has no such backend.
  std::unique_ptr<Simulation> (*reference)(Scene const&, Snapshot const&,
                                           std::string const& backend);

  /// Systems that share launches; nullptr if the build has no such backend, or it is not a device.
  std::shared_ptr<Ensemble> (*ensemble)(Scene const&, std::vector<Snapshot> const&,
                                        std::string const& backend);
};

template <class Law>
LawEngines engines_of();

}  // namespace bagnold
