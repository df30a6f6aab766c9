// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/sweep_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "src/analysis/curves.hpp"
#include "src/analysis/quantity.hpp"
#include "src/config/errors.hpp"
#include "src/config/scene_file.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_writer.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::analysis {
namespace {

constexpr std::size_t count = 3;

/// Two keys, one observable.
void put_good(io::Hdf5Writer& file) {
  file.group("/points");
  file.group("/observables");
  file.dataset("/points/disks.elasticity", std::vector<double>{1, 10, 100}, {count});
  file.dataset("/points/disks.seed", std::vector<std::int64_t>{1, 1, 2}, {count});
  file.dataset("/points/folder", std::vector<double>{0, 1, 2}, {count});  // no key
  file.dataset("/observables/p", std::vector<double>{1, 2, std::nan("")}, {count});
  file.dataset("/observables/p_error", std::vector<double>{0.1, 0.2, std::nan("")}, {count});
}

class SweepTableFile : public testing::Test {
 protected:
  SweepTable table(std::function<void(io::Hdf5Writer&)> const& put) {
    io::Hdf5Writer file;
    put(file);
    io::replace_file(folder_ / "sweep.h5", file.content());
    return read_sweep_table(folder_.path());
  }

  void refuses(std::function<void(io::Hdf5Writer&)> const& put, std::string const& reason) {
    try {
      table(put);
      ADD_FAILURE() << "accepted; expected: " << reason;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  /// The good file, changed by HDF5 itself.
  void refuses_changed(std::function<void(hid_t)> const& change, std::string const& reason) {
    io::Hdf5Writer file;
    put_good(file);
    io::replace_file(folder_ / "sweep.h5", file.content());
    hid_t const open = H5Fopen((folder_ / "sweep.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(open);
    H5Fclose(open);
    try {
      read_sweep_table(folder_ / "sweep.h5");
      ADD_FAILURE() << "accepted; expected: " << reason;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  io::TestFolder folder_;
};

TEST_F(SweepTableFile, IsRead) {
  auto const found = table(put_good);
  EXPECT_EQ(found.points, count);
  EXPECT_EQ(found.numbers("disks.elasticity"), (std::vector<double>{1, 10, 100}));
  EXPECT_EQ(found.numbers("disks.seed"), (std::vector<double>{1, 1, 2}));
  EXPECT_EQ(found.keys.size(), 2u);
  EXPECT_EQ(found.observables.size(), 1u);
  EXPECT_EQ(found.observables.at("p").error[1], 0.2);
  EXPECT_FALSE(found.failed(0));
  EXPECT_TRUE(found.failed(2));
}

TEST_F(SweepTableFile, HasNoValuesOfDisksThatHardlyMet) {
  auto const put = [](io::Hdf5Writer& file) {
    put_good(file);
    file.texts("/warnings",
               std::vector<std::string>{"steady_state", "box_size few_collisions", ""});
  };
  auto const found = table(put);
  EXPECT_EQ(found.hardly_met, 1u);
  EXPECT_FALSE(found.failed(0));
  EXPECT_TRUE(found.failed(1));
  EXPECT_TRUE(std::isnan(found.observables.at("p").error[1]));

  io::replace_text(folder_ / "sweep.csv",
                   "disks.seed,B_p,B_p_error,warnings\n1,9e-33,0,few_collisions\n2,12,0.4,\n");
  auto const text = read_sweep_table(folder_ / "sweep.csv");
  EXPECT_EQ(text.hardly_met, 1u);
  EXPECT_TRUE(text.failed(0));
  EXPECT_EQ(text.observables.at("B_p").mean[1], 12);
}

TEST_F(SweepTableFile, KeysThatWereNotVariedAreInTheScenes) {
  Scene scene;
  scene.disks = {"CD", 64, 0.8, 1.0, "equal"};
  scene.shear.strain_rate = 1e-4;
  scene.shear.strain = 1.0;
  auto found = table(put_good);
  found.scenes.assign(count, write_scene(scene));
  EXPECT_EQ(found.numbers("shear.strain_rate"), std::vector<double>(count, 1e-4));
  EXPECT_EQ(found.numbers("disks.count"), std::vector<double>(count, 64));
  EXPECT_THROW(found.numbers("disks.model"), InputError);
  EXPECT_THROW(found.numbers("disks.elasticty"), InputError);
}

TEST_F(SweepTableFile, OddFilesAreRefused) {
  refuses([](auto& file) { file.group("/points"); }, "/observables is missing");
  refuses([](auto&) {}, "/points is missing");
  refuses(
      [](auto& file) {
        put_good(file);
        file.dataset("/observables/mu", std::vector<double>{1, 2}, {2});
      },
      "has the shape [2] (must be [3])");
  refuses(
      [](auto& file) {
        put_good(file);
        file.dataset("/points/disks.count", std::vector<double>{1, 2, std::nan("")}, {count});
      },
      "/points/disks.count = nan (must be finite)");
  refuses(
      [](auto& file) {
        file.group("/points");
        file.group("/observables");
        file.dataset("/points/disks.count", std::vector<double>{}, {0});
      },
      "no row of values");
  refuses(
      [](auto& file) {
        put_good(file);
        file.text("/points/disks.model", "CD");
      },
      "must be [3]");
  EXPECT_THROW(read_sweep_table(folder_ / "nothing.h5"), InputError);
  io::replace_file(folder_ / "sweep.h5", io::bytes_of("not HDF5"));
  EXPECT_THROW(read_sweep_table(folder_.path()), InputError);
}

TEST_F(SweepTableFile, HostileFilesAreRefused) {
  refuses_changed(
      [](hid_t file) {
        H5Lcreate_external("/etc/passwd", "/", file, "/observables/mu", H5P_DEFAULT, H5P_DEFAULT);
      },
      "soft or external link");
  refuses_changed(
      [](hid_t file) {
        hsize_t const rows = count;
        io::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type.get(), H5T_VARIABLE);
        io::Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
        io::Handle made(H5Dcreate2(file, "/points/disks.model", type.get(), space.get(),
                                   H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
      },
      "/points/disks.model");
  refuses_changed(
      [](hid_t file) {
        hsize_t const rows = hsize_t{1} << 45;
        io::Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
        io::Handle made(H5Dcreate2(file, "/observables/mu", H5T_IEEE_F64LE, space.get(),
                                   H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
      },
      "more than the");
}

class CsvTable : public testing::Test {
 protected:
  SweepTable table(std::string const& text, std::string const& name = "made.csv") {
    io::replace_file(folder_ / name, io::bytes_of(text));
    return read_sweep_table(folder_ / name);
  }

  io::TestFolder folder_;
};

TEST_F(CsvTable, IsReadAsTheFileIs) {
  auto const found = table(
      "disks.elasticity,disks.model,p,p_error,mu,rough_errors\n1,CD,0.5,0.1,0.3,p mu\r\n"
      "10,\"C,\"\"D\",,,0.2,\n");
  EXPECT_EQ(found.points, 2u);
  EXPECT_EQ(found.numbers("disks.elasticity"), (std::vector<double>{1, 10}));
  EXPECT_EQ(found.keys.at("disks.model").texts, (std::vector<std::string>{"CD", "C,\"D"}));
  EXPECT_EQ(found.observables.at("p").mean[0], 0.5);
  EXPECT_EQ(found.observables.at("p").error[0], 0.1);
  EXPECT_TRUE(std::isnan(found.observables.at("p").mean[1]));
  EXPECT_TRUE(std::isnan(found.observables.at("mu").error[1]));
  EXPECT_EQ(found.observables.size(), 2u);
}

/// Rows of pieces.csv are of different flows, no seeds of one.
TEST_F(CsvTable, ThePieceIsAKey) {
  auto const found = table("disks.seed,piece,p\n1,1,1.0\n1,2,0.1\n2,1,1.2\n2,2,0.1\n");
  EXPECT_EQ(found.numbers("piece"), (std::vector<double>{1, 2, 1, 2}));
  EXPECT_FALSE(found.observables.contains("piece"));
  EXPECT_EQ(seed_groups(found), (std::vector<std::vector<std::size_t>>{{0, 2}, {1, 3}}));
}

/// A column of a ratio is an observable, and stands for itself where its parts are not there.
TEST_F(CsvTable, ARatioIsNoKey) {
  auto const alone = table("disks.seed,Z/shear.strain_rate,Z/shear.strain_rate_error\n1,30,2\n");
  EXPECT_EQ(alone.keys.size(), 1u);
  std::vector<std::size_t> const row{0};
  auto const ratio = Quantity(alone, "Z/shear.strain_rate").of(row);
  EXPECT_EQ(ratio.mean, 30.0);
  EXPECT_EQ(ratio.error, 2.0);
  auto const halves = Quantity(alone, "Z/shear.strain_rate/disks.seed").of(row);
  EXPECT_EQ(halves.mean, 30.0);
  EXPECT_THROW(Quantity(alone, "Z/T_g"), InputError);
}

/// As spreadsheets write them.
TEST_F(CsvTable, MayHaveAByteOrderMarkAndBlankLines) {
  auto const found = table(
      "\xEF\xBB\xBF"
      "disks.seed,p\r\n1,2\r\n\r\n2,3\r\n\n");
  EXPECT_EQ(found.numbers("disks.seed"), (std::vector<double>{1, 2}));
  EXPECT_EQ(found.observables.at("p").mean, (std::vector<double>{2, 3}));
}

TEST_F(CsvTable, OddOnesAreRefused) {
  EXPECT_THROW(table(""), InputError);
  EXPECT_THROW(table("disks.seed,p\n"), InputError);
  EXPECT_THROW(table("disks.seed,p\n1\n"), InputError);
  EXPECT_THROW(table("disks.seed,p\n1,2,3\n"), InputError);
  EXPECT_THROW(table("disks.seed,p\n1,nan\n"), InputError);
  EXPECT_THROW(table("disks.seed,p\n1,two\n"), InputError);
  EXPECT_THROW(table("disks.seed,p\n1,\"2\n"), InputError);
  EXPECT_THROW(table("disks.seed,p,p\n1,2,3\n"), InputError);
  try {
    table("disks.elasticity,p\n1,2\n,3\n").numbers("disks.elasticity");
    ADD_FAILURE() << "accepted";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("fill in the empty cells"), std::string::npos)
        << error.what();
  }
}

/// Texts of a sweep that look like numbers are texts.
TEST(SweepTable, NumbersWrittenAsTextsAreNone) {
  SweepTable table;
  table.points = 2;
  table.keys["start.file"].texts = {"1", "2"};
  EXPECT_THROW(table.numbers("start.file"), InputError);
}

TEST_F(CsvTable, SeveralSweepsAreOne) {
  auto const base = table("disks.elasticity,disks.seed,p\n1,1,0.5\n10,1,0.6\n");
  auto const finer = table("disks.seed,disks.elasticity,mu\n2,3,0.4\n", "finer.csv");
  auto const merged = merge_tables({base, finer});
  EXPECT_EQ(merged.points, 3u);
  EXPECT_EQ(merged.numbers("disks.elasticity"), (std::vector<double>{1, 10, 3}));
  EXPECT_EQ(merged.observables.at("p").mean[1], 0.6);
  EXPECT_TRUE(std::isnan(merged.observables.at("p").mean[2]));
  EXPECT_EQ(merged.observables.at("mu").mean[2], 0.4);
  auto const again = table("disks.elasticity,disks.seed,p\n10,1,0.6\n", "again.csv");
  EXPECT_THROW(merge_tables({base, again}), InputError);
  auto const other = table("disks.elasticity,p\n10,0.6\n", "other.csv");
  EXPECT_THROW(merge_tables({base, other}), InputError);  // of which seed?
}

TEST_F(SweepTableFile, SweepsOfOneKeyEachAreMergedByTheirScenes) {
  auto base = table(put_good);
  Scene scene;
  scene.disks = {"CD", 64, 0.8, 1.0, "equal"};
  scene.shear.strain_rate = 1e-4;
  scene.shear.strain = 1.0;
  base.scenes.assign(count, write_scene(scene));
  auto other = base;
  other.keys["disks.packing_fraction"].numbers = {0.7, 0.71, 0.72};
  auto const merged = merge_tables({base, other});
  EXPECT_EQ(merged.numbers("disks.packing_fraction"),
            (std::vector<double>{0.8, 0.8, 0.8, 0.7, 0.71, 0.72}));
}

class MergedSweeps : public SweepTableFile {
 protected:
  /// put_good as a sweep of this scene.
  SweepTable sweep_of(Scene const& scene) {
    auto found = table(put_good);
    found.scenes.assign(count, write_scene(scene));
    return found;
  }

  static Scene scene_of(std::string const& protocol) {
    Scene scene;
    scene.disks = {"CD", 64, 0.8, 1.0, "equal"};
    scene.shear.protocol = protocol;
    scene.shear.strain_rate = 1e-4;
    scene.shear.strain = 1.0;
    return scene;
  }
};

/// What is held or how the rate changes tells flows apart, how long they last does not.
TEST_F(MergedSweeps, AreToldApartByHowTheyAreSheared) {
  auto held = scene_of("pressure"), other = held;
  held.shear.pressure = 1e-2;
  other.shear.pressure = 1e-3;
  EXPECT_EQ(merge_tables({sweep_of(held), sweep_of(other)}).numbers("shear.pressure"),
            (std::vector<double>{1e-2, 1e-2, 1e-2, 1e-3, 1e-3, 1e-3}));
  auto stress = scene_of("stress");
  stress.shear.time = 1e4;
  auto stresses = stress;
  stress.shear.stress = NumberOrList({1e-3, 2e-3});
  stresses.shear.stress = NumberOrList({1e-3, 3e-3});
  auto const merged = merge_tables({sweep_of(stress), sweep_of(stresses)});
  EXPECT_EQ(merged.keys.at("shear.stress").texts[0], "[0.001, 0.002]");
  EXPECT_EQ(merged.keys.at("shear.stress").texts[count], "[0.001, 0.003]");
  auto const once = scene_of("steady");
  auto longer = once;
  longer.shear.strain = 2.0;
  EXPECT_THROW(merge_tables({sweep_of(once), sweep_of(longer)}), InputError);
}

/// A sweep that varies the model, and one that does not: in any order.
TEST_F(MergedSweeps, TextsThatDoNotVaryAreInTheScenes) {
  auto varied = sweep_of(scene_of("steady")), constant = varied;
  varied.keys["disks.model"].texts = {"CD_n", "CD_rot", "CD_nt"};
  for (auto& seed : constant.keys["disks.seed"].numbers) seed += 10;
  EXPECT_EQ(merge_tables({varied, constant}).keys.at("disks.model").texts[count], "CD");
  auto const merged = merge_tables({constant, varied}).keys.at("disks.model");
  EXPECT_EQ(merged.texts, (std::vector<std::string>{"CD", "CD", "CD", "CD_n", "CD_rot", "CD_nt"}));
  EXPECT_TRUE(merged.numbers.empty());
}

/// Sweeps of two models or packing fractions at rates of which none is in both are not one curve.
TEST_F(MergedSweeps, AreNotOneCurveWhereNoRateIsInBoth) {
  auto fast = scene_of("steady"), slow = fast;
  slow.disks.model = "CD_n";
  auto denser = fast;
  denser.disks.packing_fraction = 0.82;
  for (auto const& other : {slow, denser}) {
    auto at_fast = sweep_of(fast), at_slow = sweep_of(other);
    at_fast.keys.erase("disks.elasticity");
    at_slow.keys.erase("disks.elasticity");
    at_fast.keys["shear.strain_rate"].numbers = {1e-3, 5e-4, 2e-4};
    at_slow.keys["shear.strain_rate"].numbers = {1e-4, 5e-5, 2e-5};
    auto const curves = curves_of(merge_tables({at_fast, at_slow}), {"shear.strain_rate"});
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].data.size(), count);
    EXPECT_EQ(curves[0].labels.size(), 1u);
  }
}

/// At given I the rate follows from the pressure: sweeps at other pressures are one curve.
TEST_F(MergedSweeps, AtOneInertialNumberAreOneCurve) {
  auto loose = scene_of("pressure");
  loose.shear.inertial_number = 0.3;
  loose.shear.pressure = 1e-4;
  loose.shear.strain_rate = 3e-3;
  auto tight = loose;
  tight.shear.pressure = 4e-4;
  tight.shear.strain_rate = 6e-3;
  auto one = sweep_of(loose), other = sweep_of(tight);
  for (auto* table : {&one, &other}) {
    table->keys.erase("disks.elasticity");
    table->keys["disks.seed"].numbers = {1, 2, 3};
  }
  auto const curves = curves_of(merge_tables({one, other}), {"shear.pressure"});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].labels.empty());
  EXPECT_EQ(curves[0].data.size(), 2u);
}

TEST_F(MergedSweeps, OfReplicasThatAreInBothAreRefused) {
  auto scene = scene_of("steady");
  scene.disks.replicas = 4;
  auto const first = sweep_of(scene);
  auto second = first;
  second.keys["disks.seed"].numbers = {4, 4, 5};  // the systems 1 to 4, and 4 to 7
  try {
    merge_tables({first, second});
    ADD_FAILURE();
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what())
                  .find("has 4 replicas, some of which are among the 4 of the seed 1"),
              std::string::npos)
        << error.what();
  }
  second.keys["disks.seed"].numbers = {5, 5, 6};
  EXPECT_EQ(merge_tables({first, second}).points, 2 * count);
  // of another number of replicas: 5 to 8 and 8; what they differ in is no physics
  auto alone = scene_of("steady");
  auto third = sweep_of(alone);
  third.keys["disks.seed"].numbers = {8, 8, 9};
  EXPECT_THROW(merge_tables({second, third}), InputError);
  EXPECT_THROW(merge_tables({third, second}), InputError);
  third.keys["disks.seed"].numbers = {9, 9, 10};
  EXPECT_FALSE(merge_tables({second, third}).keys.contains("disks.replicas"));
  // two points of one sweep, which tells them apart
  auto both = sweep_of(alone);
  both.keys["disks.seed"].numbers = {1, 1, 2};
  both.keys["disks.replicas"].numbers = {1, 4, 1};
  EXPECT_EQ(merge_tables({both, third}).points, 2 * count);
}

}  // namespace
}  // namespace bagnold::analysis
