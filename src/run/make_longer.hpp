// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/io/checkpoint.hpp"
#include "src/run/run_folder.hpp"

/// A run that continues beyond its strain, with the bits of one that was as long from its start.
///
/// Its last checkpoint is before a lookahead that the end of the run cut short (LegEnd::whole). The
/// steps to that end are done again, and the window that the end cut short is open again.
namespace bagnold {

/// Scene with this strain; of a cascade at its last rate. Unchanged if it has that strain already.
/// InputError if it has more, or is a ramp's. `folder` is for messages.
Scene with_strain(Scene scene, double strain, std::string const& folder);

/// True if `after` is `before` with more shear.strain and no other change.
bool is_longer(Scene const& before, Scene const& after);

/// Factor by which a run has to be made longer at least, for histograms hold frames that a shorter
/// one would discard; 1 where any length will do.
double least_lengthening(Scene const& scene);

/// A run that is to be made longer, before and after.
struct Longer {
  Scene before, after;
  Plan plan_before, plan_after;

  /// Makes the plans of two scenes of one run. InputError if `after` is more than can be run.
  Longer(Scene before, Scene after);

  bool discards_more() const { return plan_before.first_step() != plan_after.first_step(); }

  /// Throws InputError where histograms hold frames that the longer run would discard, and others
  /// that it would keep.
  void refuse_mixed_frames(io::Checkpoint const& from) const;

  /// Opens the window again that the end cut short.
  void reopen_last_window(io::SystemCheckpoint& system) const;

  /// Remarks on results that depend on the length, a line each.
  std::vector<std::string> remarks(io::Checkpoint const& from) const;
};

/// Throws InputError where the run in a folder cannot be made longer.
void refuse_longer(RunFolder const& folder, Scene const& after);

/// Prepares a folder of one run for go_on_in() with the longer scene: checks, then removes the
/// files that only a finished run has, and writes scene.toml. A kill during this leaves the run as
/// it was, unfinished, or longer. Throws InputError.
void make_longer(RunFolder const& folder, Scene const& after);

/// Removes the files that only a finished run has: summary, last state, pictures.
void drop_results(RunFolder const& folder);

}  // namespace bagnold
