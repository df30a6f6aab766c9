// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/state_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/seal.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/states.hpp"

namespace bagnold::io {
namespace {

TEST(StateFile, RoundTripKeepsEveryBit) {
  TestFolder folder;
  auto state = some_state(10);
  state.position[3][1] = -0.0;
  state.velocity[2][0] = 5e-324;
  write_states(folder / "state.h5", {state});
  EXPECT_TRUE(same(read_states(folder / "state.h5"), {state}));
  EXPECT_TRUE(same(read_states(folder / "state.h5", 10), {state}));

  state.spin.clear();
  state.strain_rate.reset();
  write_states(folder / "state.h5", {state});
  EXPECT_TRUE(same(read_states(folder / "state.h5"), {state}));
}

TEST(StateFile, AMillionDisks) {
  TestFolder folder;
  auto const state = some_state(1'000'000);
  write_states(folder / "state.h5", {state});
  EXPECT_TRUE(same(read_states(folder / "state.h5"), {state}));
}

/// States that may share a file: same box, offset, time, rate and N.
std::vector<State> some_states(std::size_t replicas, std::size_t count) {
  std::vector<State> states;
  for (std::size_t r = 0; r < replicas; ++r)
    states.push_back(some_state(count, static_cast<unsigned>(r + 1)));
  return states;
}

TEST(StateFile, SeveralStatesHaveALeadingAxis) {
  TestFolder folder;
  auto states = some_states(3, 10);
  states[1].position[3][1] = -0.0;
  write_states(folder / "state.h5", states);
  EXPECT_TRUE(same(read_states(folder / "state.h5"), states));
  EXPECT_TRUE(same(read_states(folder / "state.h5", 10), states));
  EXPECT_THROW(read_states(folder / "state.h5", 12), InputError);
  {
    Hdf5Reader const file("state.h5", read_file(folder / "state.h5"));
    EXPECT_EQ(file.shape("/state/position"), (Shape{3, 10, 2}));
    EXPECT_EQ(file.shape("/state/spin"), (Shape{3, 10}));
    EXPECT_EQ(file.shape("/state/diameter"), (Shape{3, 10}));
  }
  for (auto& state : states) state.spin.clear();
  for (auto& state : states) state.strain_rate.reset();
  write_states(folder / "state.h5", states);
  EXPECT_TRUE(same(read_states(folder / "state.h5"), states));
}

/// As of replicas at given stress or pressure.
TEST(StateFile, StatesMayHaveBoxesOffsetsAndRatesOfTheirOwn) {
  TestFolder folder;
  for (auto const& change : std::vector<std::function<void(State&)>>{
           [](State& s) { s.box_length += 1; }, [](State& s) { s.offset += 1; },
           [](State& s) { s.strain_rate = -1e-5; }}) {
    auto states = some_states(3, 4);
    change(states[1]);
    write_states(folder / "s.h5", states);
    EXPECT_TRUE(same(read_states(folder / "s.h5"), states));
  }
}

TEST(StateFile, StatesThatDisagreeAreNeverWritten) {
  TestFolder folder;
  for (auto const& spoil : std::vector<std::function<void(State&)>>{
           [](State& s) { s.box_aspect += 1; }, [](State& s) { s.time += 1; },
           [](State& s) { s.strain_rate.reset(); }, [](State& s) { s.spin.clear(); },
           [](State& s) { s = some_state(6, 9); }}) {
    auto states = some_states(2, 4);
    spoil(states[1]);
    EXPECT_THROW(write_states(folder / "s.h5", states), std::logic_error);
  }
}

TEST(StateFile, ImpossibleValuesOfAnyStateAreRefused) {
  TestFolder folder;
  auto states = some_states(3, 4);
  states[2].velocity[1][0] = NAN;
  write_states(folder / "s.h5", states);
  EXPECT_THROW(read_states(folder / "s.h5"), InputError);
}

TEST(StateFile, ImpossibleValuesAreRefusedByName) {
  TestFolder folder;
  auto const refused = [&](std::function<void(State&)> spoil, std::string const& part) {
    auto state = some_state(4);
    spoil(state);
    write_states(folder / "s.h5", {state});
    try {
      read_states(folder / "s.h5");
    } catch (InputError const& error) {
      return std::string(error.what()).find(part) != std::string::npos ? std::string("refused")
                                                                       : error.what();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused([](State& s) { s.position[1][1] = NAN; }, "/state/position, disk 1"),
            "refused");
  EXPECT_EQ(refused([](State& s) { s.velocity[3][0] = INFINITY; }, "velocity, disk 3"), "refused");
  EXPECT_EQ(refused([](State& s) { s.spin[0] = NAN; }, "/state/spin, disk 0"), "refused");
  EXPECT_EQ(refused([](State& s) { s.diameter[2] = 0.0; }, "/state/diameter, disk 2"), "refused");
  EXPECT_EQ(refused([](State& s) { s.box_length = -1.0; }, "box_length = -1"), "refused");
  for (double const aspect : {0.0, -4.0, HUGE_VAL})
    EXPECT_EQ(refused([=](State& s) { s.box_aspect = aspect; }, "box_aspect = "), "refused");
  EXPECT_EQ(refused([](State& s) { s.offset = NAN; }, "/state@offset"), "refused");
  EXPECT_EQ(refused([](State& s) { s.time = INFINITY; }, "/state@time"), "refused");
  EXPECT_EQ(refused([](State& s) { s.strain_rate = NAN; }, "/state@strain_rate"), "refused");
  EXPECT_EQ(refused([](State& s) { s = some_state(1); }, "number of disks = 1"), "refused");
  EXPECT_EQ(refused([](State&) {}, ""), "accepted");
}

/// Files of square boxes have the bytes that they had before others were known.
TEST(StateFile, SquareBoxesHaveNoAspect) {
  TestFolder folder;
  auto state = some_state(4);
  for (double const aspect : {1.0, 4.0}) {
    state.box_aspect = aspect;
    write_states(folder / "s.h5", {state});
    EXPECT_TRUE(same(read_states(folder / "s.h5").front(), state));
    Hdf5Reader const file("s.h5", read_file(folder / "s.h5"));
    EXPECT_EQ(file.has_attribute("/state", "box_aspect"), aspect != 1.0);
  }
}

TEST(StateFile, CountIsComparedWithTheScenes) {
  TestFolder folder;
  write_states(folder / "s.h5", std::vector{some_state(4)});
  EXPECT_THROW(read_states(folder / "s.h5", 6), InputError);
}

TEST(StateFile, MissingAndForeignFilesAreInputErrors) {
  TestFolder folder;
  EXPECT_THROW(read_states(folder / "none.h5"), InputError);
  EXPECT_THROW(read_states(folder.path()), InputError);
  replace_file(folder / "text", bytes_of("position,velocity\n1,2\n"));
  EXPECT_THROW(read_states(folder / "text"), InputError);
  replace_file(folder / "empty", {});
  EXPECT_THROW(read_states(folder / "empty"), InputError);
}

/// "accepted as it was", "accepted", or the refusal.
std::string verdict(std::filesystem::path const& path, std::vector<std::byte> const& content,
                    std::vector<State> const& written) {
  replace_file(path, content);
  try {
    return same(read_states(path), written) ? "accepted as it was" : "accepted";
  } catch (InputError const& error) {
    return error.what();
  }
}

TEST(StateFile, ASealedFileIsWhatItWasOrRefused) {
  TestFolder folder;
  std::vector const written{some_state(8)};
  write_states(folder / "state.h5", written);
  auto const whole = read_file(folder / "state.h5");
  auto const seal = whole.size() - seal_bytes;
  for (std::size_t at = 0; at < whole.size(); at += at < seal ? 61 : 1) {
    auto damaged = whole;
    damaged[at] ^= std::byte{0x10};
    auto const found = verdict(folder / "s.h5", damaged, written);
    if (found != "accepted as it was")  // a seal that is none any more: as from elsewhere
      EXPECT_NE(found.find("the content that its seal tells"), std::string::npos) << at << found;
    else
      EXPECT_GE(at, seal);
  }
}

/// Eight bytes crash HDF5 1.10.8; without a seal nothing but HDF5 can tell.
TEST(StateFile, AFileThatCrashesHdf5IsRefused) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "where HDF5 crashes depends on the memory";
#endif
  TestFolder folder;
  std::vector const written{some_state(64)};
  write_states(folder / "state.h5", written);
  auto damaged = read_file(folder / "state.h5");
  std::fill_n(damaged.begin() + 128, 8, std::byte{0xff});
  EXPECT_NE(verdict(folder / "s.h5", damaged, written).find("its seal tells"), std::string::npos);
  damaged.resize(damaged.size() - seal_bytes);
  EXPECT_NE(verdict(folder / "s.h5", damaged, written).find("the file is damaged"),
            std::string::npos);
}

/// HDF5 takes the seal off when it writes to a file: what was changed by hand is read.
TEST(StateFile, AFileChangedByHandIsRead) {
  if (!have_h5py()) GTEST_SKIP() << "no h5py";
  TestFolder folder;
  write_states(folder / "state.h5", std::vector{some_state(6)});
  ASSERT_EQ(run_python("import h5py; f = h5py.File(\"" + (folder / "state.h5").string() +
                       "\", \"r+\"); f[\"state/position\"][0, 0] = 2.5; f.close()"),
            0);
  EXPECT_EQ(read_states(folder / "state.h5").front().position[0][0], 2.5);
}

TEST(StateFile, H5pyReadsWhatIsWritten) {
  if (!have_h5py()) GTEST_SKIP() << "no h5py";
  TestFolder folder;
  write_states(folder / "state.h5", std::vector{some_state(6)});
  EXPECT_EQ(
      run_python("import h5py; s = h5py.File(\"" + (folder / "state.h5").string() +
                 "\")[\"state\"]\n"
                 "assert s[\"position\"].shape == (6, 2) and s[\"velocity\"].shape == (6, 2)\n"
                 "assert s[\"spin\"].shape == s[\"diameter\"].shape == (6,)\n"
                 "assert s.attrs[\"box_length\"] == 12.25 and s.attrs[\"time\"] == 1 / 3\n"
                 "assert s.attrs[\"box_aspect\"] == 1 / 3\n"
                 "assert s.attrs[\"offset\"] == 0.1 and s.attrs[\"strain_rate\"] == 1e-4\n"
                 "assert s[\"position\"].attrs[\"unit\"] == \"d_s\"\n"
                 "assert list(s[\"diameter\"][:2]) == [1.0, 1.4]"),
      0);
}

TEST(StateFile, ReadsWhatH5pyWrites) {
  if (!have_h5py()) GTEST_SKIP() << "no h5py";
  TestFolder folder;
  // float32, integers, big-endian, chunks, attributes as arrays and integers
  ASSERT_EQ(run_python("import h5py, numpy as np\n"
                       "f = h5py.File(\"" +
                       (folder / "s.h5").string() +
                       "\", \"w\", libver=\"latest\")\n"
                       "g = f.create_group(\"state\"); n = 500\n"
                       "x = np.arange(2 * n).reshape(n, 2)\n"
                       "g.create_dataset(\"position\", data=x / 4, dtype=\"f4\", chunks=(64, 1))\n"
                       "g.create_dataset(\"velocity\", data=x, dtype=\">i4\")\n"
                       "g.create_dataset(\"spin\", data=x[:, 0], dtype=\">f8\", maxshape=(None,))\n"
                       "g.create_dataset(\"diameter\", data=np.ones(n, \"u1\"))\n"
                       "g.attrs[\"box_length\"] = np.float32(8); g.attrs[\"offset\"] = 0\n"
                       "g.attrs[\"time\"] = np.array([2.5])"),
            0);
  auto const state = read_states(folder / "s.h5").front();
  EXPECT_EQ(state.count(), 500u);
  EXPECT_EQ(state.position[499][1], 999 / 4.0);
  EXPECT_EQ(state.velocity[499][0], 998.0);
  EXPECT_EQ(state.spin[7], 14.0);
  EXPECT_EQ(state.diameter[7], 1.0);
  EXPECT_EQ(state.box_length, 8.0);
  EXPECT_EQ(state.box_aspect, 1.0);
  EXPECT_EQ(state.time, 2.5);
}

}  // namespace
}  // namespace bagnold::io
