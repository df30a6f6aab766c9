// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/ensemble/ensemble.hpp"

#include <algorithm>
#include <stdexcept>

namespace bagnold {

namespace {

class Member final : public Simulation {
 public:
  Member(std::shared_ptr<Ensemble> ensemble, std::size_t system)
      : ensemble_(std::move(ensemble)), system_(system), step_(ensemble_->step(system)) {}

  int columns() const override { return ensemble_->columns(); }
  std::int64_t step() const override { return step_; }

  void advance(std::int64_t steps, Sampling const& sampling, OpenWindows& windows) override {
    if (windows.contacts) throw std::logic_error("members of an ensemble report no contacts");
    ensemble_->advance(std::min(step_ + steps, sampling.last_step), sampling);
    step_ = ensemble_->step(system_);
    ensemble_->take_samples(system_, windows);
  }

  Snapshot snapshot() const override {
    if (step_ != ensemble_->step(system_))
      throw std::logic_error("other members of the ensemble have taken this one along");
    return ensemble_->snapshot(system_);
  }

  State state() const override { return ensemble_->state(system_); }

 private:
  std::shared_ptr<Ensemble> ensemble_;
  std::size_t system_;
  std::int64_t step_;  ///< up to which samples were taken
};

}  // namespace

std::vector<std::unique_ptr<Simulation>> members_of(std::shared_ptr<Ensemble> const& ensemble) {
  std::vector<std::unique_ptr<Simulation>> members;
  for (std::size_t s = 0; s < ensemble->systems(); ++s)
    members.push_back(std::make_unique<Member>(ensemble, s));
  return members;
}

}  // namespace bagnold
