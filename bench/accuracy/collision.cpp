// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "bench/accuracy/commands.hpp"
#include "bench/accuracy/damped_contact.hpp"
#include "bench/accuracy/start.hpp"

namespace bagnold::accuracy {

namespace {

struct Collisions {
  std::vector<std::string> models{"CD", "CD_n", "CD_rot"}, schemes;
  std::vector<double> elasticities{0.1, 0.3, 0.5642, 1, 2, 10, 50, 500};
  std::vector<double> steps{0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005};
  int phases = 32;
};

/// Slow: the disks do not torque_per_diameter about one another, and overlaps are small.
constexpr double speed = 1e-6;

struct Collision {
  double restitution = 0, tangential = 0, duration = 0;
  double overlap_error = 0;  ///< largest while in contact, over the largest overlap there is
  bool ended = false;
};

/// The first step in contact comes `phase` dt after the touch; impact at `angle` to the normal.
Collision collide(Scene const& scene, Method const& method, double phase, double angle) {
  DampedContact const exact(scene);
  double const dt = method.time_step;
  double const normal = speed * std::cos(angle), along = speed * std::sin(angle);
  State start;
  start.box_length = 20;
  start.diameter = {1, 1};
  start.position = {{9, 10}, {10 + 2 * normal * dt * (1 - phase / 2), 10}};
  start.velocity = {{normal / 2, along / 2}, {-normal / 2, -along / 2}};
  start.spin = {0, 0};
  auto const system = make_system(scene, start, method);
  double const limit = std::min(2 * exact.duration(), 20.0);
  double largest = 0;
  for (double t = 0; t < std::min(exact.duration(), limit); t += limit / 1000)
    largest = std::max(largest, normal * exact.overlap(t));

  Collision c;
  double before = 0;
  for (long long n = 1; n * dt < limit + 3 * dt; ++n) {
    system->step(nullptr);
    State const now = system->state();
    double const overlap = 1 - (now.position[1][0] - now.position[0][0]);
    double const time = (static_cast<double>(n) - 2 + phase) * dt;
    if (overlap > 0 && time < exact.duration())
      c.overlap_error =
          std::max(c.overlap_error, std::abs(overlap - normal * exact.overlap(time)) / largest);
    if (overlap > 0) c.duration += dt;
    bool const apart = before > 0 && overlap <= 0;
    before = std::max(before, overlap);
    if (!apart) continue;
    system->step(nullptr);  // a predictor may still feel the contact
    State const after = system->state();
    c.restitution = (after.velocity[1][0] - after.velocity[0][0]) / normal;
    if (along != 0) c.tangential = (after.velocity[0][1] - after.velocity[1][1]) / along;
    c.ended = true;
    break;
  }
  return c;
}

void print_row(Scene const& scene, Method const& method, double angle, int phases) {
  DampedContact const exact(scene);
  double e = 0, e2 = 0, loss = 0, tangential = 0, duration = 0, overlap = 0, ended = 0;
  for (int k = 0; k < phases; ++k) {
    Collision const c = collide(scene, method, (k + 0.5) / phases, angle);
    double const off = c.restitution - exact.restitution();
    e += off / phases;
    e2 += off * off / phases;
    loss += (1 - c.restitution * c.restitution) / phases;
    tangential += (c.tangential - exact.tangential()) / phases;
    duration += c.duration / phases;
    overlap += c.overlap_error / phases;
    ended += c.ended ? 1.0 / phases : 0;
  }
  bool const returns = exact.frequency2 > 0 && ended == 1;
  fmt::print("{},{},{},{},{},{},", scene.disks.model, scene.disks.mass, scene.disks.elasticity,
             angle > 0 ? "oblique" : "head-on", method.scheme, method.time_step);
  if (returns) {
    double const whole = 1 - std::pow(exact.restitution(), 2);
    fmt::print("{:.6g},{:.3g},{:.3g},{:.3g},", exact.restitution(), e, std::sqrt(e2),
               loss / whole - 1);
    if (angle > 0) fmt::print("{:.3g}", tangential);
    fmt::print(",{:.3g},", duration / exact.duration() - 1);
  } else {
    fmt::print(",,,,,,");
  }
  fmt::print("{:.3g}\n", overlap);
}

void run(Collisions& o) {
  if (o.schemes.empty()) o.schemes.assign(scheme_names().begin(), scheme_names().end());
  fmt::print(
      "model,mass,Q,impact,scheme,dt,restitution,restitution_error,restitution_rms,loss_error,"
      "tangential_error,duration_error,overlap_error\n");
  for (auto const& model : o.models)
    for (double q : o.elasticities) {
      Scene scene;
      scene.disks.model = model;
      scene.disks.mass = model == "CD_n" ? "area" : "equal";
      scene.disks.elasticity = q;
      for (double angle : {0.0, 0.78539816339744831})
        for (auto const& scheme : o.schemes)
          for (double dt : o.steps) {
            Method method;
            method.scheme = scheme;
            method.time_step = dt;
            print_row(scene, method, angle, o.phases);
          }
    }
}

}  // namespace

void add_collision(CLI::App& app) {
  auto* const command =
      app.add_subcommand("collision", "two disks against the closed form, averaged over phases");
  auto const o = std::make_shared<Collisions>();
  command->add_option("--models", o->models)->delimiter(',')->capture_default_str();
  command->add_option("--schemes", o->schemes, "all if none")->delimiter(',');
  command->add_option("--q", o->elasticities)->delimiter(',')->capture_default_str();
  command->add_option("--dt", o->steps)->delimiter(',')->capture_default_str();
  command->add_option("--phases", o->phases, "of the step")->capture_default_str();
  command->callback([o] { run(*o); });
}

}  // namespace bagnold::accuracy
