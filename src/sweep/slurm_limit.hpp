// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace bagnold::sweep {

/// Tasks that an array from 1 on may have, as `scontrol show config` tells: the largest index is
/// MaxArraySize - 1, and max_array_tasks of SchedulerParameters may allow fewer. 1000, Slurm's
/// default, where no controller answers.
std::int64_t most_array_tasks();

/// The same from what scontrol printed.
std::int64_t most_array_tasks(std::string const& config);

}  // namespace bagnold::sweep
