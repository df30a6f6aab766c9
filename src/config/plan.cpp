// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/plan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "kernels/physics/species.hpp"
#include "src/config/abilities.hpp"
#include "src/config/control.hpp"
#include "src/config/errors.hpp"
#include "src/config/events.hpp"
#include "src/config/ladder.hpp"
#include "src/config/piece_table.hpp"
#include "src/config/skin.hpp"
#include "src/config/stability.hpp"
#include "src/config/step_counts.hpp"
#include "src/config/strain_rates.hpp"
#include "src/config/time_step.hpp"

namespace bagnold {

namespace {

constexpr double most_windows = 1e6;

/// Keys that determine the box of a scene, and its size, in words.
std::string box_in_words(Scene const& scene) {
  auto const& disks = scene.disks;
  if (disks.box_aspect == 1)
    return fmt::format("disks.count = {} makes a box {:.3g} d_s wide", disks.count,
                       scene.box_length());
  return fmt::format(
      "disks.count = {} with disks.box_aspect = {} makes a box {:.3g} d_s wide and "
      "{:.3g} high",
      disks.count, disks.box_aspect, scene.box_length(), scene.box_height());
}

/// Memory for the trajectory of one replica, [bytes]: frames not yet written and one more, the data
/// common to all frames, two copies of a frame in transit, and HDF5's cache of each dataset.
double memory_of_trajectory(Scene const& scene, Plan const& plan) {
  auto const count = static_cast<double>(scene.disks.count);
  double const frame = count * (scene.rotates() ? 7 : 6) * 8;
  double const frames =
      1 + static_cast<double>(plan.steps) / static_cast<double>(plan.trajectory_steps);
  double const part =
      std::min(frames * frame, trajectory_memory / static_cast<double>(scene.disks.replicas));
  return part + 2 * frame + count * (48 + 20) + 6 * 1024 * 1024;
}

/// Memory for data of frames, [bytes]. Profiles keep about 20 sums, twice, for each slice 1.5 d_s
/// thick; fields keep the last frame. A checkpoint and its image hold copies of all of it.
double memory_of_frames(Scene const& scene, Plan const& plan) {
  double const measured = static_cast<double>((plan.windows - plan.discarded_windows)) *
                          static_cast<double>(plan.window_steps);
  double const frames = 1 + measured / static_cast<double>(plan.frame_steps);
  double bytes = 0;
  if (scene.measure.profiles) bytes += frames * (8 + scene.box_height() / 1.5) * 2 * 21 * 8 * 5;
  if (plan.ramp) bytes += frames * 2000 * 8 * 5;  // histograms of each
  if (scene.measure.fields) bytes += static_cast<double>(scene.disks.count) * 7 * 8 * 3;
  if (plan.trajectory_steps > 0) bytes += memory_of_trajectory(scene, plan);
  return bytes;
}

constexpr double default_discard = 0.5;  // until "auto" has found the steady state

std::int64_t discarded_of(Scene const& scene, std::int64_t windows) {
  double const share = scene.shear.discard.value_or(default_discard);
  return static_cast<std::int64_t>(round_up(share * static_cast<double>(windows)));
}

void refuse_many_windows(double windows, std::string const& key, double value, double least) {
  if (windows > most_windows)
    throw InputError(fmt::format("{} = {} makes {:.0f} windows (limit {:.0f}); use at least {}",
                                 key, value, windows, most_windows, least));
}

/// True if the engine adds up all contacts, and looks at no single configuration.
bool knows_all_contacts(Scene const& scene) {
  return abilities_of(scene).own_scheme && !scene.measure.correlations;
}

Plan plan_of_ramp(Scene const& scene) {
  Plan plan;
  plan.ramp = make_ramp(scene);
  plan.time_step = plan.ramp->time_step;
  plan.every = knows_all_contacts(scene) ? 1 : scene.measure.every;
  plan.steps = plan.ramp->steps();
  plan.window_steps = plan.ramp->window_steps;
  plan.windows = plan.steps / plan.window_steps;
  plan.discarded_windows = plan.ramp->first_leg() / plan.window_steps;
  auto const windows = static_cast<double>(plan.windows);
  refuse_many_windows(windows, "shear.ramp_window", scene.shear.ramp_window,
                      scene.shear.ramp_window * std::ceil(windows / most_windows));
  double const window_decades = scene.shear.ramp_rate * scene.shear.ramp_window;
  auto const steps_between = [&](double decades) {
    double const whole = std::clamp(std::round(decades / window_decades), 1.0, windows);
    return static_cast<std::int64_t>(whole) * plan.window_steps;
  };
  plan.frame_steps = steps_between(scene.measure.frame_decades);
  if (scene.output.trajectory_decades > 0)
    plan.trajectory_steps = steps_between(scene.output.trajectory_decades);
  return plan;
}

constexpr double stop_windows_a_decade = 20;

/// Adds the windows of a stop, whose ends are evenly spaced in the logarithm of the time.
void add_stop(std::vector<WindowRow>& rows, std::int64_t begin, std::int64_t steps,
              std::int64_t& windows) {
  auto const growth = std::pow(10, 1 / stop_windows_a_decade);
  for (std::int64_t done = 0, end = 0; done < steps; done = end) {
    end = std::max<std::int64_t>(done + 1, std::llround(static_cast<double>(done) * growth));
    end = std::min(end, steps);
    rows.push_back({begin + done, windows++, end - done});
  }
}

/// Windows of the pieces of a sequence, each of its own.
std::vector<WindowRow> rows_of_sequence(Scene const& scene, PieceTable const& pieces,
                                        std::int64_t& windows) {
  std::vector<WindowRow> rows;
  for (std::int64_t cycle = 0; cycle < pieces.cycles(); ++cycle)
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      std::int64_t const begin = cycle * pieces.cycle_steps() + pieces[k].begin;
      auto const steps = pieces.steps_of(k);
      if (pieces[k].rate == 0) {
        add_stop(rows, begin, steps, windows);
        continue;
      }
      double const wanted =
          round_up(scene.output.sample_strain / std::abs(pieces[k].rate) / time_step(scene));
      auto const window =
          static_cast<std::int64_t>(std::clamp(wanted, 1.0, static_cast<double>(steps)));
      rows.push_back({begin, windows, window});
      windows += (steps + window - 1) / window;
      refuse_many_windows(static_cast<double>(windows), "output.sample_strain",
                          scene.output.sample_strain, 2 * scene.output.sample_strain);
    }
  return rows;
}

Plan plan_of_pieces(Scene const& scene) {
  Plan plan;
  plan.pieces = std::make_shared<PieceTable>(*pieces_of(scene));
  auto const& pieces = *plan.pieces;
  plan.time_step = time_step(scene);
  plan.every = scene.measure.every;
  plan.steps = pieces.steps();
  if (scene.shear.lists_pieces()) {
    plan.rows = rows_of_sequence(scene, pieces, plan.windows);
    plan.window_steps = plan.rows.front().steps;
  } else {
    plan.window_steps = pieces.steps_of(0);
    plan.windows = plan.steps / plan.window_steps;
    refuse_many_windows(static_cast<double>(plan.windows), "shear.cycles",
                        static_cast<double>(scene.shear.cycles), 1);
    auto const share = scene.shear.discard.value_or(0) * static_cast<double>(scene.shear.cycles);
    plan.discarded_windows =
        std::min(static_cast<std::int64_t>(round_up(share)), scene.shear.cycles - 1) *
        static_cast<std::int64_t>(pieces.size());
  }
  if (scene.output.trajectory_time > 0)
    plan.trajectory_steps = static_cast<std::int64_t>(
        std::clamp(std::round(scene.output.trajectory_time / plan.time_step), 1.0, most_steps));
  return plan;
}

}  // namespace

Plan make_plan(Scene const& scene) {
  if (scene.shear.ramps()) return plan_of_ramp(scene);
  if (pieces_of(scene)) return plan_of_pieces(scene);
  if (scene.shear.controlled()) {
    Plan plan = plan_of_control(scene);
    refuse_many_windows(static_cast<double>(plan.windows), "output.sample_strain",
                        scene.output.sample_strain, 2 * scene.output.sample_strain);
    plan.discarded_windows = discarded_of(scene, plan.windows / plan.stages);
    return plan;
  }
  Plan plan;
  plan.strain_rate = scene.shear.strain_rate;
  plan.time_step = time_step(scene);
  plan.every = knows_all_contacts(scene) ? 1 : scene.measure.every;
  double const step_strain = plan.time_step * scene.shear.strain_rate;
  double const steps = round_up(scene.shear.strain / step_strain);
  if (!(steps * static_cast<double>(scene.disks.replicas) <= most_steps))
    throw InputError(
        fmt::format("shear.strain = {} takes {:.3g} steps (limit {:.0g}); raise shear.strain_rate "
                    "= {} or lower "
                    "shear.strain",
                    scene.shear.strain.at(0), steps, most_steps, scene.shear.strain_rate));
  auto const ladder = ladder_of(scene);
  double const window = ladder.has_choice()
                            ? static_cast<double>(ladder.window)
                            : std::max(1.0, round_up(scene.output.sample_strain / step_strain));
  plan.steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(steps));
  plan.window_steps = static_cast<std::int64_t>(std::min(window, most_steps));
  if (ladder.has_choice() && plan.steps >= ladder.window)  // whole windows, each of one method
    plan.steps = (plan.steps + ladder.window - 1) / ladder.window * ladder.window;
  plan.windows = (plan.steps + plan.window_steps - 1) / plan.window_steps;
  refuse_many_windows(static_cast<double>(plan.windows), "output.sample_strain",
                      scene.output.sample_strain, std::ceil(steps / most_windows) * step_strain);
  plan.discarded_windows = discarded_of(scene, plan.windows);
  auto const steps_between = [&](double strain) {  // whole ones of every method
    double const whole = static_cast<double>(ladder.whole);
    return static_cast<std::int64_t>(
               std::clamp(round_up(strain / step_strain / whole), 1.0, most_steps / whole)) *
           ladder.whole;
  };
  plan.frame_steps = steps_between(scene.measure.frame_strain);
  if (scene.output.trajectory_strain > 0)
    plan.trajectory_steps = steps_between(scene.output.trajectory_strain);
  return plan;
}

Plan shortened(Scene const& scene, Plan plan, std::int64_t windows) {
  plan.steps = plan.window_end(windows - 1);
  plan.windows = windows;
  auto const dropped = std::min(plan.dropped_windows, windows);
  plan.discarded_windows = dropped + discarded_of(scene, windows - dropped);
  return plan;
}

std::int64_t Plan::window_begin(std::int64_t window) const {
  return window == 0 ? 0 : window_end(window - 1);
}

std::int64_t Plan::window_end(std::int64_t window) const {
  if (rows.empty()) return std::min((window + 1) * window_steps, steps);
  auto const row = *std::prev(std::ranges::upper_bound(rows, window, {}, &WindowRow::first));
  return std::min(row.begin + (window - row.first + 1) * row.steps, row_end(row));
}

WindowRow Plan::row_of(std::int64_t step) const {
  if (rows.empty()) return {0, 0, window_steps};
  return *std::prev(std::ranges::upper_bound(rows, step, {}, &WindowRow::begin));
}

std::int64_t Plan::row_end(WindowRow const& row) const {
  auto const next = std::ranges::upper_bound(rows, row.begin, {}, &WindowRow::begin);
  return next == rows.end() ? steps : next->begin;
}

double Plan::path(std::int64_t step) const { return pieces ? pieces->path(step) : strain(step); }

double Plan::progress(std::int64_t step) const {
  return by_time ? time_step * static_cast<double>(step) : path(step);
}

double Plan::strain(std::int64_t step) const {
  if (pieces) return pieces->strain(step);
  if (ramp) return static_cast<double>(ramp->strain(step));
  return time_step * strain_rate * static_cast<double>(step);
}

double Plan::mean_rate(std::int64_t window) const {
  if (pieces) return pieces->mean_rate(window_begin(window), window_end(window));
  return ramp ? ramp->mean_rate(window * window_steps, window_end(window)) : strain_rate;
}

int Plan::direction(std::int64_t window) const {
  return ramp ? ramp->piece(window * window_steps).direction : 0;
}

double least_box_for_fields() {
  // a search from a small disk reaches what touches the circle, one from a big disk further
  double const small_radius = small_diameter / 2;
  return 2 * (big_diameter + field_radius - small_radius);
}

std::string plan_warning(Scene const& scene, Plan const& plan) {
  if (scene.shear.oscillates() && scene.shear.discard > 0 && plan.discarded_windows == 0)
    return fmt::format(
        "shear.cycles = 1 leaves no cycle to discard, so its transient is measured; take more, or "
        "say shear.discard = 0");
  if (plan.discarded_windows < plan.windows) return {};
  return fmt::format(
      "shear.discard discards all {} windows of {} steps, so nothing will be measured; make "
      "output.sample_strain or shear.discard smaller, or shear.strain larger",
      plan.windows, plan.window_steps);
}

double memory_needed(Scene const& scene, Plan const& plan) {
  // Per disk: Views (positions, trials, list reference, motion), the list (about 7 neighbours in
  // both rows, as packed words), cells, and on the host a state and what windows keep of disks that
  // meet. The most that was seen is 0.8 of that with the reference engine and with events, 0.65
  // with the others (N = 262144 and 1048576, one in windows). Events have paths, the queue, wider
  // lists, and copies of all in blocks.
  double const spin = scene.rotates() ? 8 : 0;
  double const views = 3 * 16 + 2 * (16 + spin) + 1;
  double const list = 4 + 1.125 * 4 * 7 * std::pow(1 + skin(scene), 2) + 3 * 4;
  double const host = (16 + 16 + spin + 8) + 32;
  double const windows = static_cast<double>(plan.windows) * 16 * 8 * 6;
  double const systems = scene.measure.bias || may_change_method(scene)
                             ? 2
                             : 1;  // a stretch has one of its own, of steps
  double const events = has_events(scene) || may_take_events(scene) ? 700 : 0;
  double const system =
      static_cast<double>(scene.disks.count) * (systems * (views + list + host) + events) +
      windows + memory_of_frames(scene, plan);
  return static_cast<double>(scene.disks.replicas) * system + 64e6;
}

void check_feasible(Scene const& scene, Plan const& plan, bool allow_unstable) {
  double const reach = big_diameter + skin(scene);
  double const least = std::min(scene.box_length(), scene.box_height());
  auto const box = box_in_words(scene);
  if (least < 2 * reach)
    throw InputError(fmt::format(
        "{} (must be at least 2 (largest contact distance {} + integration.skin {}) = {:.3g}, or "
        "disks meet through two images); use more disks{} a smaller skin",
        box, big_diameter, skin(scene), 2 * reach,
        scene.disks.box_aspect == 1 ? " or" : ", an aspect nearer 1 or"));

  if (scene.measure.fields && least < least_box_for_fields())
    throw InputError(fmt::format(
        "measure.fields = true ({}, circles of radius {} need {:.3g}, or they meet disks through "
        "two images); use more disks or measure.fields = false",
        box, field_radius, least_box_for_fields()));

  double const radius = contact_spectral_radius(scene, plan.time_step);
  if (radius > 1 + 1e-9 && !allow_unstable) {
    Scene by_rule = scene;
    by_rule.integration.time_step = automatic;
    throw InputError(fmt::format(
        "integration.time_step = {} (unstable: one step of a single contact of the lightest pair "
        "has "
        "spectral radius {:.3g}, above 1, with {}); \"auto\" takes {}, or pass --allow-unstable",
        plan.time_step, radius, scheme_of(scene), time_step(by_rule)));
  }

  double const needed = memory_needed(scene, plan);
  double const there =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  bool const alone = scene.disks.replicas == 1;
  if (needed > there)
    throw InputError(
        fmt::format("disks.count = {}{} needs about {:.1f} GiB of memory, this machine has {:.1f}; "
                    "use fewer disks{}{}",
                    scene.disks.count,
                    alone ? "" : fmt::format(" with disks.replicas = {}", scene.disks.replicas),
                    needed / 0x1p30, there / 0x1p30, alone ? "" : " or replicas",
                    may_take_events(scene) ? ", or integration.engine = \"steps\"" : ""));
}

}  // namespace bagnold
