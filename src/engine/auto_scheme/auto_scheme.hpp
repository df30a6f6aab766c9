// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "src/config/ladder.hpp"
#include "src/engine/engine_memory.hpp"
#include "src/engine/simulation.hpp"

namespace bagnold {

/// scheme = "auto": steps by one of the methods of a ladder, which take_method() changes.
///
/// It begins with the usual method. Steps are those of the run, whole ones of each method. It stops
/// at every multiple of the ladder's grid, and there the method may change: what one engine hands
/// over to the other is the state. A method of longer steps evaluates as many of its own steps
/// apart as others do, and quasi-static steps are all evaluated, so that windows hold different
/// numbers of configurations.
class AutoScheme : public Simulation {
 public:
  /// Makes the engine of a method that continues from a snapshot.
  using Make = std::function<std::unique_ptr<Simulation>(Method const&, Snapshot&&)>;

  AutoScheme(Ladder ladder, Snapshot&& snapshot, Make make);

  int columns() const override { return engine_->columns(); }
  std::int64_t step() const override { return run_steps(engine_->step()); }
  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override;
  Snapshot snapshot() const override;
  void give_back_scratch() override { engine_->give_back_scratch(); }
  State state() const override { return engine_->state(); }

  bool has_step() const override { return engine_->has_step(); }
  std::size_t method() const override { return method_; }
  void take_method(std::size_t method) override;

 private:
  Method const& present() const { return ladder_.methods[method_]; }
  std::int64_t run_steps(std::int64_t own) const {
    return own * present().length / present().parts;
  }
  std::int64_t own_steps(std::int64_t of_run) const;
  void step_to(std::int64_t stop, Sampling const& sampling, OpenWindows& windows);

  template <class Visit>
  void for_each_memory(Visit const& visit);
  template <class Visit>
  void for_each_counter(Visit const& visit);

  Ladder ladder_;
  Make make_;
  std::size_t method_;
  std::unique_ptr<Simulation> engine_;
  Counters counters_;  ///< of the engines before the present one
  /// Steps of the run that implicit damping and quasi-static steps took, and that were divided.
  std::int64_t implicit_steps_ = 0, quasi_static_steps_ = 0, finer_steps_ = 0;
};

}  // namespace bagnold
