// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/blocks/forecast_list.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "kernels/physics/box/list_criterion.hpp"
#include "src/engine/blocks/block_lists.hpp"
#include "src/engine/law_engines.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // of slots, the smaller first

/// Disks that fly through each other, so that a list has nothing else to reckon with.
struct Flyers {
  Scene scene;
  BlockDisks disks;
  BlockLists lists;
  ForecastList forecast;

  Flyers(Scene const& of, Snapshot snapshot)
      : scene(of),
        disks{.loop = make_block_loop("serial"),
              .stepper = engines_for(scene.disks.model).stepper(engine_input(scene)),
              .clock = {strain_rates(scene), time_step(scene), snapshot},
              .list = {},
              .diameter = snapshot.state.diameter,
              .system = {}},
        lists(disks, skin(scene)),
        forecast(disks, skin(scene)) {
    disks.system.table = make_species_table(scene.mass_by_area());
    disks.system.rotates = scene.rotates();
    lists.build(take_disks(snapshot.state));
  }

  Lookahead next(std::int64_t steps) const {
    auto const begin = disks.system.step;
    return {.begin = begin, .end = begin + steps, .after = disks.clock, .most_deviation = 0};
  }

  /// Pairs forecast from the list, on straight flights or with deviations.
  Pairs forecast_pairs(Lookahead const& lookahead, Real allowance) {
    auto& all = disks.system;
    auto const box = disks.box_at(lookahead.begin);
    Real const duration = static_cast<Real>(lookahead.steps()) * disks.clock.time_step;
    forecast.renew(lookahead, box, duration, allowance);
    Forecast found;
    for (std::uint32_t b = 0; b < all.blocks.count; ++b) {
      Block const& block = all.blocks.block(b);
      refresh_halo(all.blocks, block, all.now, box);
      predict_contacts(all.blocks, block, forecast.of(block), all.now.record.data() + block.first,
                       duration, allowance, allowance, found);
    }
    Pairs pairs;
    auto const add = [&](SlotPair const& pair) {
      pairs.insert(std::minmax(pair.a, pair.b.index()));
    };
    for (auto const& pair : found.meeting) add(pair);
    for (auto const& near : found.near) add(near.pair);
    return pairs;
  }

  /// Of all pairs and images, by the least distance on the way.
  Pairs all_pairs(Lookahead const& lookahead, Real allowance) const {
    auto const& all = disks.system;
    auto const box = disks.box_at(lookahead.begin);
    Real const duration = static_cast<Real>(lookahead.steps()) * disks.clock.time_step;
    Pairs pairs;
    for (std::size_t i = 0; i < disks.count(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        auto const a = all.blocks.slot_of(i), b = all.blocks.slot_of(j);
        auto const &p = all.now.record(a), &q = all.now.record(b);
        Real const reach = (disks.diameter[i] + disks.diameter[j]) / 2 + 2 * allowance;
        for (int row = -1; row <= 1; ++row)
          for (int column = -3; column <= 3; ++column) {
            Vec2<Real> const v{p.vx - q.vx - row * box.strain_rate * box.height, p.vy - q.vy};
            Vec2<Real> const r{p.x - q.x - column * box.length - row * box.offset,
                               p.y - q.y - row * box.height};
            Real const nearest = std::clamp(-dot(r, v) / dot(v, v), 0.0, duration);
            Vec2<Real> const then{r.x + nearest * v.x, r.y + nearest * v.y};
            if (dot(then, then) < reach * reach) pairs.insert(std::minmax(a, b));
          }
      }
    return pairs;
  }

  void fly(Lookahead const& lookahead) {
    auto& all = disks.system;
    Real const duration = static_cast<Real>(lookahead.steps()) * disks.clock.time_step;
    for (std::size_t i = 0; i < disks.count(); ++i) {
      auto& r = all.now.record(all.blocks.slot_of(i));
      r.x += duration * r.vx;
      r.y += duration * r.vy;
    }
    all.step = lookahead.end;
  }
};

/// Every pair of the box that comes near is forecast and no other, also from a list that was taken
/// many lookaheads before, and by which disks then moved on.
TEST(ForecastList, HasEveryPairThatComesNear) {
  Scene scene = small_scene("CD_n", 0.7, 300);
  scene.integration.skin = 0.6;
  scene.integration.engine = "lookahead";
  Flyers flyers(scene, first_snapshot(random_start(scene).state));
  int lookaheads = 0;
  std::size_t forecast = 0;
  for (auto const steps : {4, 4, 8, 2, 4, 4, 4, 8, 16, 4, 4, 4, 2, 2, 2, 2, 2, 2}) {
    Real const allowance = lookaheads % 3 == 2 ? 0.004 : 0.001;
    auto const lookahead = flyers.next(steps);
    auto const shear = lookahead.after.strain_since(flyers.disks.list, lookahead.end);
    Real const duration = static_cast<Real>(steps) * flyers.disks.clock.time_step;
    auto const farthest = flyers.lists.farthest_at(lookahead.end, lookahead.after, duration);
    if (list_margin(shear, farthest + allowance) > flyers.lists.skin()) break;  // a new outer list
    auto const found = flyers.forecast_pairs(lookahead, allowance);
    EXPECT_EQ(found, flyers.all_pairs(lookahead, allowance)) << lookaheads;
    forecast += found.size();
    flyers.fly(lookahead);
    ++lookaheads;
  }
  EXPECT_GE(lookaheads, 10);
  EXPECT_GT(forecast, 100u);
  EXPECT_GE(flyers.disks.system.listing, 2);               // it was taken anew,
  EXPECT_LE(flyers.disks.system.listing, lookaheads / 2);  // but not each time
}

}  // namespace
}  // namespace bagnold::test
