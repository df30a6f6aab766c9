// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace bagnold::sweep {

/// Most tasks of an array that begins at 1, from `scontrol show config`: the largest index is
/// MaxArraySize - 1, and max_array_tasks of SchedulerParameters may allow fewer. 1000, Slurm's
/// default, if no controller answers.
std::int64_t most_array_tasks();

/// Most tasks of an array, from the output of scontrol.
std::int64_t most_array_tasks(std::string const& config);

}  // namespace bagnold::sweep
