// SPDX-License-Identifier: BSD-3-Clause
//
// A contact law and a drive of one's own, run as `bagnold run` runs those of the lists: own_law
// SCENE FOLDER runs a scene into a folder, or goes on with the run that is there.
#include <csignal>
#include <iostream>

#include "kernels/physics/laws/contact.hpp"
#include "kernels/physics/laws/paper_time_step.hpp"
#include "src/config/scene_file.hpp"
#include "src/engine/register_drive.hpp"
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
  static Real paper_time_step(Real elasticity) { return bagnold::time_step_of_p1(elasticity); }
  static CDt make(bagnold::DampingInput const& input) { return {1 / input.elasticity}; }

  template <class T>
  KOKKOS_FUNCTION bagnold::Vec2<T> dissipative_force(bagnold::Contact<T> const& c) const {
    T const normal_part = T(damping) * dot(c.velocity, c.normal);
    return normal_part * c.normal - T(damping) * c.velocity;
  }
};
static_assert(bagnold::is_contact_law<CDt>());

/// A fluid that drags fast disks more than slow ones: -zeta (1 + v^2/v_0^2) v, v beyond the mean
/// flow. Engines exert the drag, the push adds the rest.
struct CubicDrag {
  static constexpr std::string_view name = "cubic";  ///< as in the scene
  static constexpr bool random = false;              ///< asks for random numbers
  static constexpr bool thermal = false;             ///< has a temperature
  static constexpr Real speed = 0.01;                ///< v_0, [d_s / tau_e]
  Real drag;                                         ///< zeta, [m / tau_e]

  static CubicDrag make(bagnold::DriveInput const& input) { return {input.drag}; }

  template <class T>
  KOKKOS_FUNCTION bagnold::Push<T> push(bagnold::DrivenDisk<T> const& disk) const {
    T const excess = T(drag / (speed * speed)) * dot(disk.velocity, disk.velocity);
    return {-excess * disk.velocity, T(0)};
  }
};
static_assert(bagnold::OneBodyDrive<CubicDrag>);

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
  bagnold::register_drive<CubicDrag>();
  Monitor monitor;
  auto const end = bagnold::run(bagnold::read_scene(words[1]), folder, {.monitor = &monitor});
  return end == bagnold::RunEnd::done ? 0 : 130;
} catch (std::exception const& error) {
  std::cerr << "own_law: " << error.what() << '\n';
  return 1;
}
