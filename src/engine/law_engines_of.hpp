// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifndef __CUDA_ARCH__  // of the host alone (cmake/host_only.cmake)
#include "src/engine/blocks/make_stepper.hpp"
#endif
#include "src/engine/backends.hpp"
#include "src/engine/compiled_once.hpp"
#include "src/engine/disk_sums.hpp"
#include "src/engine/drives/drive_engines.hpp"
#include "src/engine/ensemble/ensemble_engine.hpp"
#include "src/engine/frame_contacts.hpp"
#include "src/engine/law_engines.hpp"
#include "src/engine/reference/reference_engine.hpp"
#include "src/engine/with_physics.hpp"

namespace bagnold {

namespace detail {

/// Least number of disks whose memory is ordered by place: fewer fit into a cache.
inline constexpr std::size_t sorted_from = 4096;

/// Plan of launches. On a device 32 steps run without the host. Disks are ordered by place, except
/// with contacts or drives, which use the order of the start.
template <class Space>
LaunchPlan launch_plan(EngineInput const& input, Snapshot const& snapshot) {
  return {is_device<Space> ? 32 : 1,
          snapshot.state.count() > sorted_from && !input.contacts && !input.drive};
}

template <ContactLaw Law>
std::unique_ptr<Simulation> make_reference(EngineInput const& input, Snapshot const& snapshot,
                                           std::string const& backend) {
  using Made = std::unique_ptr<Simulation>;
  return with_physics_of<Law>(input.physics, [&]<class R, class S>(Law const& law, R const&, S) {
    return on_backend<Made>(backend, [&]<class Space>(std::type_identity<Space>) -> Made {
      return std::make_unique<ReferenceEngine<Law, R, Space, S>>(
          law, input.species, input.rates, input.time_step, input.skin, snapshot,
          make_device_drive<Law::rotates, Space>(input.drive), launch_plan<Space>(input, snapshot));
    });
  });
}

template <ContactLaw Law>
std::shared_ptr<Ensemble> make_ensemble(EngineInput const& input,
                                        std::vector<Snapshot> const& snapshots,
                                        std::string const& backend) {
  using Made = std::shared_ptr<Ensemble>;
  return with_physics_of<Law>(input.physics, [&]<class R, class S>(Law const& law, R const&, S) {
    return on_backend<Made>(backend, [&]<class Space>(std::type_identity<Space>) -> Made {
      if constexpr (is_device<Space>)
        return std::make_shared<EnsembleEngine<Law, R, Space, S>>(
            law, input.species, input.rates, input.time_step, input.skin, snapshots);
      else
        return static_cast<void>(snapshots), nullptr;
    });
  });
}

}  // namespace detail

/// To be instantiated once for each law.
template <class Law>
LawEngines engines_of() {
  return {Law::name,
          make_stepper<Law>,
          detail::make_reference<Law>,
          detail::make_ensemble<Law>,
          detail::disk_sums<Law>,
          detail::frame_contacts<Law>};
}

}  // namespace bagnold
