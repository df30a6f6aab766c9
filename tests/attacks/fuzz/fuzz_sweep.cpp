// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a sweep file: refused in words, or points in chains that hold each of them once.
#include <cstdint>
#include <vector>

#include "src/config/errors.hpp"
#include "src/sweep/sweep.hpp"
#include "tests/attacks/fuzz/expected.hpp"

namespace bagnold::fuzz {

namespace {

void try_sweep(std::string const& text) {
  auto const check = [](Scene const& scene, Plan const& plan) {
    check_feasible(scene, plan, false);
  };
  auto const sweep = sweep::parse_sweep(text, "sweep.toml", "/nowhere", check);
  expect(!sweep.points.empty(), "a sweep has points");
  std::vector<int> in_chains(sweep.points.size());
  for (auto const& chain : sweep.chains)
    for (auto const point : chain) ++in_chains.at(point);
  expect(std::ranges::all_of(in_chains, [](int n) { return n == 1; }), "each point is done once");
  for (auto const& point : sweep.points) {
    expect_sound(point.scene, point.plan);
    expect(point.values.size() == sweep.keys.size(), "a point has a value for each key");
    expect(point.folder.find('/') == std::string::npos && point.folder.size() < 256,
           "a point's folder is a name");
  }
}

}  // namespace

}  // namespace bagnold::fuzz

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  try {
    bagnold::fuzz::try_sweep({reinterpret_cast<char const*>(data), size});
  } catch (bagnold::InputError const& refusal) {
    bagnold::fuzz::expect_words(refusal.what());
  }
  return 0;
}
