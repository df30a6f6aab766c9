// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/trajectory.hpp"

#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
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

io::TrajectoryHeader header() { return {"1.2.3", std::vector(9, 1.0), std::vector(9, 2.0), true}; }

void add(Trajectory& trajectory, int first, int last) {
  for (int f = first; f < last; ++f) trajectory.add({frame_state(f), 10 * f, 0.0});
}

class TrajectoryTest : public testing::Test {
 public:
  std::filesystem::path file(char const* name) const { return folder_ / name; }

  void write_straight() const {
    Trajectory whole(file("whole.h5md"), header());
    Numbers numbers;
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
  io::for_each_frame(file("whole.h5md"), [&](State const& state, std::int64_t step) {
    State const expected = frame_state(frames);
    EXPECT_EQ(step, 10 * frames++);
    EXPECT_EQ(state.position, expected.position);
    EXPECT_EQ(state.velocity, expected.velocity);
    EXPECT_EQ(state.spin, expected.spin);
    EXPECT_EQ(state.time, expected.time);
    double const turns = (state.offset - expected.offset) / expected.box_length;
    EXPECT_NEAR(turns, std::round(turns), 1e-15);
    EXPECT_LE(std::abs(state.offset), 3.0);
  });
  EXPECT_EQ(frames, 12);
  EXPECT_FALSE(std::filesystem::exists(file("whole.parts")));
}

TEST_F(TrajectoryTest, KilledAtAnyFrameEndsTheSame) {
  write_straight();
  for (int killed = 1; killed < 12; ++killed) {
    Numbers numbers;
    int const saved = killed / 3 * 3;  // a checkpoint every three frames
    {
      Trajectory first(file("cut.h5md"), header());
      first.begin();
      for (int f = 0; f < saved; f += 3) {
        add(first, f, f + 3);
        first.save(numbers);
      }
      add(first, saved, killed);
      if (killed % 2 == 0) {  // between the part and its checkpoint
        Numbers lost;
        first.save(lost);
      }
    }
    Trajectory second(file("cut.h5md"), header());
    if (saved == 0)
      second.begin();
    else
      second.load(numbers);
    add(second, saved, 12);
    second.save(numbers);
    second.finish();
    Trajectory third(file("cut.h5md"), header());  // killed before its end was known
    third.load(numbers);
    third.finish();
    EXPECT_EQ(io::read_file(file("cut.h5md")), io::read_file(file("whole.h5md"))) << killed;
  }
}

TEST_F(TrajectoryTest, PartsCanBeReadAtOnce) {
  Trajectory trajectory(file("t.h5md"), header());
  Numbers numbers;
  add(trajectory, 0, 2);
  trajectory.save(numbers);
  add(trajectory, 2, 5);  // and left open
  int frames = 0;
  io::for_each_frame(file("t.parts/000000.h5md"), [&](auto const&, auto) { ++frames; });
  EXPECT_EQ(frames, 2);
}

TEST_F(TrajectoryTest, SystemsAreWrittenByThreadsOfTheirOwn) {
  write_straight();
  auto const of = [&](int k) { return file(("t" + std::to_string(k) + ".h5md").c_str()); };
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      Trajectory trajectory(of(k), header());
      add(trajectory, 0, 12);
      Numbers numbers;
      static std::mutex checkpoints;  // the program writes them while no system is worked on
      std::lock_guard const lock(checkpoints);
      trajectory.save(numbers);
    });
  for (auto& thread : threads) thread.join();
  for (int k = 0; k < 4; ++k) {
    Trajectory trajectory(of(k), header());
    trajectory.load({{"trajectory_parts", {1.0}}});
    trajectory.finish();
    EXPECT_EQ(io::read_file(of(k)), io::read_file(file("whole.h5md"))) << k;
  }
}

TEST_F(TrajectoryTest, AMissingPartIsTold) {
  Trajectory trajectory(file("t.h5md"), header());
  EXPECT_THROW(trajectory.load({{"trajectory_parts", {2.0}}}), FileError);
}

}  // namespace
}  // namespace bagnold
