// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "bench/accuracy/commands.hpp"
#include "bench/accuracy/contact_radius.hpp"
#include "bench/accuracy/start.hpp"

namespace bagnold::accuracy {

namespace {

/// The map of one contact.
struct Map {
  std::vector<std::string> models{"CD", "CD_n", "CD_rot"};
  int points = 60;
};

void run(Map& o) {
  fmt::print("model,mass,scheme,Q,dt,radius_normal,radius_tangential\n");
  for (auto const& model : o.models)
    for (auto const& scheme : scheme_names())
      for (int i = 0; i < o.points; ++i)
        for (int j = 0; j < o.points; ++j) {
          Scene scene;
          scene.disks.model = model;
          scene.disks.mass = model == "CD_n" ? "area" : "equal";
          scene.disks.elasticity = std::pow(10, -1.5 + 3.5 * i / (o.points - 1));
          double const dt = std::pow(10, -2.5 + 3 * static_cast<double>(j) / (o.points - 1));
          auto const r = contact_radius(scene, scheme, dt);
          fmt::print("{},{},{},{:.4g},{:.4g},{:.4g},{:.4g}\n", model, scene.disks.mass, scheme,
                     scene.disks.elasticity, dt, r.normal, r.tangential);
        }
}

/// The contacts of a state, frozen: damping alone, positions put back after each step.
struct Packing {
  Start start;
  std::vector<std::string> schemes;
  int steps = 300;
};

/// Whether small random velocities grow.
bool grows(Scene const& scene, State state, Method const& method, int steps) {
  std::uint64_t random = 88172645463325252ull;
  auto const next = [&random] {  // xorshift64, Marsaglia, J. Stat. Softw. 8, 14 (2003)
    random ^= random << 13;
    random ^= random >> 7;
    random ^= random << 17;
    return static_cast<double>(random >> 11) / (1ull << 53) - 0.5;
  };
  constexpr double small = 1e-12;
  for (auto& v : state.velocity) v = {small * next(), small * next()};
  for (auto& s : state.spin) s = small * next();
  auto const norm = [](State const& s) {
    double sum = 0;
    for (auto const& v : s.velocity) sum += v[0] * v[0] + v[1] * v[1];
    for (std::size_t i = 0; i < s.spin.size(); ++i)
      sum += std::pow(s.spin[i] * s.diameter[i], 2) / 8;
    return sum;
  };
  auto const system = make_system(scene, state, method);
  double const before = norm(state);
  for (int k = 0; k < steps; ++k) {
    system->step(nullptr);
    system->place(state);
    if (k % 10 == 0 && norm(system->state()) > 4 * before) return true;
  }
  return norm(system->state()) > before;
}

void run(Packing& o) {
  State const state = o.start.read();
  Scene& scene = o.start.scene;
  double const q = scene.disks.elasticity;
  scene.shear.strain_rate = 0;
  if (o.schemes.empty()) o.schemes.assign(scheme_names().begin(), scheme_names().end());
  fmt::print("model,mass,phi,scheme,arrangement,largest_dt_over_Q\n");
  for (auto const& text : o.schemes) {
    Method method = read_method(text + ":1");
    method.elastic = false;
    double low = 1e-3 * q, high = 20 * q;
    auto const unstable = [&](double dt) {
      method.time_step = dt;
      return grows(scene, state, method, o.steps);
    };
    bool const always = !unstable(high);
    while (!always && high / low > 1.01) {
      double const middle = std::sqrt(low * high);
      (unstable(middle) ? high : low) = middle;
    }
    auto const& a = method.arrangement;
    fmt::print("{},{},{},{},{}{},", scene.disks.model, scene.disks.mass,
               scene.disks.packing_fraction, method.scheme, a.packs ? "packs" : "index",
               a.tiles > 1 ? fmt::format(" {}x{}", a.tiles, a.tiles) : "");
    always ? fmt::print("inf\n") : fmt::print("{:.4g}\n", low / q);
  }
}

}  // namespace

void add_stability(CLI::App& app) {
  auto* const map = app.add_subcommand("stability", "spectral radius of a step, one contact");
  auto const o = std::make_shared<Map>();
  map->add_option("--models", o->models)->delimiter(',')->capture_default_str();
  map->add_option("--points", o->points, "along dt, and along Q")->capture_default_str();
  map->callback([o] { run(*o); });

  auto* const packing = app.add_subcommand(
      "packing", "largest step at which damping alone does not grow in the contacts of a state");
  auto const p = std::make_shared<Packing>();
  p->start.add_options(*packing);
  packing->add_option("--schemes", p->schemes, "all if none")->delimiter(',');
  packing->add_option("--steps", p->steps, "that growth has")->capture_default_str();
  packing->callback([p] { run(*p); });
}

}  // namespace bagnold::accuracy
