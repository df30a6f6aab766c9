// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// Makes SIGUSR1 ask for a checkpoint; before there is a run the signal does nothing. To be called
/// before anything else: by default the signal ends a program.
void catch_checkpoint_signal();

/// Makes SIGINT, SIGTERM and, unless it is ignored (nohup), SIGHUP ask to stop with a checkpoint. A
/// second SIGINT, or a SIGINT or SIGTERM a second after the first, quits at once with 128 + its
/// number, except in a point of a sweep. Batch systems send two signals within milliseconds: these
/// count as one.
void catch_signals();

/// True if a checkpoint was asked for since the last call.
bool checkpoint_requested();

/// Signal that asked to stop; 0 if none did.
int stop_signal();

}  // namespace bagnold
