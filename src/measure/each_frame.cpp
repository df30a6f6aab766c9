// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/each_frame.hpp"

#include <algorithm>
#include <limits>

namespace bagnold {

namespace {

constexpr char const* frames_table = "ramp_frames";
constexpr std::size_t frame_columns = 3;

void append(std::vector<double>& to, std::vector<double> const& values) {
  to.insert(to.end(), values.begin(), values.end());
}

}  // namespace

std::size_t EachFrame::frames() const { return frames_.size() / frame_columns; }

FrameResults EachFrame::found_now() const {
  FrameResults found;
  observer_->report({observer_.get()}, found);
  return found;
}

void EachFrame::add(Frame const& frame) {
  observer_->add(frame);
  auto const found = found_now();
  for (auto const& one : found.histograms) append(histograms_[one.name], one.density);
  for (auto const& one : found.profiles) append(profiles_[one.name], one.value);
  observer_->forget_before(std::numeric_limits<double>::infinity());
  auto const window = std::min(frame.step, plan_.steps - 1) / plan_.window_steps;
  append(frames_, {frame.strain, frame.state.strain_rate.value(),
                   static_cast<double>(plan_.direction(window))});
}

void EachFrame::save(ObserverState& numbers) {
  observer_->save(numbers);
  numbers[name_ + "_frames"] = frames_;
  for (auto const& [table, rows] : histograms_) numbers[name_ + "_histogram_" + table] = rows;
  for (auto const& [table, rows] : profiles_) numbers[name_ + "_profile_" + table] = rows;
}

void EachFrame::load(ObserverState const& numbers) {
  observer_->load(numbers);
  frames_ = numbers.at(name_ + "_frames");
  if (frames_.empty()) return;
  auto const names = found_now();
  for (auto const& one : names.histograms)
    histograms_[one.name] = numbers.at(name_ + "_histogram_" + one.name);
  for (auto const& one : names.profiles)
    profiles_[one.name] = numbers.at(name_ + "_profile_" + one.name);
}

void EachFrame::report(std::vector<FrameObserver const*> const& systems,
                       FrameResults& results) const {
  std::size_t frames = this->frames();  // shown to all systems
  for (auto const* system : systems)
    frames = std::min(frames, dynamic_cast<EachFrame const&>(*system).frames());
  if (frames == 0) return;
  std::vector<std::size_t> axes{frames};
  if (systems.size() > 1) axes.insert(axes.begin(), systems.size());
  auto const rows_of = [&](Rows EachFrame::*rows, std::string const& table) {
    std::vector<double> all;
    for (auto const* system : systems) {
      auto const& of = dynamic_cast<EachFrame const&>(*system);
      auto const& values = (of.*rows).at(table);
      auto const each = values.size() / of.frames();
      all.insert(all.end(), values.begin(),
                 values.begin() + static_cast<std::ptrdiff_t>(frames * each));
    }
    return all;
  };
  auto tables = found_now();  // of no frame
  for (auto& one : tables.histograms) {
    one.density = rows_of(&EachFrame::histograms_, one.name);
    one.frames = axes;
    results.histograms.push_back(std::move(one));
  }
  for (auto& one : tables.profiles) {
    one.value = rows_of(&EachFrame::profiles_, one.name);
    one.frames = axes;
    results.profiles.push_back(std::move(one));
  }
  bool const told = std::ranges::any_of(results.samples,
                                        [](auto const& one) { return one.name == frames_table; });
  if (told) return;
  results.samples.push_back(
      {frames_table,
       "frames of the ramp that histograms and profiles have an axis for",
       {"strain [1]", "strain_rate [1/tau_e]", "direction [1]"},
       {frames_.begin(), frames_.begin() + static_cast<std::ptrdiff_t>(frames * frame_columns)}});
}

}  // namespace bagnold
