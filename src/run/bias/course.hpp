// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/config/ladder.hpp"
#include "src/config/scene.hpp"
#include "src/run/bias/judge.hpp"
#include "src/run/bias/methods.hpp"

namespace bagnold::bias {

/// Reason of a trial without pairs: p_kin/p is at least_inertia() or above, or at most_kinetic
/// where the run stepped by the method.
inline constexpr std::string_view inertia = "inertia";

/// What pairs of stretches said of one method.
struct Trial {
  /// A verdict that differs from the one before, and after how many pairs.
  struct Look {
    std::size_t pairs;
    Verdict verdict;
  };

  Methods methods;
  std::size_t pairs = 0;
  Judgement judgement;  ///< of all pairs; its verdict that of the last look
  std::vector<Look> looks;
  std::string_view reason = {};  ///< why there are no pairs: inertia, "events", "a step failed"
  bool taken = false;            ///< the run stepped by it
};

/// Which stretch of a pair is the run's own: it steps the other one from a state, and goes on.
enum class Own { neither, coarse, fine };

/// What was found out about the method of a run.
struct Findings : Trial {
  double tolerance = 0;
  std::int64_t coarse_steps = 0, fine_steps = 0;  ///< of all stretches but the run's own
  double dropped_strain = 0;  ///< stepped by methods that were left, in no average

  /// Other methods that scheme = "auto" tried, in turn.
  std::vector<Trial> tried;
};

/// Strain between looks at p_kin/p while a run steps by a method that damps all.
inline constexpr double watch_strain = 0.1;

/// Pairs after which the method of a run is `open` if it has no verdict: more where less than
/// usual_accuracy is asked for, as their errors fall with the root of their number.
constexpr std::size_t most_pairs(double accuracy) { return accuracy < usual_accuracy ? 510 : 20; }

/// Pairs of all replicas, when the next ones begin, and the method of scheme = "auto".
///
/// Replicas take pairs in rounds, each one pair at the same place of a grid. After 4, 6, 9, 13, 20
/// pairs and so on by halves (short stretches: from 9 on), and once there is a verdict after each
/// round, all pairs so far are judged together.
/// Without a verdict the next round is at the next place, with one at twice the strain, or three
/// times it with scheme = "auto". So the course depends on the pairs alone, not on when they were
/// taken.
///
/// With scheme = "auto" the run begins with the usual method, and cheaper ones are judged in turn,
/// the cheapest first, by pairs from the states of the run. One is accepted: the run takes it, and
/// its pairs go on; between them each strain of watch_strain is a round too, in which p_kin/p alone
/// is looked at, of methods that damp all. It is refused or open after 9 pairs, 13 where the run is
/// a side of them, or as much strain of shorter ones: the next one is tried at places twice as far
/// apart. If the method that the run steps by is refused, the usual one follows, and the windows so
/// far are dropped; without a verdict it has pairs at 1.5 times the strain each time. Where an
/// accuracy below usual_accuracy or measure.bias asks for it, the usual method is judged too, and
/// if it is refused one of half the step follows.
///
/// While quasi-static steps are on trial, from the first pair to a verdict, the run steps by
/// implicit damping, the finer side of their pairs. If they are given up, or inertia has a part,
/// the usual method follows, and the windows so far are dropped.
///
/// Where the run itself steps by one of both methods, own(), and places are a stretch apart, the
/// run's windows up to the next place are that side of the pair. The round ends there.
class Course {
 public:
  Course(Scene const& scene, std::size_t replicas);

  Methods const& methods() const { return methods_; }
  std::vector<Pair> const& pairs(std::size_t replica) const { return of_[replica]; }

  /// Step from which a replica takes its next pair; if it has that of this round, the first that
  /// the next round may have.
  std::int64_t next(std::size_t replica) const;

  /// True if a replica takes a pair at next(); false: it waits there until others have theirs.
  bool takes(std::size_t replica) const { return of_[replica].size() == rounds_; }

  void add(std::size_t replica, Pair const& pair);

  /// The side of the pairs of the present round that the run steps itself.
  Own own() const;

  /// The stretch of a replica's pair that is not its own is done: the pair comes at the next place.
  void begin(std::size_t replica, std::int64_t step, Averages const& other);
  struct Begun {
    std::int64_t step;
    Averages other;
  };
  std::optional<Begun> const& begun(std::size_t replica) const { return begun_[replica]; }

  /// Step at which the present round ends.
  std::int64_t end() const { return end_place() * grid_; }

  /// True if the method of the run may change; replicas then wait for each other after a pair.
  bool chooses() const { return ladder_.has_choice(); }

  /// What a replica has at next(), if it is no pair: the method on trial does not serve a flow with
  /// this p_kin/p, or one in which events take the place of steps; or this place has none.
  std::optional<Pair> without_pair(std::int64_t step, double kinetic_share, bool has_step) const;

  /// Between places of the run at which rounds may be, [steps of the run].
  std::int64_t grid() const { return grid_; }

  /// First and one past the last of the run's windows of a pair that began at a step.
  std::pair<std::size_t, std::size_t> windows_from(std::int64_t step) const {
    auto const first = static_cast<std::size_t>(step / ladder_.window);
    return {first, first + static_cast<std::size_t>(grid_ / ladder_.window)};
  }

  /// Windows before a round from which p_kin/p is told: half of those between two places, or
  /// between two looks at a method that the run steps by.
  std::int64_t late_windows() const {
    auto const windows = (watches() ? places(watch_strain) : 1) * grid_ / ladder_.window;
    return (windows + 1) / 2;
  }

  /// The scene by whose scheme and step the run steps at present.
  Scene run_by() const;

  /// Method by which the run steps, of its ladder.
  std::size_t method() const { return main_; }

  /// Step of the run before which it stepped by a refused method; 0: it did not.
  std::int64_t dropped() const { return dropped_; }

  /// Changes of the method so far, in words.
  std::vector<std::string> const& changes() const { return changes_; }

  /// Numbers of the pairs of a replica, for a checkpoint; and back.
  std::vector<double> save(std::size_t replica) const;
  void load(std::size_t replica, std::vector<double> const& numbers);

  Findings findings() const;

 private:
  bool holds() const { return on_trial_ == main_; }     ///< the run steps by the method on trial
  bool cheap() const { return main_ < ladder_.usual; }  ///< the run steps by a cheaper method
  bool watches() const;
  std::int64_t places(double strain) const;
  std::int64_t spacing() const;
  std::int64_t next_pair(std::int64_t place, std::int64_t here) const;
  std::int64_t end_place() const;
  std::int64_t next_look(std::int64_t here) const;
  double strain_of(std::int64_t steps) const;
  void end_round();
  void look();
  std::size_t next_trial() const;
  void choose(std::int64_t here);
  void leave(std::string const& said, std::size_t method, std::int64_t here);
  void begin_trial(std::size_t method, std::int64_t here);
  void count_steps(std::size_t round);
  Trial trial() const;
  std::vector<Pair> all() const;
  Judgement judged() const;

  double tolerance_, collision_loss_error_ = 0;
  Scene scene_;
  Ladder ladder_;
  Methods methods_;
  std::int64_t grid_;                        ///< [steps of the run]
  std::vector<std::vector<Pair>> of_;        ///< [R], in the order of rounds
  std::vector<std::optional<Begun>> begun_;  ///< [R]
  std::size_t rounds_ = 0;                   ///< complete

  std::size_t main_ = 0, on_trial_ = 0;  ///< of the ladder
  bool done_ = false;                    ///< nothing is on trial any more
  std::int64_t dropped_ = 0;
  std::vector<Trial> tried_;
  std::vector<std::string> changes_;
  std::int64_t coarse_steps_ = 0, fine_steps_ = 0;  ///< of stretches that are not the run's own

  // of the present trial
  std::size_t finer_ =
      0;  ///< the finer method's place on the ladder, past its end where it has none
  std::size_t first_round_ = 0;
  std::size_t looks_ = 0;          ///< of the schedule
  std::int64_t place_ = 1;         ///< of the present round on the grid
  std::int64_t pair_place_ = 1;    ///< of the next round of pairs
  std::string_view skipped_ = {};  ///< why the last round was, empty: it was not
  bool taken_ = false;
  int skips_ = 0;  ///< rounds in turn that were
  Verdict verdict_ = Verdict::none;
  std::string_view reason_ = {};
  std::vector<Trial::Look> verdicts_;
};

/// Name of a replica's pairs among the arrays of a checkpoint.
inline constexpr char pairs_name[] = "bias_pairs";

}  // namespace bagnold::bias
