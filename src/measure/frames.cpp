// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/frames.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace bagnold {

bool Frames::Observed::waits(std::int64_t from, std::int64_t to) const {
  return to >= first_step.value_or(0) && (from < 0 || to / spacing > from / spacing);
}

void Frames::add_observer(std::unique_ptr<FrameObserver> observer, std::int64_t spacing,
                          std::optional<std::int64_t> first_step) {
  observed_.push_back({std::move(observer), spacing, first_step});
}

std::int64_t Frames::next(std::int64_t step) const {
  auto next = std::numeric_limits<std::int64_t>::max();
  for (auto const& w : observed_) next = std::min(next, (step / w.spacing + 1) * w.spacing);
  return next;
}

template <class Wanted>
void Frames::show_to(Simulation const& simulation, Wanted const& wanted) {
  if (std::ranges::none_of(observed_, wanted)) return;
  auto const step = simulation.step();
  State const state = simulation.state();
  bool const controlled = plan_.control_steps > 0;  // strain is known as the run goes
  Frame const frame{state, step, controlled ? simulation.strain() : plan_.strain(step)};
  for (auto const& w : observed_)
    if (wanted(w)) w.observer->add(frame);
}

void Frames::show(Simulation const& simulation, std::int64_t from) {
  auto const step = simulation.step();
  show_to(simulation, [&](Observed const& w) { return w.waits(from, step); });
}

void Frames::know_contacts(std::shared_ptr<ContactRecord const> const& record) {
  for (auto const& w : observed_) w.observer->know_contacts(record);
}

void Frames::begin() {
  for (auto const& w : observed_) w.observer->begin();
}

void Frames::finish() {
  for (auto const& w : observed_) w.observer->finish();
}

void Frames::tidy() {
  for (auto const& w : observed_) w.observer->tidy();
}

ObserverState Frames::save() {
  ObserverState numbers;
  for (auto const& w : observed_) w.observer->save(numbers);
  return numbers;
}

void Frames::load(ObserverState const& numbers) {
  for (auto const& w : observed_) w.observer->load(numbers);
}

void Frames::forget_before(std::int64_t step) {
  for (auto& w : observed_) {
    if (!w.first_step) continue;
    w.first_step = std::max(*w.first_step, step);
    w.observer->forget_before(plan_.strain(step));
  }
}

void Frames::show_first_again(Simulation const& simulation) {
  auto const step = simulation.step();
  show_to(simulation, [&](Observed const& w) {
    return w.observer->adds_up() && w.first_step == step && step % w.spacing == 0;
  });
}

std::vector<std::string> Frames::lost() const {
  std::vector<std::string> all;
  for (auto const& w : observed_)
    if (auto words = w.observer->lost(); !words.empty()) all.push_back(std::move(words));
  return all;
}

std::vector<FrameObserver const*> Frames::observers(std::vector<Frames const*> const& systems,
                                                    std::size_t which) {
  std::vector<FrameObserver const*> of_each;
  for (Frames const* frames : systems) of_each.push_back(frames->observed_[which].observer.get());
  return of_each;
}

FrameResults Frames::join(std::vector<Frames const*> const& systems) {
  FrameResults results;
  for (std::size_t k = 0; k < systems.front()->observed_.size(); ++k) {
    auto const of_each = observers(systems, k);
    of_each.front()->report(of_each, results);
  }
  return results;
}

std::vector<SampledObservable> Frames::observables(std::vector<Frames const*> const& systems) {
  std::vector<SampledObservable> all;
  for (std::size_t k = 0; k < systems.front()->observed_.size(); ++k)
    std::ranges::move(joined_observables(observers(systems, k)), std::back_inserter(all));
  return all;
}

std::vector<SampledObservable> joined_observables(
    std::vector<FrameObserver const*> const& systems) {
  auto all = systems.front()->observables();
  for (auto system = systems.begin() + 1; system != systems.end(); ++system) {
    auto const other = (*system)->observables();
    for (std::size_t k = 0; k < all.size(); ++k) all[k].samples.push_back(other[k].samples.front());
  }
  return all;
}

}  // namespace bagnold
