// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace bagnold {

/// SIGUSR1 asks for a checkpoint; before there is a run it changes nothing. To be called first of
/// all: it would end a program that does not know it.
void catch_checkpoint_signal();

/// SIGINT, SIGTERM and, unless it is ignored (nohup), SIGHUP ask to stop with a checkpoint. A
/// second SIGINT, or a SIGINT or SIGTERM a second after the first, quits at once with 128 + its
/// number, except in a point of a sweep. Machines ask twice within milliseconds: that is one wish.
void catch_signals();

/// Was a checkpoint asked for since the last call?
bool checkpoint_requested();

/// The signal that asked to stop; 0: none.
int stop_signal();

}  // namespace bagnold
