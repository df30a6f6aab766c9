// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/trajectory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/hdf5_memory.hpp"
#include "tests/io/folder.hpp"
#include "tests/measure/states.hpp"

namespace bagnold {
namespace {

State frame_state(int frame) {
  State state = test::square_lattice(3, 2.0, 1e-2);
  state.time = 0.1 * frame;
  state.offset = std::fmod(0.7 * frame, 6.0);
  state.spin.assign(9, 0.01 * frame);
  state.position[4][0] += 0.125 * frame;
  return state;
}

constexpr std::size_t large = std::size_t{1} << 30;  ///< parts end at checkpoints only

io::TrajectoryHeader header() { return {"1.2.3", std::vector(9, 1.0), std::vector(9, 2.0), true}; }

void add(Trajectory& trajectory, int first, int last) {
  for (int f = first; f < last; ++f) trajectory.add({frame_state(f), 10 * f, 0.1 * f});
}

class TrajectoryTest : public testing::Test {
 public:
  std::filesystem::path file(char const* name) const { return folder_ / name; }

  /// Frames of a whole file.
  static int frames_of(std::filesystem::path const& path,
                       std::function<void(State const&, std::int64_t)> const& visit = {}) {
    auto image = io::read_file(path);
    auto const opened = io::open_in_memory(image);
    int frames = 0;
    io::for_each_frame(opened, [&](State const& state, io::FrameNumbers const& numbers) {
      ++frames;
      if (visit) visit(state, numbers.step);
    });
    return frames;
  }

  /// A file of t.parts; the only one of its number.
  std::filesystem::path part(int number) const {
    std::filesystem::path found;
    for (auto const& entry : std::filesystem::directory_iterator(file("t.parts")))
      if (std::stoi(entry.path().filename()) == number) {
        EXPECT_TRUE(found.empty());
        found = entry.path();
      }
    return found;
  }

  /// Twelve frames in four parts, t.parts.
  ObserverState write_parts() const {
    Trajectory trajectory(file("t.h5md"), header(), large);
    ObserverState numbers;
    for (int f = 0; f < 12; f += 3) {
      add(trajectory, f, f + 3);
      numbers = {};
      trajectory.save(numbers);
    }
    return numbers;
  }

  void write_straight() const {
    Trajectory whole(file("whole.h5md"), header(), large);
    ObserverState numbers;
    add(whole, 0, 12);
    whole.save(numbers);
    whole.finish();
    whole.tidy();
  }

 private:
  io::TestFolder folder_;
};

TEST_F(TrajectoryTest, KeepsEveryFrame) {
  write_straight();
  int frames = 0;
  frames_of(file("whole.h5md"), [&](State const& state, std::int64_t step) {
    State const expected = frame_state(frames);
    EXPECT_EQ(step, 10 * frames++);
    EXPECT_EQ(state.position, expected.position);
    EXPECT_EQ(state.velocity, expected.velocity);
    EXPECT_EQ(state.spin, expected.spin);
    EXPECT_EQ(state.time, expected.time);
    EXPECT_EQ(state.offset, expected.offset);
    EXPECT_EQ(state.strain_rate, expected.strain_rate);
    EXPECT_LE(std::abs(io::tilt_of(state)), 3.0);
  });
  EXPECT_EQ(frames, 12);
  EXPECT_FALSE(std::filesystem::exists(file("whole.parts")));
}

/// Edges are taken apart and put together again when parts are joined: their bits stay.
TEST_F(TrajectoryTest, KeepsTheHeightOfABoxThatIsNotSquare) {
  for (double const aspect : {8.0, 1 / 3.0, 1 / 49.0, 61.7}) {
    Trajectory trajectory(file("t.h5md"), header(), large);
    trajectory.begin();
    ObserverState numbers;
    for (int f = 0; f < 4; ++f) {
      State state = frame_state(f);
      state.box_aspect = aspect;
      trajectory.add({state, f, 0.0});
      trajectory.save(numbers);
    }
    trajectory.finish();
    double const height = aspect * frame_state(0).box_length;
    EXPECT_EQ(frames_of(file("t.h5md"),
                        [&](State const& state, auto) { EXPECT_EQ(state.box_height(), height); }),
              4);
  }
}

TEST_F(TrajectoryTest, KilledAtAnyFrameEndsTheSame) {
  write_straight();
  for (int killed = 1; killed < 12; ++killed) {
    ObserverState numbers;
    int const saved = killed / 3 * 3;  // a checkpoint every three frames
    {
      Trajectory first(file("cut.h5md"), header(), large);
      first.begin();
      for (int f = 0; f < saved; f += 3) {
        add(first, f, f + 3);
        first.save(numbers);
      }
      add(first, saved, killed);
      if (killed % 2 == 0) {  // between the part and its checkpoint
        ObserverState lost;
        first.save(lost);
      }
    }
    Trajectory second(file("cut.h5md"), header(), large);
    if (saved == 0)
      second.begin();
    else
      second.load(numbers);
    add(second, saved, 12);
    second.save(numbers);
    second.finish();
    Trajectory third(file("cut.h5md"), header(), large);  // killed before its end was known
    third.load(numbers);
    third.finish();
    EXPECT_EQ(io::read_file(file("cut.h5md")), io::read_file(file("whole.h5md"))) << killed;
  }
}

/// Of a version that wrote neither strain, rate, offset nor images: it ends as that one would have.
TEST_F(TrajectoryTest, GoesOnBehindPartsOfAnOlderVersion) {
  auto const before = [] {
    auto old = header();
    old.numbers = false;
    return old;
  };
  auto const write = [&](char const* name, io::TrajectoryHeader const& later) {
    Trajectory first(file(name), before(), large);
    ObserverState numbers;
    add(first, 0, 5);
    first.save(numbers);
    Trajectory second(file(name), later, large);
    second.load(numbers);
    add(second, 5, 9);
    second.save(numbers);
    second.finish();
  };
  write("old.h5md", before());
  write("t.h5md", header());
  EXPECT_EQ(io::read_file(file("t.h5md")), io::read_file(file("old.h5md")));
  EXPECT_EQ(frames_of(file("t.h5md")), 9);
}

TEST_F(TrajectoryTest, PartsCanBeReadAtOnce) {
  Trajectory trajectory(file("t.h5md"), header(), large);
  ObserverState numbers;
  add(trajectory, 0, 2);
  trajectory.save(numbers);
  add(trajectory, 2, 5);  // and left open
  EXPECT_EQ(frames_of(part(0)), 2);
}

TEST_F(TrajectoryTest, SystemsAreWrittenByThreadsOfTheirOwn) {
  write_straight();
  auto const of = [&](int k) { return file(("t" + std::to_string(k) + ".h5md").c_str()); };
  std::vector<std::thread> threads;
  std::array<ObserverState, 4> saved;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      Trajectory trajectory(of(k), header(), large);
      add(trajectory, 0, 12);
      static std::mutex checkpoints;  // the program writes them while no system is worked on
      std::lock_guard const lock(checkpoints);
      trajectory.save(saved[k]);
    });
  for (auto& thread : threads) thread.join();
  for (int k = 0; k < 4; ++k) {
    Trajectory trajectory(of(k), header(), large);
    trajectory.load(saved[k]);
    trajectory.finish();
    EXPECT_EQ(io::read_file(of(k)), io::read_file(file("whole.h5md"))) << k;
  }
}

TEST_F(TrajectoryTest, PartsThatGrowLargeAreClosed) {
  write_straight();
  Trajectory trajectory(file("t.h5md"), header(), /*part_bytes=*/1);
  add(trajectory, 0, 12);
  EXPECT_EQ(frames_of(part(11)), 1);
  ObserverState numbers;
  trajectory.save(numbers);
  EXPECT_TRUE(part(12).empty());
  trajectory.finish();
  EXPECT_EQ(io::read_file(file("t.h5md")), io::read_file(file("whole.h5md")));
}

TEST_F(TrajectoryTest, ALostPartIsToldAndCostsNoOther) {
  write_straight();
  auto const numbers = write_parts();
  auto const lost = part(1), other = part(2);
  auto const whole = io::read_file(lost);
  auto const expect_lost = [&](std::string const& reason) {
    Trajectory trajectory(file("t.h5md"), header(), large);
    trajectory.load(numbers);
    EXPECT_NE(trajectory.lost().find(lost.string()), std::string::npos) << trajectory.lost();
    EXPECT_NE(trajectory.lost().find(reason), std::string::npos) << trajectory.lost();
    EXPECT_THROW(trajectory.finish(), FileError);
    EXPECT_FALSE(std::filesystem::exists(file("t.h5md")));
    EXPECT_FALSE(std::filesystem::exists(file("t.h5md.tmp")));
    EXPECT_FALSE(part(3).empty());
  };
  std::filesystem::remove(lost);
  expect_lost("No such file");
  for (std::size_t const at : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
    auto damaged = whole;
    damaged[at] ^= std::byte{1};
    io::replace_file(lost, damaged);
    expect_lost("seal");
  }
  io::replace_file(lost, std::span(whole).first(whole.size() / 2));
  expect_lost("seal");
  io::replace_file(lost, io::read_file(other));
  expect_lost("not the part that the checkpoint counts");

  io::replace_file(lost, whole);
  Trajectory trajectory(file("t.h5md"), header(), large);
  trajectory.load(numbers);
  EXPECT_EQ(trajectory.lost(), "");
  trajectory.finish();
  EXPECT_EQ(io::read_file(file("t.h5md")), io::read_file(file("whole.h5md")));
}

/// A resumed run that could not read the newest checkpoint does not spoil it.
TEST_F(TrajectoryTest, PartsOfANewerCheckpointStay) {
  write_straight();
  auto const newest = write_parts();
  auto older = newest;
  older.begin()->second.resize(4);  // two parts
  {
    Trajectory second(file("t.h5md"), header(), large);
    second.load(older);
    add(second, 6, 8);
    ObserverState numbers;
    second.save(numbers);
  }
  Trajectory third(file("t.h5md"), header(), large);
  third.load(newest);
  EXPECT_EQ(third.lost(), "");
  ObserverState numbers;
  for (int checkpoint = 0; checkpoint < 3; ++checkpoint) third.save(numbers);
  EXPECT_EQ(numbers, newest);
  EXPECT_FALSE(part(2).empty());  // now the only one
  third.finish();
  EXPECT_EQ(io::read_file(file("t.h5md")), io::read_file(file("whole.h5md")));
}

TEST_F(TrajectoryTest, LinksAreNotFollowed) {
  io::replace_text(file("mine"), "mine");
  std::filesystem::create_symlink(file("mine"), file("whole.h5md.tmp"));
  write_straight();
  EXPECT_EQ(io::read_file(file("mine")), io::bytes_of("mine"));
  EXPECT_EQ(frames_of(file("whole.h5md")), 12);
}

TEST_F(TrajectoryTest, AFolderThatIsGoneIsNotMadeAgain) {
  Trajectory trajectory(file("gone/t.h5md"), header(), large);
  add(trajectory, 0, 1);
  ObserverState numbers;
  EXPECT_THROW(trajectory.save(numbers), FileError);
  EXPECT_FALSE(std::filesystem::exists(file("gone")));
}

}  // namespace
}  // namespace bagnold
