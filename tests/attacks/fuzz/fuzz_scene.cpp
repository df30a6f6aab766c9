// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a scene: refused in words, or a scene that is written and read back the same and
// whose plan is sound.
#include <cstdint>

#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/time_step.hpp"
#include "tests/attacks/fuzz/expected.hpp"

namespace bagnold::fuzz {

namespace {

Scene accepted(std::string_view text) { return parse_scene(text, "scene.toml", "/nowhere"); }

void try_scene(std::string_view text) {
  Scene const scene = accepted(text);
  auto const written = write_scene(scene);
  try {
    expect(write_scene(accepted(written)) == written, "a scene is read back the same");
    auto const settled = write_scene(resolved(scene));
    expect(write_scene(accepted(settled)) == settled, "a resolved scene is read back the same");
  } catch (InputError const& error) {
    expect(false, error.what());
  }
  for (auto const& run : runs_of(scene)) {
    Plan const plan = make_plan(run);
    expect_sound(run, plan);
    check_feasible(run, plan, false);
  }
}

}  // namespace

}  // namespace bagnold::fuzz

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  try {
    bagnold::fuzz::try_scene({reinterpret_cast<char const*>(data), size});
  } catch (bagnold::InputError const& refusal) {
    bagnold::fuzz::expect_words(refusal.what());
  }
  return 0;
}
