// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bench/accuracy/commands.hpp"
#include "bench/accuracy/contact_radius.hpp"
#include "bench/accuracy/start.hpp"

namespace bagnold::accuracy {

namespace {

/// The edge of stability of one contact in the plane of dt and Q.
struct Map {
  std::vector<std::string> models{"CD", "CD_n", "CD_rot"};
  int points = 41;
};

/// The first time step, going up, at which a contact makes energy; infinite beyond `most`.
double first_unstable(Scene const& scene, std::string const& scheme) {
  constexpr double least = 1e-3, most = 10, factor = 1.002;
  for (double dt = least; dt < most; dt *= factor) {
    auto const r = contact_radius(scene, scheme, dt);
    if (std::max(r.normal, r.tangential) > 1 + 1e-9) return dt;
  }
  return std::numeric_limits<double>::infinity();
}

void run(Map& o) {
  fmt::print("model,mass,scheme,Q,unstable_from_dt\n");
  for (auto const& model : o.models)
    for (auto const& scheme : scheme_names())
      for (int k = 0; k < o.points; ++k) {
        Scene scene;
        scene.disks.model = model;
        scene.disks.mass = model == "CD_n" ? "area" : "equal";
        scene.disks.elasticity = std::pow(10, -1.5 + 4.5 * k / (o.points - 1));
        fmt::print("{},{},{},{:.4g},{:.4g}\n", model, scene.disks.mass, scheme,
                   scene.disks.elasticity, first_unstable(scene, scheme));
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
  auto* const map = app.add_subcommand("stability", "time steps from which one contact grows");
  auto const o = std::make_shared<Map>();
  map->add_option("--models", o->models)->delimiter(',')->capture_default_str();
  map->add_option("--points", o->points, "along Q")->capture_default_str();
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
