// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "src/engine/auto_scheme/scheme_choice.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// scheme = "auto": two stages, and implicit damping where SchemeChoice finds it as accurate.
///
/// Steps are those of two stages; a step of implicit damping is `length` of them long
/// (implicit_step_length()). Schemes change only at multiples of a stretch. The sums of a stretch
/// of implicit damping are held back until its end and added if it is kept. Otherwise two stages
/// step it again from its start. A configuration that implicit damping evaluates counts as `length`
/// evaluations of two stages.
class AutoScheme : public Simulation {
 public:
  /// Makes an engine that continues from a snapshot.
  using Make = std::function<std::unique_ptr<Simulation>(Snapshot&&)>;

  /// Engines of both schemes, and facts on the run.
  struct Engines {
    Make two_stages, implicit;
    std::int64_t length;  ///< of an implicit step, [steps]
    std::int64_t every;   ///< steps between configurations that are evaluated
    double strain_rate;   ///< [1/tau_e]
    double time_step;     ///< of two stages, [tau_e]
  };

  AutoScheme(Engines engines, Snapshot&& snapshot);

  int columns() const override { return engine_->columns(); }
  std::int64_t step() const override;
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  Snapshot snapshot() const override;
  void give_back_scratch() override { engine_->give_back_scratch(); }
  State state() const override { return engine_->state(); }

 private:
  /// Least implicit steps of a stretch, and configurations evaluated in it.
  static constexpr std::int64_t least_steps = 160, least_samples = 16;

  void change_to_implicit();
  void change_to_two_stages();
  void go_back(Snapshot&& kept);
  void step_by_two_stages(std::int64_t begin, std::int64_t end, Sampling const& sampling,
                          OpenWindows& windows);
  void try_stretch(Sampling const& sampling, OpenWindows& windows);
  bool step_stretch(Sampling const& sampling, OpenWindows& held);

  template <class Visit>
  void for_each_memory(Visit const& visit);
  template <class Visit>
  void for_each_counter(Visit const& visit);

  std::unique_ptr<Simulation> make(Snapshot&& from) const {
    return (is_implicit_ ? engines_.implicit : engines_.two_stages)(std::move(from));
  }

  Engines engines_;
  std::int64_t stretch_;  ///< [steps]
  std::unique_ptr<Simulation> engine_;
  bool is_implicit_ = false;  ///< which engine that is
  SchemeChoice choice_;
  std::int64_t implicit_steps_ = 0;  ///< steps that implicit damping took, in steps of two stages
  std::int64_t refused_ = 0;         ///< stretches
};

}  // namespace bagnold
