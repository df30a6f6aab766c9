// SPDX-License-Identifier: BSD-3-Clause
#include "src/sweep/results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_reader.hpp"
#include "tests/sweep/scenes.hpp"

namespace bagnold::sweep {
namespace {

std::string text_in(std::filesystem::path const& file) {
  auto const bytes = io::read_file(file);
  return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
}

/// Three points: two with results of unlike observables, and one that was begun and has none.
class SweepResults : public testing::Test {
 protected:
  SweepResults()
      : sweep(expand("[sweep]\nzip = { \"disks.model\" = [\"CD\", \"CD_rot\", \"CD_n\"], "
                     "\"title\" = [\"a, b\", \"say \\\"x\\\"\", \"\"] }")),
        folder(SweepFolder::make(test_folder / "out", sweep)) {
    std::ofstream(folder.summary(0))
        << R"({"wall_seconds": 3, "observables": {"p": {"mean": 0.1, "error": 1e-3, "rough": true},)"
        << R"("Z": {"mean": 2, "error": null}, "mu": {"mean": 3, "error": 1, "rough": true}}})";
    std::ofstream(folder.summary(1)) << R"({"warnings": [{"name": "one"}, {"name": "two"}],)"
                                     << R"("notes": [{"name": "soft"}],)"
                                     << R"( "observables": {"p": {"mean": 1e-300, "error": 0},)"
                                     << R"("spin_mean": {"mean": -0.5, "error": 0.25}}})";
    std::ofstream(folder.log(2)) << "bagnold: disk 3 is too fast\n";
  }

  io::TestFolder test_folder;
  Sweep sweep;
  SweepFolder folder;
};

TEST_F(SweepResults, TableIsWrittenOutByHand) {
  auto const results = read_results(sweep, folder);
  EXPECT_EQ(results.status, (std::vector<std::string>{"done", "done", "failed"}));
  EXPECT_EQ(results.warnings, (std::vector<std::string>{"", "one two", ""}));
  EXPECT_EQ(results.notes, (std::vector<std::string>{"", "soft", ""}));
  write_csv(test_folder / "t.csv", sweep, results);
  EXPECT_EQ(
      text_in(test_folder / "t.csv"),
      "disks.model,title,p,p_error,Z,Z_error,mu,mu_error,spin_mean,spin_mean_error,rough_errors,"
      "warnings,notes,folder\n"
      "CD,\"a, b\",0.1,0.001,2,,3,1,,,p mu,,," +
          sweep.points[0].folder + "\n" +
          "CD_rot,\"say \"\"x\"\"\",1e-300,0,,,,,-0.5,0.25,,one two,soft," +
          sweep.points[1].folder + "\n" + "CD_n,,,,,,,,,,,,," + sweep.points[2].folder + "\n");
}

TEST_F(SweepResults, Hdf5HoldsTheSame) {
  write_hdf5(test_folder / "t.h5", sweep, read_results(sweep, folder), {{"git", "0"}});
  io::Hdf5Reader const file("t.h5", io::read_file(test_folder / "t.h5"));
  auto const p = file.doubles("/observables/p", {3});
  EXPECT_EQ(p[0], 0.1);
  EXPECT_EQ(p[1], 1e-300);
  EXPECT_TRUE(std::isnan(p[2]));
  EXPECT_TRUE(std::isnan(file.doubles("/observables/Z_error", {3})[0]));
  EXPECT_EQ(file.words_of("/", "sweep"), sweep.text);
  EXPECT_EQ(file.words_of("/", "scene").find("[sweep"), std::string::npos);
  if (!io::have_h5py()) GTEST_SKIP() << "no h5py";
  EXPECT_EQ(io::run_python("import h5py; f = h5py.File(\"" + (test_folder / "t.h5").string() +
                           "\")\n"
                           "text = lambda path: list(f[path].asstr()[:])\n"
                           "assert text(\"points/disks.model\") == [\"CD\", \"CD_rot\", \"CD_n\"]\n"
                           "assert text(\"points/title\") == [\"a, b\", \"say \\\"x\\\"\", \"\"]\n"
                           "assert text(\"status\") == [\"done\", \"done\", \"failed\"]\n"
                           "assert text(\"warnings\") == [\"\", \"one two\", \"\"]\n"
                           "assert text(\"notes\") == [\"\", \"soft\", \"\"]\n"
                           "assert text(\"rough_errors\") == [\"p mu\", \"\", \"\"]\n"
                           "assert \"CD_rot\" in text(\"points/scene\")[1]\n"
                           "assert text(\"points/folder\")[2].startswith(\"0003_model=CD_n\")"),
            0);
}

TEST_F(SweepResults, EqualResultsGiveEqualBytes) {
  for (auto const* name : {"a", "b"}) {
    auto const results = read_results(sweep, folder);
    write_csv(test_folder / (std::string(name) + ".csv"), sweep, results);
    write_hdf5(test_folder / (std::string(name) + ".h5"), sweep, results, {});
  }
  EXPECT_EQ(io::read_file(test_folder / "a.csv"), io::read_file(test_folder / "b.csv"));
  EXPECT_EQ(io::read_file(test_folder / "a.h5"), io::read_file(test_folder / "b.h5"));
}

TEST_F(SweepResults, NumbersOfAKeyAreDoubles) {
  auto const other =
      expand("[sweep]\ngrid = { \"disks.seed\" = [3, 1], \"shear.strain\" = [2.5] }");
  auto const there = SweepFolder::make(test_folder / "other", other);
  auto const results = read_results(other, there);
  EXPECT_EQ(results.status, (std::vector<std::string>{"open", "open"}));
  write_hdf5(test_folder / "o.h5", other, results, {});
  io::Hdf5Reader const file("o.h5", io::read_file(test_folder / "o.h5"));
  EXPECT_EQ(file.doubles("/points/disks.seed", {2}), (std::vector<double>{3, 1}));
  EXPECT_EQ(file.doubles("/points/shear.strain", {2}), (std::vector<double>{2.5, 2.5}));
}

/// A point that was made longer by itself: its scene and its varied key tell what it came to.
TEST_F(SweepResults, StrainIsWhatAPointCameTo) {
  auto const other = expand("[sweep]\ngrid = { \"shear.strain\" = [2.5, 3.5] }");
  auto const there = SweepFolder::make(test_folder / "longer", other);
  std::ofstream(there.summary(0)) << R"({"scene": {"shear": {"strain": 40.0}}, "observables": {}})";
  std::ofstream(there.summary(1)) << R"({"scene": {"shear": {"strain": 3.5}}, "observables": {}})";
  auto const run = as_run(other, read_results(other, there));
  EXPECT_EQ(run.points[0].scene.shear.strain, 40.0);
  EXPECT_EQ(run.points[1].scene.shear.strain, 3.5);
  EXPECT_EQ(std::get<double>(run.points[0].values[0]), 40.0);
}

TEST_F(SweepResults, ABrokenSummaryIsNamed) {
  std::ofstream(folder.summary(0)) << "{";
  EXPECT_THROW(read_results(sweep, folder), FileError);
}

}  // namespace
}  // namespace bagnold::sweep
