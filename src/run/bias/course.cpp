// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/course.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "src/config/collision_loss.hpp"
#include "src/config/time_step.hpp"

namespace bagnold::bias {

namespace {

constexpr std::array<std::size_t, 5> schedule = {4, 6, 9, 13, most_pairs};
constexpr std::size_t numbers_of_pair = 1 + 2 * Averages::count;

double loss_error(Scene const& coarse) {
  return collision_loss_error(coarse, scheme_of(coarse), time_step(coarse));
}

}  // namespace

Course::Course(Scene const& scene, std::size_t replicas)
    : tolerance_(scene.integration.accuracy), methods_(methods_of(scene)), of_(replicas) {
  collision_loss_error_ = loss_error(methods_.coarse);
}

std::int64_t Course::next(std::size_t replica) const {
  return (place_ + (takes(replica) ? 0 : 1)) * methods_.grid;
}

void Course::add(std::size_t replica, Pair const& pair) {
  of_[replica].push_back(pair);
  while (std::ranges::all_of(of_, [&](auto const& pairs) { return pairs.size() > rounds_; }))
    end_round();
}

void Course::end_round() {
  auto const pairs = ++rounds_ * of_.size();
  bool look = verdict_ != Verdict::none;
  for (; looks_ < schedule.size() && schedule[looks_] <= pairs; ++looks_) look = true;
  if (look) {
    auto verdict = judged().verdict;
    if (verdict == Verdict::none && looks_ == schedule.size()) verdict = Verdict::open;
    if (verdict != std::exchange(verdict_, verdict)) verdicts_.push_back({pairs, verdict});
  }
  place_ += verdict_ == Verdict::none ? 1 : place_;
}

/// Those of complete rounds, in an order that does not depend on when they were taken.
std::vector<Pair> Course::all() const {
  std::vector<Pair> pairs;
  for (std::size_t round = 0; round < rounds_; ++round)
    for (auto const& of_replica : of_) pairs.push_back(of_replica[round]);
  return pairs;
}

Judgement Course::judged() const {
  return judge(all(), tolerance_, methods_.strain(), collision_loss_error_);
}

std::vector<double> Course::save(std::size_t replica) const {
  std::vector<double> numbers;
  for (auto const& pair : of_[replica]) {
    numbers.push_back(static_cast<double>(pair.step));
    for (auto const& side : {pair.coarse, pair.fine})
      for (double const number : side.numbers()) numbers.push_back(number);
  }
  return numbers;
}

void Course::load(std::size_t replica, std::vector<double> const& numbers) {
  for (std::size_t at = 0; at + numbers_of_pair <= numbers.size(); at += numbers_of_pair) {
    auto const side = [&](std::size_t from) {
      std::array<double, Averages::count> of;
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(from), of.size(), of.begin());
      return Averages::of(of);
    };
    add(replica,
        {static_cast<std::int64_t>(numbers[at]), side(at + 1), side(at + 1 + Averages::count)});
  }
}

Findings Course::findings() const {
  Findings found{.tolerance = tolerance_, .methods = methods_, .judgement = {}, .looks = verdicts_};
  found.pairs = rounds_ * of_.size();
  for (auto const& pairs : of_)
    found.coarse_steps += static_cast<std::int64_t>(pairs.size()) * methods_.length();
  found.fine_steps = found.coarse_steps * methods_.ratio;
  if (found.pairs > 1) found.judgement = judged();
  found.judgement.verdict = verdict_;
  return found;
}

}  // namespace bagnold::bias
