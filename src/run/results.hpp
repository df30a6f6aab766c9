// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/config/plan.hpp"
#include "src/config/scene.hpp"
#include "src/measure/observables.hpp"
#include "src/run/bias/course.hpp"
#include "src/run/run_folder.hpp"
#include "src/run/run_measured.hpp"
#include "src/start/mean_motion.hpp"
#include "src/statistics/replicas.hpp"

namespace bagnold {

/// One system of a run, as output.
struct Replica {
  double initial_time = 0.0;  ///< at step 0, [tau_e]
  double box_length = 0.0;    ///< where this process took it up, [d_s]
  std::map<std::string, double> start_record;
  std::map<std::string, double> engine;  ///< its counters and choices at the last checkpoint
  std::optional<ObserverState>
      saved_frames;                        ///< of the checkpoint it goes on from; none: it begins
  std::vector<double> saved_control = {};  ///< what a controller remembers; of the same checkpoint
  std::vector<double> saved_pairs = {};    ///< of measure.bias; of the same checkpoint
  bool discards_more = false;  ///< than at the checkpoint: the run was made longer since
  std::optional<MeanMotion> end_motion = {};  ///< of all disks together, once it is done
  Measurement measurement;
};

/// A run, as output.
struct Run {
  Scene scene;  ///< resolved
  Plan plan;
  double box_length = 0.0;  ///< L_x, [d_s]
  std::vector<Replica> replicas;
  std::string backend;
  double wall_seconds = 0.0;  ///< of stepping, resumes included
  bool steady_found = true;   ///< by shear.discard = "auto"; false: the middle was taken
  std::map<std::string, std::optional<double>>
      reached;                              ///< relative errors, of those with a target
  bool target_met = false;                  ///< by all of them, at this look and at the one before
  std::optional<bias::Findings> bias = {};  ///< of measure.bias, once it is done

  double box_height() const { return scene.disks.box_aspect * box_length; }  ///< L_y, [d_s]
  double box_area() const { return box_length * box_height(); }              ///< [d_s^2]
};

struct Warning;

/// An observable, its samples, and its estimate.
struct NamedEstimate : SampledObservable {
  statistics::ReplicaEstimate estimate;
  double sample_strain = 0;  ///< between samples
};

/// Mean and standard error of a function of averages over the measured windows. If the scene has a
/// target error, so that the run may have chosen its own end, it is the cautious error
/// (src/statistics/stopping.hpp).
statistics::ReplicaEstimate estimate(Run const& run, statistics::Function const& f);

/// Source of the error for several replicas, in words.
std::string errors_from(Run const& run);

/// Relative bias of the method in an observable and its standard error, as stated by measure.bias:
/// of p, sigma, Z, T_g, mu and what goes with them by a constant factor. None: not known.
std::optional<bias::Bias> bias_of(Run const& run, std::string_view name);

/// Mean and standard error of all observables, those of frames last.
std::vector<NamedEstimate> estimates(Run const& run);

/// Strain of the first windows, both signs added up, mean over the replicas.
double path_of(Run const& run, std::size_t windows);

/// Strain of a replica from step 0 to the end of each of its windows.
std::vector<double> strains_of(Run const& run, Replica const& replica);

/// A quantity in each window that all replicas have finished, averaged over them.
std::vector<double> window_series(Run const& run, Observable const& observable);

/// Writes the windows so far to result.h5, as a whole. Throws FileError.
void write_result_file(RunFolder const& folder, Run const& run);

/// Writes summary.json. Throws FileError.
void write_summary(RunFolder const& folder, Run const& run, std::vector<NamedEstimate> const& list,
                   std::vector<Warning> const& warnings);

}  // namespace bagnold
