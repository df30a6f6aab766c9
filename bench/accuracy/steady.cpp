// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <ctime>

#include "bench/accuracy/precision.hpp"
#include "bench/accuracy/schemes/all.hpp"
#include "kernels/core/kokkos_compat.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/state_file.hpp"
#include "src/simulation/laws.hpp"
#include "src/simulation/observables.hpp"
#include "src/start/start.hpp"
#include "src/statistics/estimate.hpp"

using namespace bagnold;
using namespace bagnold::accuracy;

struct Options {
  std::string state, scheme = "heun", model = "CD_n", mass = "equal", precision = "double";
  double phi = 0.78, q = 1, rate = 1e-3, dt = 0.05, strain = 10, discard = 1, skin = 0.35;
  int every = 0, tiles = 1;
  bool packs = false, header = false;
  std::string schemes; double stretch = 0; int starts = 10; double dtref = 0.2/64; double gapstrain = 0.05;
};

double cpu() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

/// Means over a stretch and the end, by one scheme.
template <class W>
struct Stretch { Sample mean; typename W::Positions end; };

template <class W, class L>
Stretch<W> go(W const& from, L law, Options const& o, std::string const& name, double dt, bool packs, int tiles) {
  W w(law, from.table, from.state(), o.rate, dt);
  w.arrangement = {packs, tiles};
  Stretch<W> r;
  auto const steps = std::llround(o.stretch / (o.rate * dt));
  long long const burn = std::llround(0.2 * steps);
  if (name != "heun" && name != "gw" && name != "lag") {  // their v is that of half a step before
    typename W::Touches touches;
    w.find_touches(w.position, 0, touches);
    auto const felt = w.motion;
    kick_elastic(w, touches, -dt / 2, w.motion);
    kick_dissipative(w, touches, -dt / 2, felt, w.motion);
  }
  with_scheme<W>(name, [&](auto scheme) {
    for (long long k = 0; k < steps; ++k) scheme.step(w, k >= burn ? &r.mean : nullptr);
  });
  for (auto& v : r.mean.value) v /= (steps - burn);
  // unwrap by nothing: positions as kept, compared modulo box in caller
  r.end = w.position;
  return r;
}

template <class Law, class P>
void bias(Options const& o) {
  Scene scene;
  scene.disks.model = o.model;
  scene.disks.packing_fraction = o.phi;
  scene.disks.elasticity = o.q;
  scene.disks.mass = o.mass;
  scene.shear.strain_rate = o.rate;
  auto states = io::read_states(o.state);
  states.resize(1);
  scene.disks.count = static_cast<std::int64_t>(states[0].count());
  auto const state = fit_to_scene(std::move(states), scene)[0].state;
  using W = World<Law, HarmonicRepulsion, P>;
  auto const law = make_law<Law>(scene.disks);
  W world(law, make_species_table(scene.mass_by_area()), state, o.rate, o.dt);
  std::vector<std::pair<std::string, double>> cases;
  std::stringstream in(o.schemes);
  for (std::string word; std::getline(in, word, ',');) {
    auto const colon = word.find(':');
    cases.emplace_back(word.substr(0, colon), std::stod(word.substr(colon + 1)));
  }
  struct Dev { std::vector<double> v[6]; };
  std::vector<Dev> devs(cases.size());
  auto const f = [&](Sample const& m, int k) {
    auto const& a = m.value;
    switch (k) {
      case 0: return a[SumColumns::elastic_xx] + a[SumColumns::elastic_yy];
      case 1: return -(a[SumColumns::elastic_xy] + a[SumColumns::dissipative_xy] + a[SumColumns::kinetic_xy]);
      case 2: return a[SumColumns::contacts];
      case 3: return a[SumColumns::kinetic_xx] + a[SumColumns::kinetic_yy];
      default: return a[Sample::dissipated];
    }
  };
  double scale[6] = {};
  W main = world;
  with_scheme<W>(o.scheme, [&](auto scheme) {
    for (int n = 0; n < o.starts; ++n) {
      auto const steps = std::llround((n == 0 ? o.discard : o.gapstrain) / (o.rate * o.dt));
      for (long long k = 0; k < steps; ++k) scheme.step(main, nullptr);
      auto const ref = go<W>(main, law, o, "heun", o.dtref, false, 1);
      for (int q = 0; q < 5; ++q) scale[q] += f(ref.mean, q) / o.starts;
      for (std::size_t c = 0; c < cases.size(); ++c) {
        auto name = cases[c].first;
        bool const packs = name.find("+p") != std::string::npos;
        int tiles = 1;
        if (auto t = name.find("+t"); t != std::string::npos) tiles = std::stoi(name.substr(t + 2));
        name = name.substr(0, name.find('+'));
        try {
          auto const r = go<W>(main, law, o, name, cases[c].second, packs, tiles);
          for (int q = 0; q < 5; ++q) devs[c].v[q].push_back(f(r.mean, q) - f(ref.mean, q));
          double d2 = 0;
          double const L = main.clock.box_length;
          for (std::size_t i = 0; i < main.size(); ++i) {
            double dy = r.end[i].y - ref.end[i].y, dx = r.end[i].x - ref.end[i].x;
            double const ny = std::round(dy / L);
            dy -= ny * L;
            double const off = main.clock.offset(main.step, main.step) + o.stretch * L;
            dx -= ny * off; dx -= std::round(dx / L) * L;
            d2 += dx * dx + dy * dy;
          }
          devs[c].v[5].push_back(std::sqrt(d2 / main.size()));
        } catch (std::exception const&) { devs[c].v[0].push_back(NAN); }
      }
    }
  });
  scale[5] = 1;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    fmt::print("{:24} {:6}", cases[c].first, cases[c].second);
    char const* names[] = {"p_el", "sigma", "Z", "T_g", "diss", "rms"};
    for (int q = 0; q < 6; ++q) {
      double m = 0, s = 0;
      auto const& v = devs[c].v[q];
      for (double x : v) m += x / v.size();
      for (double x : v) s += (x - m) * (x - m);
      s = std::sqrt(s / v.size() / (v.size() - 1));
      if (q < 5) fmt::print("  {} {:+7.2f}({:.2f})%", names[q], 100 * m / scale[q], 100 * s / scale[q]);
      else fmt::print("  rms {:.2e}", m);
    }
    fmt::print("\n");
  }
}

template <class Law, class P>
void run(Options const& o) {
  if (o.stretch > 0) return bias<Law, P>(o);
  Scene scene;
  scene.disks.model = o.model;
  scene.disks.packing_fraction = o.phi;
  scene.disks.elasticity = o.q;
  scene.disks.mass = o.mass;
  scene.shear.strain_rate = o.rate;
  scene.integration.time_step = o.dt;
  auto states = io::read_states(o.state);
  states.resize(1);
  scene.disks.count = static_cast<std::int64_t>(states[0].count());
  auto const state = fit_to_scene(std::move(states), scene)[0].state;
  using W = World<Law, HarmonicRepulsion, P>;
  W world(make_law<Law>(scene.disks), make_species_table(scene.mass_by_area()), state, o.rate, o.dt);
  world.arrangement = {o.packs, o.tiles};
  world.skin = o.skin;
  auto const steps = [&](double strain) { return std::llround(strain / (o.rate * o.dt)); };
  int const every = o.every > 0 ? o.every : std::max<int>(1, std::lround(0.2 / o.dt));
  auto const window = std::max<long long>(every, steps(0.02) / every * every);
  with_scheme<W>(o.scheme, [&](auto scheme) {
    for (long long k = 0; k < steps(o.discard); ++k) scheme.step(world, nullptr);
    world.counts = {};
    double const begin = cpu();
    statistics::Windows windows;
    windows.columns = Sample::count;
    Sample sum, first, last;
    long long weight = 0, samples = 0;
    for (long long k = 0; k < steps(o.strain); ++k) {
      if (k % every == 0) {
        Sample s;
        scheme.step(world, &s);
        if (samples++ == 0) first = s;
        last = s;
        for (int c = 0; c < Sample::count; ++c) sum.value[c] += s.value[c];
        if (++weight == window / every) {
          windows.push_back(sum.value, static_cast<double>(weight));
          sum = {};
          weight = 0;
        }
      } else {
        scheme.step(world, nullptr);
      }
    }
    double const seconds = cpu() - begin;
    auto const& c = world.counts;
    double const strain = static_cast<double>(c.steps) * o.rate * o.dt;
    if (o.header)
      fmt::print("model,phi,Q,rate,scheme,precision,arrangement,dt,strain,searches_per_strain,passes_per_strain,cpu_per_strain,gap");
    auto const list = observables(scene, state.box_length);
    char const* names[] = {"B_p", "B_p_el","B_p_dis", "B_p_kin", "B_sigma", "Z", "mu", "T_g", "R_v"};
    if (o.header) {
      for (auto n : names) fmt::print(",{},{}_error", n, n);
      fmt::print("\n");
    }
    auto const mean = windows.mean(0, windows.size());
    double const energy = last.value[Sample::kinetic_energy] + last.value[Sample::elastic_energy] -
                          first.value[Sample::kinetic_energy] - first.value[Sample::elastic_energy];
    double const work = -(mean[SumColumns::elastic_xy] + mean[SumColumns::dissipative_xy] + mean[SumColumns::kinetic_xy]) * o.rate;
    double const time = static_cast<double>(samples - 1) * every * o.dt;
    double const gap = (work - mean[Sample::dissipated] - energy / time) / work;
    fmt::print("{},{},{},{},{},{},{}{},{},{:.4g},{:.0f},{:.0f},{:.3g},{:.5f}", o.model, o.phi, o.q, o.rate,
               o.scheme, P::name, o.packs ? "packs" : "index", o.tiles, o.dt, strain, c.searches / strain,
               c.damping_passes / strain, seconds / strain, gap);
    for (auto n : names)
      for (auto const& ob : list)
        if (ob.name == n) {
          auto const e = statistics::estimate(windows, 0, ob.value);
          fmt::print(",{:.6g},{:.3g}", e.mean.value_or(NAN), e.error.value_or(NAN));
        }
    fmt::print("\n");
  });
}

template <class P>
void with_law(Options const& o) {
  if (o.model == "CD") run<CD, P>(o);
  if (o.model == "CD_n") run<CDn, P>(o);
  if (o.model == "CD_rot") run<CDrot, P>(o);
}

int main(int argc, char** argv) {
  Options o;
  CLI::App app("accuracy");
  app.add_option("--state", o.state)->required();
  app.add_option("--scheme", o.scheme);
  app.add_option("--model", o.model);
  app.add_option("--mass", o.mass);
  app.add_option("--precision", o.precision);
  app.add_option("--phi", o.phi);
  app.add_option("--q", o.q);
  app.add_option("--rate", o.rate);
  app.add_option("--dt", o.dt);
  app.add_option("--strain", o.strain);
  app.add_option("--discard", o.discard);
  app.add_option("--every", o.every);
  app.add_option("--skin", o.skin);
  app.add_option("--tiles", o.tiles);
  app.add_flag("--packs", o.packs);
  app.add_flag("--header", o.header);
  app.add_option("--schemes", o.schemes);
  app.add_option("--stretch", o.stretch);
  app.add_option("--starts", o.starts);
  app.add_option("--dtref", o.dtref);
  app.add_option("--between", o.gapstrain);
  CLI11_PARSE(app, argc, argv);
  initialize_kokkos(1);
  int status = 0;
  try {
    if (o.precision == "double") with_law<DoublePrecision>(o);
  } catch (std::exception const& e) {
    fmt::print("{},{},{},{},{},{},{}{},{},FAILED {}\n", o.model, o.phi, o.q, o.rate, o.scheme, o.precision, o.packs ? "packs" : "index", o.tiles, o.dt, e.what());
    status = 3;
  }
  Kokkos::finalize();
  return status;
}
