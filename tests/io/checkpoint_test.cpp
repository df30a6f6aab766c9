// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_writer.hpp"
#include "src/io/seal.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/folder.hpp"
#include "tests/io/states.hpp"

namespace bagnold::io {
namespace {

/// -1 if none verifies.
std::int64_t step_of_newest(TestFolder const& folder, std::vector<std::string>* remarks = nullptr) {
  auto const found = newest_checkpoint(folder.path(), remarks);
  return found ? found->steps() : -1;
}

TEST(Checkpoint, EveryBitComesBack) {
  auto checkpoint = some_checkpoint(10, 1000);
  checkpoint.systems[0].state.position[1] = {-0.0, 5e-324};
  checkpoint.systems[0].state.velocity[2] = {NAN, std::numeric_limits<double>::infinity()};
  checkpoint.systems[0].list_position[0][0] = -0.0;
  checkpoint.systems[0].initial_offset = -0.0;
  checkpoint.systems[0].open_weight = 5e-324;
  checkpoint.systems[0].step = (std::int64_t{1} << 53) + 1;
  EXPECT_TRUE(same(parse_checkpoint("x", checkpoint_image(checkpoint)), checkpoint));
}

TEST(Checkpoint, WithoutSpinsWindowsRecordsOrFrames) {
  auto checkpoint = some_checkpoint(4, 0);
  checkpoint.systems[0].state.spin.clear();
  checkpoint.systems[0].state.strain_rate.reset();
  checkpoint.systems[0].window_sums.clear();
  checkpoint.systems[0].window_weight.clear();
  checkpoint.systems[0].open_sums.clear();
  checkpoint.systems[0].start_record.clear();
  checkpoint.systems[0].frames.clear();
  EXPECT_TRUE(same(parse_checkpoint("x", checkpoint_image(checkpoint)), checkpoint));
}

TEST(Checkpoint, ReplicasAtStepsOfTheirOwn) {
  auto checkpoint = some_checkpoint(10, 1000);
  for (std::int64_t const step : {2000, 500}) checkpoint.systems.push_back(some_system(10, step));
  auto& third = checkpoint.systems[2];
  third.window_weight.push_back(4.0);
  third.window_sums.insert(third.window_sums.end(), {7.0, 8.0, 9.0});
  third.memory["another"] = 1.0;
  EXPECT_EQ(checkpoint.steps(), 3500);
  auto const back = parse_checkpoint("x", checkpoint_image(checkpoint));
  ASSERT_EQ(back.systems.size(), 3u);
  EXPECT_TRUE(same(back, checkpoint));
  EXPECT_FALSE(same(back, some_checkpoint(10, 1000)));
}

TEST(Checkpoint, ImpossibleNumbersOfReplicasAreRefused) {
  for (std::int64_t const replicas : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{4},
                                      std::numeric_limits<std::int64_t>::max()}) {
    Hdf5Writer file(Hashed::yes);
    file.attribute("/", "format", "bagnold-checkpoint");
    file.attribute("/", "schema", std::int64_t{8});
    file.attribute("/", "replicas", replicas);
    file.text("/scene", "");
    auto image = bytes_of(file.content());
    add_seal(image);
    EXPECT_THROW(parse_checkpoint("x", image), InputError) << replicas;
  }
}

TEST(Checkpoint, AMillionDisks) {
  auto const checkpoint = some_checkpoint(1'000'000, 5);
  EXPECT_TRUE(same(parse_checkpoint("x", checkpoint_image(checkpoint)), checkpoint));
}

TEST(Checkpoint, ManyWindowsAndRecords) {
  auto checkpoint = some_checkpoint(4, 9);
  checkpoint.systems[0].window_weight.assign(200000, 2.5);
  checkpoint.systems[0].window_sums.assign(600000, 0.1);
  for (int index = 0; index < 300; ++index)
    checkpoint.systems[0].start_record["record " + std::to_string(index)] = index;
  checkpoint.scene.assign(300000, '#');
  EXPECT_TRUE(same(parse_checkpoint("x", checkpoint_image(checkpoint)), checkpoint));
}

TEST(Checkpoint, PartsThatDisagreeAreNeverWritten) {
  auto checkpoint = some_checkpoint(4, 9);
  checkpoint.systems[0].list_position.pop_back();
  EXPECT_THROW(checkpoint_image(checkpoint), std::logic_error);
  checkpoint = some_checkpoint(4, 9);
  checkpoint.systems[0].columns = 4;
  EXPECT_THROW(checkpoint_image(checkpoint), std::logic_error);
}

TEST(Checkpoint, EqualContentGivesEqualBytes) {
  EXPECT_EQ(checkpoint_image(some_checkpoint(8, 3)), checkpoint_image(some_checkpoint(8, 3)));
}

TEST(Checkpoint, EveryChangedByteIsNoticed) {
  auto const image = checkpoint_image(some_checkpoint(2, 3));
  for (std::size_t place = 0; place < image.size(); ++place) {
    auto spoilt = image;
    spoilt[place] ^= std::byte(1 << (place % 8));
    EXPECT_THROW(parse_checkpoint("x", std::move(spoilt)), InputError) << place;
  }
}

TEST(Checkpoint, EveryTruncationIsNoticed) {
  auto const image = checkpoint_image(some_checkpoint(2, 3));
  for (std::size_t length = 0; length < image.size(); ++length)
    EXPECT_THROW(parse_checkpoint("x", {image.begin(), image.begin() + std::ptrdiff_t(length)}),
                 InputError);
}

TEST(Checkpoint, ASealThatWasMadeAgainDoesNotHideAChangedValue) {
  auto const checkpoint = some_checkpoint(4, 3);
  auto image = checkpoint_image(checkpoint);
  ASSERT_EQ(remove_seal(image), "");
  auto const raw = std::as_bytes(std::span(checkpoint.systems[0].state.velocity));
  auto const found = std::search(image.begin(), image.end(), raw.begin(), raw.end());
  ASSERT_NE(found, image.end());
  found[9] ^= std::byte{1};
  add_seal(image);
  EXPECT_THROW(parse_checkpoint("x", image), InputError);
}

TEST(Checkpoint, TwoAreKeptAndTheNewestIsTaken) {
  TestFolder folder;
  EXPECT_FALSE(newest_checkpoint(folder.path(), nullptr));
  for (std::int64_t const step : {10, 20, 30}) {
    write_checkpoint(folder.path(), some_checkpoint(4, step));
    EXPECT_EQ(step_of_newest(folder), step);
  }
  std::filesystem::remove(folder / "checkpoint.h5");
  EXPECT_EQ(step_of_newest(folder), 20);
  remove_checkpoints(folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Checkpoint, ADamagedNewestIsRemarkedAndThePreviousTaken) {
  TestFolder folder;
  write_checkpoint(folder.path(), some_checkpoint(4, 10));
  write_checkpoint(folder.path(), some_checkpoint(4, 20));
  auto content = read_file(folder / "checkpoint.h5");
  content[content.size() / 2] ^= std::byte{1};
  replace_file(folder / "checkpoint.h5", content);
  std::vector<std::string> remarks;
  EXPECT_EQ(step_of_newest(folder, &remarks), 10);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("checkpoint.h5"), std::string::npos);
  EXPECT_NE(remarks[0].find("cut short or changed"), std::string::npos);

  write_checkpoint(folder.path(), some_checkpoint(4, 30));
  std::filesystem::remove(folder / "checkpoint.h5");
  EXPECT_EQ(step_of_newest(folder), 10) << "the damaged one took the place of a good one";
}

TEST(Checkpoint, AFinishedTemporaryCountsAndIsNotOverwritten) {
  TestFolder folder;
  auto const temporary = temporary_of(folder / "checkpoint.h5");
  write_verified(temporary, checkpoint_image(some_checkpoint(4, 30)));
  EXPECT_EQ(step_of_newest(folder), 30);
  write_checkpoint(folder.path(), some_checkpoint(4, 40));
  EXPECT_EQ(step_of_newest(folder), 40);
  std::filesystem::remove(folder / "checkpoint.h5");
  EXPECT_EQ(step_of_newest(folder), 30);
}

TEST(Checkpoint, AnUnfinishedTemporaryIsRemarked) {
  TestFolder folder;
  auto image = checkpoint_image(some_checkpoint(4, 30));
  image.resize(image.size() / 2);
  write_verified(temporary_of(folder / "checkpoint.h5"), image);
  std::vector<std::string> remarks;
  EXPECT_FALSE(newest_checkpoint(folder.path(), &remarks));
  EXPECT_EQ(remarks.size(), 1u);
  write_checkpoint(folder.path(), some_checkpoint(4, 40));
  EXPECT_EQ(step_of_newest(folder), 40);
}

}  // namespace
}  // namespace bagnold::io
