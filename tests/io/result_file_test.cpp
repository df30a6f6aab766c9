// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/result_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_reader.hpp"
#include "tests/io/folder.hpp"

namespace bagnold::io {
namespace {

Result some_result() {
  return {
      {{"version", "0.1.0"}, {"seed", std::int64_t{7}}, {"scene", "title = \"x\"\n"}},
      {{"p", "m/tau_e^2", "pressure", {1.0, 2.0, 3.0}}, {"mu", "1", "friction", {0.1, NAN, 0.3}}},
      1};
}

TEST(ResultFile, HoldsSeriesAndProvenance) {
  TestFolder folder;
  write_result(folder / "result.h5", some_result());
  Hdf5Reader const file("result.h5", read_file(folder / "result.h5"));
  EXPECT_EQ(file.doubles("/series/p", {3}), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_TRUE(std::isnan(file.doubles("/series/mu", {3})[1]));
  EXPECT_EQ(file.words_of("/series/p", "unit"), "m/tau_e^2");
  EXPECT_EQ(file.words_of("/", "scene"), "title = \"x\"\n");
  EXPECT_EQ(file.integer("/", "seed"), 7);
  EXPECT_EQ(file.integer("/series", "discarded_windows"), 1);
}

TEST(ResultFile, EqualResultsGiveEqualBytes) {
  TestFolder folder;
  write_result(folder / "a.h5", some_result());
  write_result(folder / "b.h5", some_result());
  EXPECT_EQ(read_file(folder / "a.h5"), read_file(folder / "b.h5"));
}

TEST(ResultFile, NoWindowsAndNoSeries) {
  TestFolder folder;
  write_result(folder / "a.h5", {{}, {{"p", "1", "none yet", {}}}, 0});
  write_result(folder / "b.h5", {});
  Hdf5Reader const file("a.h5", read_file(folder / "a.h5"));
  EXPECT_TRUE(file.doubles("/series/p", {0}).empty());
}

TEST(ResultFile, H5pyGivesText) {
  if (!have_h5py()) GTEST_SKIP() << "no h5py";
  TestFolder folder;
  write_result(folder / "result.h5", some_result());
  EXPECT_EQ(run_python("import h5py; f = h5py.File(\"" + (folder / "result.h5").string() +
                       "\")\n"
                       "assert f.attrs[\"version\"] == \"0.1.0\" and f.attrs[\"seed\"] == 7\n"
                       "assert f[\"series/p\"].attrs[\"description\"] == \"pressure\"\n"
                       "assert list(f[\"series/p\"]) == [1, 2, 3]"),
            0);
}

TEST(ResultFile, AxesHaveScales) {
  if (!have_h5py()) GTEST_SKIP() << "no h5py";
  TestFolder folder;
  auto result = some_result();
  result.series.push_back({"strain", "1", "at the end of the window", {0.5, 1.0, 1.5}});
  write_result(folder / "one.h5", result);
  result.replicas = 3;
  result.attributes.emplace_back("seeds", std::vector<std::int64_t>{7, 5, 6});
  write_result(folder / "three.h5", result);
  std::string program = "import h5py; from h5py import h5ds\n";
  for (auto const* name : {"one", "three"})
    program += fmt::format("{0} = h5py.File(\"{1}/{0}.h5\")\n", name, (folder / "").string());
  program += R"(
assert list(one["series/mu"].dims[0]["strain"]) == [0.5, 1, 1.5]
assert list(three["series/mu"].dims[0]["seed"]) == [7, 5, 6]
assert list(three["series/strain"].dims[1]["window"]) == [0]
assert h5ds.is_attached(one["series/p"].id, one["series/strain"].id, 0)
assert h5ds.is_attached(three["series/p"].id, three["window"].id, 1))";
  EXPECT_EQ(run_python(program), 0);
}

TEST(ResultFile, LongTextsAreKept) {
  TestFolder folder;
  auto result = some_result();
  result.attributes.emplace_back("long", std::string(1 << 20, 'x'));
  write_result(folder / "result.h5", result);
  Hdf5Reader const file("result.h5", read_file(folder / "result.h5"));
  EXPECT_EQ(file.words_of("/", "long").size(), 1u << 20);
}

}  // namespace
}  // namespace bagnold::io
