// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// SIGUSR1 asks for a checkpoint; SIGINT and SIGTERM ask to stop with one; a second of these quits
/// at once with 128 + its number, except in a point of a sweep.
void catch_signals();

/// Was a checkpoint asked for since the last call?
bool checkpoint_requested();

/// The signal that asked to stop; 0: none.
int stop_signal();

}  // namespace bagnold
