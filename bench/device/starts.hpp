// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/config/scene.hpp"
#include "src/state/snapshot.hpp"

namespace bagnold::bench {

/// How disks lie in memory at the start: as in the file, in random order, or by cells of the box
/// along a Z-order curve.
inline constexpr char const* orders[] = {"start", "shuffled", "cells"};

/// A start for each replica, from the state file of a scene: the first as it is, the others with
/// each disk moved by up to 1e-9 d_s.
std::vector<Snapshot> starts(Scene const& scene, std::string const& order);

}  // namespace bagnold::bench
