// SPDX-License-Identifier: BSD-3-Clause
//
// No more than a scene needs: what is allocated for each law, engine and measurement, by the labels
// of Views (Kokkos' own tool callbacks) and by the heap (operator new, replaced in
// tests/support/heap.cpp).
#include <map>
#include <mutex>
#include <set>

#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/skin.hpp"
#include "src/engine/ensemble/ensemble_engine.hpp"
#include "src/measure/contacts.hpp"
#include "src/measure/make_frames.hpp"
#include "tests/support/heap.hpp"
#include "tests/support/simulations.hpp"

namespace bagnold::test {
namespace {

using Bytes = std::map<std::string, std::int64_t>;  ///< live bytes by label

std::mutex of_views;
Bytes views;

void allocated(Kokkos_Profiling_SpaceHandle, char const* label, void const*, std::uint64_t size) {
  std::scoped_lock const lock(of_views);
  views[label] += static_cast<std::int64_t>(size);
}
void freed(Kokkos_Profiling_SpaceHandle, char const* label, void const*, std::uint64_t size) {
  std::scoped_lock const lock(of_views);
  views[label] -= static_cast<std::int64_t>(size);
}

struct Allocated {
  Bytes views;      ///< by label, live ones
  double heap = 0;  ///< bytes, without the Views
};

Scene scene_of(std::string const& law, std::string const& engine, std::int64_t count = 2048) {
  Scene scene = small_scene(law, engine == "lookahead" ? 0.6 : 0.8, count);
  scene.integration.engine = engine;
  scene.integration.skin = 0.35;
  return scene;
}

/// One start for all laws.
State start_of(Scene scene) {
  static std::map<std::pair<double, std::int64_t>, State> made;
  bool const spins = scene.rotates();
  auto const [at, fresh] =
      made.try_emplace({scene.disks.packing_fraction, scene.disks.count}, State{});
  scene.disks.model = "CD_rot";
  scene.start.overlap = 1e-2;
  if (fresh) at->second = random_start(scene).state;
  State state = at->second;
  if (!spins) state.spin.clear();
  return state;
}

std::unique_ptr<Simulation> alone(Scene const& scene, State const& state) {
  return simulate(scene, state, backend_names().front());
}

/// The only system of an ensemble under CD.
template <class Scheme>
std::unique_ptr<Simulation> in_an_ensemble(Scene const& scene, State const& state) {
  using Space = std::tuple_element_t<0, Backends>;
  auto members = members_of(std::make_shared<EnsembleEngine<CD, HarmonicRepulsion, Space, Scheme>>(
      make_law<CD>(scene.disks), make_species_table(scene.mass_by_area()), scene.shear.strain_rate,
      time_step(scene), skin(scene), std::vector{first_snapshot(state)}));
  return std::move(members.front());
}

/// Whether Views lie on the heap, counted with it, as those of newer Kokkos do.
bool views_on_the_heap() {
  constexpr std::int64_t size = 1 << 20;
  auto const before = heap_bytes();
  Kokkos::View<char*, Kokkos::HostSpace> const view("test::view", size);
  return heap_bytes() - before >= size;
}

/// What a simulation holds after some steps of which one is evaluated.
Allocated held(Scene const& scene, bool contacts = false, decltype(alone)* make = alone) {
  State const state = start_of(scene);
  static bool const on_the_heap = views_on_the_heap();
  using namespace Kokkos::Tools::Experimental;
  views.clear();
  set_allocate_data_callback(allocated);
  set_deallocate_data_callback(freed);
  auto const before = heap_bytes();
  Allocated result;
  {
    auto const simulation = make(scene, state);
    OpenWindows windows;
    Frames frames;
    if (contacts)
      windows.contacts = watch_contacts(scene, make_plan(scene), simulation->columns(), 1, frames);
    simulation->advance(40, Sampling{1 << 20, 1 << 20, 1 << 20}, windows);
    result.heap = static_cast<double>(heap_bytes() - before);
    std::scoped_lock const lock(of_views);
    for (auto const& [label, bytes] : views)
      if (bytes != 0) result.views[label] = bytes;
    if (on_the_heap)
      for (auto const& [label, bytes] : result.views) result.heap -= static_cast<double>(bytes);
  }
  set_allocate_data_callback(nullptr);
  set_deallocate_data_callback(nullptr);
  return result;
}

struct PerDisk {
  double views, heap;  ///< [bytes]
};

/// What twice as many disks take more.
PerDisk per_disk(std::string const& law, std::string const& engine, bool contacts = false) {
  auto const few = held(scene_of(law, engine, 4096), contacts);
  auto const many = held(scene_of(law, engine, 8192), contacts);
  auto const sum = [](Bytes const& of) {
    double bytes = 0;
    for (auto const& [label, size] : of) bytes += static_cast<double>(size);
    return bytes;
  };
  return {(sum(many.views) - sum(few.views)) / 4096, (many.heap - few.heap) / 4096};
}

std::set<std::string> labels(Bytes const& bytes, std::string const& part = "") {
  std::set<std::string> found;
  for (auto const& [label, size] : bytes)
    if (label.find(part) != std::string::npos) found.insert(label);
  return found;
}

bool rotates(std::string const& law) { return small_scene(law).rotates(); }

TEST(Allocations, SpinsAreOnlyWhereTheLawRotates) {
  for (auto const& law : law_names())
    for (std::string const engine : {"few-contacts", "many-contacts", "lookahead"}) {
      std::set<std::string> expected;
      if (rotates(law)) expected = {"state::spin", "dynamics::trial_spin"};
      if (rotates(law) && engine == "lookahead")
        expected.insert({"islands::spin", "islands::trial_spin"});
      EXPECT_EQ(labels(held(scene_of(law, engine)).views, "spin"), expected)
          << law << ' ' << engine;
    }
}

/// In the reference engine: velocity alone, or velocity and spin.
TEST(Allocations, TheReferencesMotionIsThatOfTheLaw) {
  for (auto const& law : law_names()) {
    auto const scene = scene_of(law, "reference");
    auto const of = held(scene).views;
    for (auto const* label : {"state::motion", "dynamics::trial_motion"})
      EXPECT_EQ(of.at(label), scene.disks.count * (rotates(law) ? 24 : 16)) << law;
    EXPECT_EQ(of.at("state::position"), scene.disks.count * 16);
  }
}

/// Beyond the spins, laws of one engine hold the same bytes: their forces in scratch and their sums
/// differ, nothing a disk.
TEST(Allocations, LawsDifferInNothingElse) {
  for (std::string const engine : {"few-contacts", "many-contacts"}) {
    Bytes const plain = held(scene_of("CD", engine)).views;
    for (auto const& law : law_names()) {
      Bytes of = held(scene_of(law, engine)).views;
      auto const slots = of.at("state::record") / 32;
      EXPECT_EQ(of.at("dynamics::trial_record"), 32 * slots);
      EXPECT_EQ(of.at("neighbors::at_build"), 16 * slots);
      EXPECT_NEAR(static_cast<double>(of.at("state::species")), slots, 8);  // Kokkos rounds up
      for (auto const* label : {"state::spin", "dynamics::trial_spin"})
        if (rotates(law)) {
          EXPECT_EQ(of.at(label), 8 * slots) << law << ' ' << label;
          of.erase(label);
        }
      EXPECT_EQ(labels(of), labels(plain)) << law << ' ' << engine;
      for (auto const& [label, bytes] : plain) {
        if (label == "simulation::scratch" || label == "observables::block_sums") continue;
        EXPECT_EQ(of[label], bytes) << law << ' ' << engine << ' ' << label;
      }
    }
  }
}

TEST(Allocations, ArraysOfAWayOfSteppingAreOnlyThere) {
  std::set<std::string> const of_dense{"steps::active", "steps::active_count", "steps::contacts",
                                       "steps::is_active"};
  for (auto const& law : law_names())
    for (std::string const engine : {"reference", "few-contacts", "many-contacts", "lookahead"}) {
      auto const found = labels(held(scene_of(law, engine)).views);
      for (auto const& label : of_dense)
        EXPECT_EQ(found.contains(label), engine == "few-contacts")
            << law << ' ' << engine << ' ' << label;
      EXPECT_EQ(!labels(held(scene_of(law, engine)).views, "islands::").empty(),
                engine == "lookahead")
          << law << ' ' << engine;
      EXPECT_EQ(found.contains("dynamics::trial_position"), engine == "reference");
      EXPECT_EQ(found.contains("dynamics::trial_record"), engine != "reference");
    }
}

/// Two stages keep which contacts a disk has and a table of shares, the papers' scheme does not.
TEST(Allocations, AStepKeepsWhatItsSchemeUses) {
  Scene papers = scene_of("CD", "reference"), two_stages = papers;
  two_stages.integration.scheme = two_stage_scheme;
  std::set<std::string> const of_papers{"dynamics::trial_position", "dynamics::trial_motion"};
  std::set<std::string> of_two_stages = of_papers;
  of_two_stages.insert({"dynamics::contacts", "dynamics::touching", "dynamics::second_stage"});
  auto const found = [](Scene const& scene, decltype(alone)* make) {
    return labels(held(scene, false, make).views, "dynamics::");
  };
  EXPECT_EQ(found(papers, alone), of_papers);
  EXPECT_EQ(found(two_stages, alone), of_two_stages);
  EXPECT_EQ(found(papers, in_an_ensemble<ModifiedVelocityVerlet>), of_papers);
  EXPECT_EQ(found(two_stages, in_an_ensemble<TwoStageLeapfrog>), of_two_stages);
}

/// Off the Views an engine keeps the diameters that files want, 8 bytes a disk; room by slot for
/// windows only where there are windows, that for contacts only where these are asked for.
TEST(Allocations, TheHeapHasDiametersAndWhatIsAskedFor) {
  for (std::string const engine : {"reference", "few-contacts", "many-contacts", "lookahead"}) {
    double const plain = per_disk("CD_n", engine).heap;
    double const observed = per_disk("CD_n", engine, true).heap;
    RecordProperty(engine + "_heap", std::to_string(plain));
    RecordProperty(engine + "_heap_with_contacts", std::to_string(observed));
    if (engine == "lookahead")
      EXPECT_GT(plain, 8 + 9);  // whose result, in which batch, which node
    else
      EXPECT_NEAR(plain, 8, 0.5) << engine;
    EXPECT_GT(observed, plain + 1) << engine;
  }
}

/// A law that rotates takes at least its two spins a disk more, and in blocks not many more: halos.
/// The reference engine keeps the sums of each disk, which are more for such a law.
TEST(Allocations, ViewsADiskAreThoseOfTheLaw) {
  for (std::string const engine : {"reference", "few-contacts", "many-contacts", "lookahead"}) {
    std::map<std::string, double> views;
    for (auto const& law : law_names()) {
      views[law] = per_disk(law, engine).views;
      RecordProperty(engine + "_" + law + "_views", std::to_string(views[law]));
    }
    double const islands = engine == "lookahead" ? 5 : 0.01;  // these depend on what meets
    EXPECT_NEAR(views["CD"], views["CD_n"], islands) << engine;
    EXPECT_NEAR(views["CD_rot"], views["CD_nt"], islands) << engine;
    EXPECT_GT(views["CD_rot"], views["CD"] + 15) << engine;
    double const sums =
        engine == "reference" ? double(sizeof(Sums<true>)) - double(sizeof(Sums<false>)) : 0;
    EXPECT_LT(views["CD_rot"], views["CD"] + 24 + sums) << engine;
    EXPECT_LT(views["CD_rot"], engine == "reference" ? 292 : 260) << engine;
  }
}

/// No frames, no memory for them.
TEST(Allocations, FramesTakeNoneUnlessAskedFor) {
  auto const heap = [](Scene const& scene) {
    State const state = start_of(scene);
    auto const before = heap_bytes();
    Frames const frames = make_frames(scene, make_plan(scene), state,
                                      std::filesystem::temp_directory_path() / "none.h5md", "0");
    return heap_bytes() - before;
  };
  Scene scene = scene_of("CD", "reference");
  EXPECT_EQ(heap(scene), 0);
  scene.measure.profiles = true;
  EXPECT_GT(heap(scene), 0);
}

}  // namespace
}  // namespace bagnold::test
