// SPDX-License-Identifier: BSD-3-Clause
//
// A contact law of one's own, run as `bagnold run` runs those of the list: own_law SCENE FOLDER
// runs a scene into a folder, or goes on with the run that is there.
#include <csignal>
#include <iostream>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/dense_flow.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"
#include "src/config/scene_file.hpp"
#include "src/engine/register_law.hpp"
#include "src/run/run.hpp"

using bagnold::Real;

/// Contact dissipation along the tangent only, at the point of contact: f_dis = -k_d [v - (v . n)
/// n]. Disks bounce back as fast as they came and lose what they slide. Force on i from j, [m d_s /
/// tau_e^2].
struct CDt {
  static constexpr std::string_view name = "CD_t";   ///< as in the scene
  static constexpr bool rotates = true;              ///< needs spins
  static constexpr bool linear = true;               ///< in the velocity: two stages can step it
  static constexpr bool one_constant = false;        ///< along the normal and the tangent
  static constexpr bool separate_constants = false;  ///< of the scene's damping_normal, ...
  Real damping;                                      ///< k_d, [m / tau_e]; 1/Q in reduced units

  Real normal_damping() const { return 0; }
  Real tangential_damping() const { return damping; }
  Real dense_flow_rate() const { return bagnold::dense_flow::rolling * damping; }
  static Real paper_time_step(Real elasticity) { return bagnold::time_step_of_p1(elasticity); }
  static CDt make(bagnold::DampingInput const& input) { return {1 / input.elasticity}; }

  template <class T>
  KOKKOS_FUNCTION bagnold::Vec2<T> dissipative_force(bagnold::Contact<T> const& c) const {
    T const normal_part = T(damping) * dot(c.velocity, c.normal);
    return normal_part * c.normal - T(damping) * c.velocity;
  }
};
static_assert(bagnold::is_contact_law<CDt>());

volatile std::sig_atomic_t interrupted = 0;

struct Monitor : bagnold::RunMonitor {
  bool stop_requested() override { return interrupted != 0; }  // with a checkpoint
  void status(std::string const& line) override { std::cout << line << '\n'; }
};

int main(int count, char** words) try {
  if (count != 3) throw bagnold::InputError("usage: own_law SCENE FOLDER");
  std::filesystem::path const folder = words[2];
  std::signal(SIGINT, [](int) { interrupted = 1; });
  bagnold::register_law<CDt>();
  Monitor monitor;
  auto const end = std::filesystem::exists(folder)
                       ? bagnold::resume(folder, {.monitor = &monitor})
                       : bagnold::run(bagnold::read_scene(words[1]), folder, {.monitor = &monitor});
  return end == bagnold::RunEnd::done ? 0 : 130;
} catch (std::exception const& error) {
  std::cerr << "own_law: " << error.what() << '\n';
  return 1;
}
