// SPDX-License-Identifier: BSD-3-Clause
#include "bench/device/starts.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "src/io/state_file.hpp"
#include "src/start/start.hpp"

namespace bagnold::bench {

namespace {

using Order = std::vector<std::size_t>;

template <class T>
void permute(std::vector<T>& values, Order const& order) {
  if (values.empty()) return;
  std::vector<T> moved(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) moved[i] = values[order[i]];
  values = std::move(moved);
}

/// Every other bit of the result, from the lowest on.
std::uint64_t spread(std::uint64_t x) {
  x &= 0xffffffff;
  x = (x | x << 16) & 0x0000ffff0000ffffull;
  x = (x | x << 8) & 0x00ff00ff00ff00ffull;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0full;
  x = (x | x << 2) & 0x3333333333333333ull;
  return (x | x << 1) & 0x5555555555555555ull;
}

void sort_by_cells(State const& state, Order& order) {
  constexpr double width = 1.5;
  std::vector<std::uint64_t> key(order.size());
  for (std::size_t i = 0; i < key.size(); ++i) {
    auto const cell = [&](int c) {
      return static_cast<std::uint64_t>(std::max(0.0, state.position[i][c]) / width);
    };
    key[i] = spread(cell(0)) | spread(cell(1)) << 1;
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return key[i]; });
}

void put_in_order(State& state, std::string const& name) {
  if (name == "start") return;
  Order order(state.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(7);
  std::ranges::shuffle(order, random);
  if (name == "cells") sort_by_cells(state, order);
  permute(state.position, order);
  permute(state.velocity, order);
  permute(state.spin, order);
  permute(state.diameter, order);
}

}  // namespace

std::vector<Snapshot> starts(Scene const& scene, std::string const& order) {
  Scene one = scene;
  one.disks.replicas = 1;
  State const first = fit_to_scene(io::read_states(scene.start.file), one).front().state;
  std::vector<Snapshot> all;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> nudge(-1e-9, 1e-9);
  for (std::int64_t r = 0; r < scene.disks.replicas; ++r) {
    State state = first;
    put_in_order(state, order);
    if (r > 0)
      for (auto& position : state.position)
        for (auto& x : position) x += nudge(random);
    all.push_back(first_snapshot(std::move(state)));
  }
  return all;
}

}  // namespace bagnold::bench
