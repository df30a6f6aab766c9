// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <set>

#include "src/engine/contacts/contact_record.hpp"
#include "tests/support/simulations.hpp"

/// Contacts as engines tell of them, and as all pairs of every configuration give them.
namespace bagnold::test {

using PairOfDisks = std::pair<std::uint32_t, std::uint32_t>;

/// Something that happened, whoever saw it.
struct Happened {
  std::int64_t step;
  bool begins;
  PairOfDisks pair;
  double theta;          ///< [degrees]
  std::int64_t measure;  ///< disks in the cluster, or the duration in steps

  auto key() const { return std::tuple(step, begins, pair, measure); }
};

/// The velocities of a contact at the step that was chosen.
struct SampledContact {
  PairOfDisks pair;
  std::int64_t begin;
  ContactVelocities velocities;
};

class Listener final : public ContactListener {
 public:
  std::vector<Happened> all;
  std::vector<SampledContact> samples;
  std::map<Real, ContactVelocities> picks;  ///< by rank
  Real below = 1;                           ///< ranks that are asked for
  void picked(ContactPick const& pick) override { picks[pick.rank] = pick.velocities; }
  Real limit() const override { return below; }
  void sampled(OpenContact const& c) override {
    samples.push_back({{c.a, c.b}, c.begin, c.velocities});
  }
  void begins(ContactEvent const& e, std::size_t cluster) override {
    all.push_back({e.step, true, {e.a, e.b}, e.theta, static_cast<std::int64_t>(cluster)});
  }
  void ends(ContactEvent const& e, std::int64_t duration) override {
    all.push_back({e.step, false, {e.a, e.b}, e.theta, duration});
  }
};

/// What the reference, all pairs of every configuration, makes of a start.
class AllPairs {
 public:
  std::vector<Happened> all;  ///< ends first, then by pair
  std::vector<std::array<double, ContactColumns::count>> windows;
  std::vector<SampledContact> samples;      ///< in the order of their ends
  std::map<Real, ContactVelocities> picks;  ///< all contacts of evaluated configurations, by rank

  AllPairs(Scene const& scene, State const& start, Sampling const& sampling,
           SampleChoice choice = {})
      : choice_(choice) {
    reference::System system(reference_parameters(scene), start);
    for (std::int64_t step = 0; step < sampling.last_step; ++step) {
      windows.resize(static_cast<std::size_t>(sampling.window(step)) + 1);
      detect(system, step, sampling);
      reference::step(system);
    }
  }

 private:
  struct Open {
    std::int64_t begin;
    bool binary;
    std::vector<ContactVelocities> each = {};  ///< of every step
  };
  SampleChoice choice_;
  std::map<PairOfDisks, Open> open_;

  void detect(reference::System const& system, std::int64_t step, Sampling const& sampling) {
    auto& sums = windows.back();
    sums[ContactColumns::steps] += 1;
    std::map<PairOfDisks, reference::Contact> now;
    std::vector<std::vector<std::uint32_t>> touch(system.s.count());
    for (auto const& c : reference::contacts(system)) {
      auto const i = static_cast<std::uint32_t>(c.i), j = static_cast<std::uint32_t>(c.j);
      if (now.insert_or_assign({i, j}, c).second) {
        touch[i].push_back(j);
        touch[j].push_back(i);
      }
      if (!sampling.sampled(step)) continue;
      auto const v = velocities(system, c);
      add(v, system.p.strain_rate, sums.data() + ContactColumns::motion);
      if (choice_) picks[choice_.rank_at(i, j, step)] = v;
    }
    end(system, now, step, sums);
    for (auto const& [pair, c] : now) {
      bool const fresh = open_.try_emplace(pair, Open{step, true}).second;
      if (touch[pair.first].size() + touch[pair.second].size() > 2) open_[pair].binary = false;
      if (choice_) open_[pair].each.push_back(velocities(system, c));
      if (!fresh || step == 0) continue;
      sums[ContactColumns::begun] += 1;
      all.push_back({step, true, pair, theta(c), cluster(touch, pair.first)});
    }
  }

  void end(reference::System const& system, std::map<PairOfDisks, reference::Contact> const& now,
           std::int64_t step, std::array<double, ContactColumns::count>& sums) {
    std::erase_if(open_, [&](auto const& entry) {
      auto const& [pair, open] = entry;
      if (now.contains(pair)) return false;
      if (open.begin == 0) return true;
      sums[ContactColumns::ended] += 1;
      sums[ContactColumns::duration] += static_cast<double>(step - open.begin);
      sums[ContactColumns::binary] += open.binary;
      all.push_back({step, false, pair, theta(apart(system, pair)), step - open.begin});
      if (choice_) samples.push_back({pair, open.begin, chosen(pair, open, step)});
      return true;
    });
  }

  /// Sums in the columns of ContactMotion.
  static void add(ContactVelocities const& v, double rate, double* sums) {
    using M = ContactMotion;
    double const t = v.tangential * rate, r = v.rotational * rate, n = v.normal * rate;
    for (auto const& [column, value] : {std::pair{M::normal2, n * n},
                                        {M::tangential2, t * t},
                                        {M::rotational2, r * r},
                                        {M::tangential_rotational, t * r},
                                        {M::tangential_normal, t * n},
                                        {M::rotational_normal, r * n},
                                        {M::tangential, t},
                                        {M::rotational, r},
                                        {M::normal, n},
                                        {M::contacts, 1.0}})
      sums[column] += value;
  }

  /// The last step that the choice comes to before the end.
  ContactVelocities chosen(PairOfDisks const& pair, Open const& open, std::int64_t end) const {
    auto last = choice_.first(open.begin);
    for (auto due = last; due < end; due = choice_.next(pair.first, pair.second, open.begin, due))
      last = due;
    return open.each.at(static_cast<std::size_t>(last - open.begin));
  }

  /// V_ij . t, the part of the spins, V_ij . n with n from i to j, by P2 Eqs. (6), (30), (33),
  /// (34).
  static ContactVelocities velocities(reference::System const& system,
                                      reference::Contact const& c) {
    double const nx = -c.x / c.separation, ny = -c.y / c.separation, tx = -ny, ty = nx;
    double surface = 0;
    if (!system.s.spin.empty()) {
      double const d_i = system.s.diameter[c.i], d_j = system.s.diameter[c.j];
      double const arm_i = c.separation * d_i / (d_i + d_j), arm_j = c.separation - arm_i;
      surface = system.s.spin[c.i] * arm_i + system.s.spin[c.j] * arm_j;
    }
    double const rate = system.p.strain_rate;
    return {(c.velocity_x * tx + c.velocity_y * ty) / rate, surface / rate,
            (c.velocity_x * nx + c.velocity_y * ny) / rate};
  }

  static double theta(reference::Contact const& c) {
    double const across = c.velocity_x * c.y - c.velocity_y * c.x;
    double const along = c.velocity_x * c.x + c.velocity_y * c.y;
    return std::atan2(across, along) * 180 / std::acos(-1.0);
  }

  /// A pair that touches no more, as a contact of two larger disks.
  static reference::Contact apart(reference::System const& system, PairOfDisks const& pair) {
    State two = system.s;
    for (auto* list : {&two.position, &two.velocity})
      *list = {(*list)[pair.first], (*list)[pair.second]};
    two.diameter = {2.0, 2.0};
    return reference::contacts(system.p, two, reference::strain(system)).at(0);
  }

  static std::int64_t cluster(std::vector<std::vector<std::uint32_t>> const& touch,
                              std::uint32_t from) {
    std::set<std::uint32_t> found{from};
    std::vector<std::uint32_t> next{from};
    while (!next.empty()) {
      auto const disk = next.back();
      next.pop_back();
      for (auto const other : touch[disk])
        if (found.insert(other).second) next.push_back(other);
    }
    return static_cast<std::int64_t>(std::min(found.size(), ContactRecord::largest_cluster));
  }
};

/// Windows with a record of contacts, and who is told of them.
struct Observed {
  std::shared_ptr<Listener> listener = std::make_shared<Listener>();
  OpenWindows windows;

  Observed(Simulation const& simulation, std::size_t disks, std::int64_t first_step = 0,
           SampleChoice choice = {}) {
    windows.contacts =
        std::make_shared<ContactRecord>(disks, simulation.columns(), first_step, listener, choice);
  }
  double sum(std::size_t window, int column, int columns) const {
    return windows.sums.at(window).sums.at(static_cast<std::size_t>(columns + column));
  }
};

}  // namespace bagnold::test
