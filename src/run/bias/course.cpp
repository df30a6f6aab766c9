// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/bias/course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "src/config/collision_loss.hpp"
#include "src/config/errors.hpp"
#include "src/config/names.hpp"
#include "src/config/time_step.hpp"
#include "src/run/rounded.hpp"

namespace bagnold::bias {

namespace {

constexpr std::array<std::size_t, 13> schedule = {4,  6,   9,   13,  20,  30, 45,
                                                  68, 100, 150, 225, 340, 510};

/// Pairs for a method that the run does not step by: more where one costs its stretch alone. Of
/// shorter stretches those of as much strain; fewer than nine of them lie too near each other.
constexpr std::size_t pairs_of_a_try = 9, pairs_beside_the_run = 13, fewest_shorter = 9;
constexpr int most_skips = 5;  ///< in turn, if others are to be judged
constexpr std::size_t numbers_of_pair = 1 + 2 * Averages::count;

constexpr std::string_view events = "events", failed_step = "a step failed";

double loss_error(Scene const& coarse) {
  return collision_loss_error(coarse, scheme_of(coarse), time_step(coarse));
}

/// Place on the ladder of the finer method of a pair, up to the usual one; past its end if none.
std::size_t finer_on_ladder(Ladder const& ladder, Method const& coarse, Methods const& pair) {
  auto const& all = ladder.methods;
  for (std::size_t k = 0; k <= ladder.usual; ++k)
    if (all[k].scheme == scheme_of(pair.fine) && all[k].length * pair.ratio == coarse.length)
      return k;
  return all.size();
}

/// "p +0.02(3)%, sigma ..." or the reason of a refusal without pairs
std::string in_words(Trial const& trial) {
  if (!trial.reason.empty()) return std::string(trial.reason);
  std::string words;
  for (std::size_t q = 0; q <= temperature; ++q) {
    auto const& one = trial.judgement.stated[q];
    if (!std::isfinite(one.value)) continue;  // Z without a contact in any stretch
    words += fmt::format("{}{} {}%", words.empty() ? "" : ", ", quantity_names[q],
                         rounded_bias(one.value, one.error));
  }
  return words;
}

}  // namespace

Course::Course(Scene const& scene, std::size_t replicas)
    : tolerance_(scene.integration.accuracy),
      scene_(scene),
      ladder_(ladder_of(scene)),
      of_(replicas),
      begun_(replicas) {
  if (chooses()) {
    grid_ = ladder_.grid;
    main_ = ladder_.usual;
    begin_trial(0, 0);
    return;
  }
  methods_ = methods_of(scene);
  grid_ = methods_.grid;
  collision_loss_error_ = loss_error(methods_.coarse);
}

std::int64_t Course::next(std::size_t replica) const {
  if (done_) return std::numeric_limits<std::int64_t>::max();
  if (takes(replica) && !begun_[replica]) return place_ * grid_;
  return chooses() ? end() : (place_ + 1) * grid_;
}

Scene Course::run_by() const {
  return chooses() ? with_method(scene_, ladder_.methods[main_]) : methods_.coarse;
}

Own Course::own() const {
  if (!ladder_.shares || place_ < pair_place_) return Own::neither;
  auto const& method = ladder_.methods[on_trial_];
  if (holds()) return method.parts == 1 ? Own::coarse : Own::neither;  // it looks at whole steps
  return main_ == finer_ ? Own::fine : Own::neither;
}

std::int64_t Course::end_place() const { return place_ + (own() == Own::neither ? 0 : 1); }

void Course::begin(std::size_t replica, std::int64_t step, Averages const& other) {
  begun_[replica] = {step, other};
}

/// True if there are rounds without pairs while the run steps by the method on trial.
bool Course::watches() const {
  return chooses() && holds() && damps_all(methods_.coarse.integration.scheme);
}

std::optional<Pair> Course::without_pair(std::int64_t step, double kinetic_share,
                                         bool has_step) const {
  if (!chooses()) return {};
  bool const inertial = damps_all(methods_.coarse.integration.scheme) &&
                        !(kinetic_share < (cheap() ? most_kinetic : least_inertia(scene_)));
  if (inertial || !has_step) return Pair::skipped(step, !has_step);
  if (place_ < pair_place_) return Pair::watched(step);
  return {};
}

void Course::add(std::size_t replica, Pair const& pair) {
  begun_[replica].reset();
  of_[replica].push_back(pair);
  while (std::ranges::all_of(of_, [&](auto const& pairs) { return pairs.size() > rounds_; }))
    end_round();
}

double Course::strain_of(std::int64_t steps) const {
  return static_cast<double>(steps) * time_step(scene_) * scene_.shear.strain_rate;
}

/// Places that come to a strain, at least one.
std::int64_t Course::places(double strain) const {
  return std::max<std::int64_t>(1, std::llround(strain / strain_of(grid_)));
}

/// Place of the next look at p_kin/p.
std::int64_t Course::next_look(std::int64_t here) const {
  return std::min(here + places(watch_strain), pair_place_);
}

/// Places between pairs of a trial without a verdict.
std::int64_t Course::spacing() const {
  if (!chooses()) return 1;
  if (holds()) return places(grid_strain);
  return std::int64_t{1} << std::min<std::size_t>(tried_.size(), 3);
}

/// Place of the next pair after a round at `place` that ended at `here`.
std::int64_t Course::next_pair(std::int64_t place, std::int64_t here) const {
  bool const knows = verdict_ != Verdict::none;
  if (!skipped_.empty()) return 2 * place;
  if (!knows) return std::max(here, place + (holds() && cheap() ? place / 2 : spacing()));
  return place * (chooses() ? 3 : 2);
}

void Course::end_round() {
  auto const round = rounds_++;
  auto const any = [&](auto is) {
    return std::ranges::any_of(of_, [&](auto const& pairs) { return (pairs[round].*is)(); });
  };
  auto const place = place_, here = end_place();
  count_steps(round);
  bool const skips = any(&Pair::is_skipped), failed = any(&Pair::is_failed);
  if (!skips && !failed && place < pair_place_) {  // watched
    place_ = next_look(here);
    return;
  }
  skipped_ = !skips ? std::string_view{} : any(&Pair::skips_events) ? events : inertia;
  auto const skipping =
      std::ranges::count_if(of_, [&](auto const& pairs) { return pairs[round].is_skipped(); });
  skips_ = 2 * skipping >= std::ssize(of_) ? skips_ + 1 : 0;
  bool const others = ladder_.judges_all || (skipped_ == inertia && next_trial() < ladder_.usual);
  bool const left = holds() ? cheap() : others && skips_ >= most_skips;
  if (failed || (skips && left)) {
    reason_ = failed ? failed_step : skipped_;
    if (verdict_ != Verdict::refused)
      verdicts_.push_back({all().size(), verdict_ = Verdict::refused});
  } else if (!skips) {
    look();
  }
  pair_place_ = next_pair(place, here);
  if (chooses()) choose(here);
  place_ = watches() ? next_look(here) : pair_place_;
}

/// Judges all pairs of the trial, where it is time.
void Course::look() {
  auto const pairs = all().size();
  bool const shares = ladder_.shares && finer_ < ladder_.methods.size();
  auto const shorter = std::max<long long>(1, std::llround(stretch_strain / methods_.strain()));
  auto const most = !chooses() || holds() ? most_pairs(tolerance_)
                                          : static_cast<std::size_t>(shorter) *
                                                (shares ? pairs_beside_the_run : pairs_of_a_try);
  bool due = verdict_ != Verdict::none || pairs >= most;
  for (; looks_ < schedule.size() && schedule[looks_] <= pairs; ++looks_)
    due = due || shorter == 1 || pairs >= fewest_shorter;
  if (!due || pairs < 2 || !reason_.empty()) return;
  auto verdict = judged().verdict;
  if (verdict == Verdict::none && pairs >= most && !(holds() && cheap())) verdict = Verdict::open;
  if (verdict != std::exchange(verdict_, verdict)) verdicts_.push_back({pairs, verdict});
}

/// Changes the method, or the one on trial, after a round at a place.
void Course::choose(std::int64_t here) {
  bool const accepted = verdict_ == Verdict::accepted;
  bool const gives_up = verdict_ == Verdict::refused || verdict_ == Verdict::open;
  auto said =
      fmt::format("strain {:.4g}: {}", strain_of(here * grid_), method_in_words(methods_.coarse));
  if (accepted || gives_up)
    said += fmt::format(", is {} after {} pairs of stretches ({})", name_of(verdict_), all().size(),
                        in_words(trial()));
  if (!holds() && accepted) {
    main_ = on_trial_;
    taken_ = true;
    changes_.push_back(said + "; taken from here on");
  } else if (gives_up && (!holds() || cheap())) {
    auto const next = next_trial();
    if (cheap())
      leave(said, ladder_.usual, here);
    else
      changes_.push_back(said);
    begin_trial(next, here);
  } else if (!holds() && cheap() && !skipped_.empty()) {
    leave(fmt::format("{}, is no longer on trial ({})", said, skipped_), ladder_.usual, here);
  } else if (!holds() && !cheap() && skipped_.empty() && finer_ < ladder_.usual) {
    main_ = finer_;
    changes_.push_back(
        fmt::format("{}, is on trial; beside it {}", said, method_in_words(run_by())));
  } else if (holds() && !cheap() && verdict_ == Verdict::refused &&
             main_ + 1 < ladder_.methods.size()) {
    leave(said, main_ + 1, here);
    begin_trial(main_, here);
  }
}

/// Steps the run by another method from a place on, and drops what was before.
void Course::leave(std::string const& said, std::size_t method, std::int64_t here) {
  main_ = method;
  dropped_ = here * grid_;
  changes_.push_back(fmt::format("{}; from here on {}, and what was before is left out", said,
                                 method_in_words(run_by())));
}

/// The method after the one on trial; not one that damps all, if inertia left no pair for that one.
std::size_t Course::next_trial() const {
  auto next = on_trial_ + 1;
  if (skipped_ == inertia && !taken_)
    while (damps_all(ladder_.methods[next].scheme)) ++next;
  return next;
}

/// Puts a method on trial after a place. The usual one is judged only where it is asked for.
void Course::begin_trial(std::size_t method, std::int64_t here) {
  if (here > 0) tried_.push_back(trial());
  on_trial_ = method;
  methods_ = methods_of(scene_, ladder_, ladder_.methods[method]);
  finer_ = finer_on_ladder(ladder_, ladder_.methods[method], methods_);
  collision_loss_error_ = loss_error(methods_.coarse);
  done_ = method == ladder_.usual && !ladder_.judges_all;
  first_round_ = rounds_;
  looks_ = 0;
  verdict_ = done_ ? Verdict::usual : Verdict::none;
  reason_ = {};
  skipped_ = {};
  taken_ = method == main_;
  skips_ = 0;
  verdicts_.clear();
  place_ = pair_place_ = here + spacing();
}

/// Adds the steps of the stretches of a round.
void Course::count_steps(std::size_t round) {
  for (auto const& pairs : of_) {
    if (!pairs[round].is_taken()) continue;
    if (own() != Own::coarse) coarse_steps_ += methods_.length();
    if (own() != Own::fine) fine_steps_ += methods_.length() * methods_.ratio;
  }
}

/// Pairs of complete rounds of the trial, in an order that does not depend on when they were taken.
std::vector<Pair> Course::all() const {
  std::vector<Pair> pairs;
  for (auto round = first_round_; round < rounds_; ++round)
    for (auto const& of_replica : of_)
      if (of_replica[round].is_taken()) pairs.push_back(of_replica[round]);
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
  if (auto const& one = begun_[replica]) {
    numbers.push_back(static_cast<double>(one->step));
    for (double const number : one->other.numbers()) numbers.push_back(number);
  }
  return numbers;
}

void Course::load(std::size_t replica, std::vector<double> const& numbers) {
  auto const side = [&](std::size_t from) {
    std::array<double, Averages::count> of;
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(from), of.size(), of.begin());
    return Averages::of(of);
  };
  auto const step_at = [&](std::size_t at) {
    auto const step = static_cast<std::int64_t>(numbers[at]);
    if (chooses() && step % grid_ != 0)
      throw InputError(
          "the checkpoint has pairs of stretches at other places of the strain; resume with the "
          "version that wrote it");
    return step;
  };
  std::size_t at = 0;
  for (; at + numbers_of_pair <= numbers.size(); at += numbers_of_pair)
    add(replica, {step_at(at), side(at + 1), side(at + 1 + Averages::count)});
  if (at < numbers.size()) begin(replica, step_at(at), side(at + 1));
}

Trial Course::trial() const {
  Trial of{.methods = methods_, .pairs = all().size(), .judgement = {}, .looks = verdicts_};
  of.reason = reason_.empty() && of.pairs == 0 ? skipped_ : reason_;
  of.taken = taken_;
  if (of.pairs > 1) of.judgement = judged();
  of.judgement.verdict = verdict_;
  return of;
}

Findings Course::findings() const {
  Findings found;
  static_cast<Trial&>(found) = trial();
  found.tolerance = tolerance_;
  found.coarse_steps = coarse_steps_;
  found.fine_steps = fine_steps_;
  found.tried = tried_;
  found.dropped_strain = strain_of(dropped_);
  if (!chooses() || holds()) return found;
  found.tried.push_back(trial());
  static_cast<Trial&>(found) = {
      .methods = methods_of(scene_, ladder_, ladder_.methods[main_]), .judgement = {}, .looks = {}};
  bool const unknown = ladder_.judges_all || main_ != ladder_.usual;
  found.judgement.verdict = unknown ? Verdict::none : Verdict::usual;
  return found;
}

}  // namespace bagnold::bias
