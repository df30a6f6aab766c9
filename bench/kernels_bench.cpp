// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "kernels/device/dynamics/predict_correct.hpp"
#include "kernels/device/neighbors/verlet_list.hpp"
#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "kernels/physics/schemes/modified_velocity_verlet.hpp"
#include "src/config/scene_physics.hpp"
#include "src/config/skin.hpp"
#include "src/engine/device_copy.hpp"
#include "src/start/start.hpp"

namespace bagnold::bench {

using Space = Kokkos::Serial;

/// A dense scene with the papers' mass rule for its law. Overlaps are relaxed only roughly:
/// contacts abound, as in a Newtonian state.
inline Scene scene_of(std::string const& law, std::int64_t count) {
  Scene scene;
  scene.disks = {law, count, 0.82, 1.0, law == "CD_n" ? "area" : "equal"};
  scene.start.iterations = 300;
  scene.shear.strain_rate = 1e-4;
  return scene;
}

/// A start on the device with its list.
template <class Law>
struct Prepared {
  Scene scene;
  Kokkos::View<Vec2<Real>*, Space> position;
  Kokkos::View<Motion<Law::rotates>*, Space> motion;
  Kokkos::View<Species*, Space> species;
  SpeciesTable table;
  ShearedBox box;
  VerletList<Space> list;

  explicit Prepared(std::int64_t count) : scene(scene_of(std::string(Law::name), count)) {
    State const state = random_start(scene).state;
    position = to_device<Space>("bench::position", vectors(state.position));
    motion = to_device<Space>("bench::motion", motions<Law::rotates>(state));
    species = to_device<Space>("bench::species", species_of(state.diameter));
    table = make_species_table(scene.mass_by_area());
    box = {state.box_length, 0.0, scene.shear.strain_rate, state.box_height()};
    list.skin = skin(scene);
    list.at_build = position;
    build();
  }

  void build() { build_list(Space{}, list, species, table, box); }
};

/// Forces on all disks once, with the predictor's stores.
template <class Law>
void force(benchmark::State& run) {
  Prepared<Law> p(run.range(0));
  Kokkos::View<Vec2<Real>*, Space> trial_position("bench::trial_position", run.range(0));
  Kokkos::View<Motion<Law::rotates>*, Space> trial_motion("bench::trial_motion", run.range(0));
  Predict<Law, HarmonicRepulsion, Space, ModifiedVelocityVerlet> const predict{
      {p.position,
       p.motion,
       p.species,
       p.list.rows,
       p.table,
       p.box,
       make_law<Law>(p.scene.disks),
       {}},
      0.05,
      trial_position,
      trial_motion};
  for (auto _ : run) {
    Kokkos::parallel_for("bench::force", Kokkos::RangePolicy<Space>(0, run.range(0)), predict);
    Kokkos::fence();
  }
  run.SetItemsProcessed(run.iterations() * run.range(0));  // disks
}

/// A list from scratch.
void list_build(benchmark::State& run) {
  Prepared<CDn> p(run.range(0));
  for (auto _ : run) p.build();
  run.SetItemsProcessed(run.iterations() * run.range(0));  // disks
}

BENCHMARK_TEMPLATE(force, CD)->Arg(1024)->Arg(16384)->Arg(262144);
BENCHMARK_TEMPLATE(force, CDn)->Arg(1024)->Arg(16384)->Arg(262144);
BENCHMARK_TEMPLATE(force, CDrot)->Arg(1024)->Arg(16384)->Arg(262144);
BENCHMARK(list_build)->Arg(1024)->Arg(16384)->Arg(262144);

}  // namespace bagnold::bench
