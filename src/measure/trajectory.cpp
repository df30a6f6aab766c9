// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/trajectory.hpp"

#include <fmt/format.h>

#include <mutex>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/xdmf.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// Held where HDF5 is used while systems are worked on: not every build of it bears two threads.
std::mutex one_at_a_time;

}  // namespace

Trajectory::Trajectory(fs::path file, io::TrajectoryHeader header)
    : file_(std::move(file)), header_(std::move(header)) {}

fs::path Trajectory::folder() const { return fs::path(file_).replace_extension(".parts"); }

fs::path Trajectory::part(std::size_t number) const {
  return folder() / fmt::format("{:06}.h5md", number);
}

void Trajectory::add(Frame const& frame) {
  std::lock_guard const lock(one_at_a_time);
  if (!open_) {
    std::error_code error;
    fs::create_directories(folder(), error);
    if (error)
      throw FileError(fmt::format("{} cannot be made ({})", folder().string(), error.message()));
    open_.emplace(part(parts_), header_);
  }
  open_->append(frame.state, frame.step);
}

void Trajectory::save(Numbers& numbers) {
  if (open_) {
    open_->close();
    open_.reset();
    ++parts_;
  }
  numbers["trajectory_parts"] = {static_cast<double>(parts_)};
}

void Trajectory::load(Numbers const& numbers) {
  parts_ = static_cast<std::size_t>(numbers.at("trajectory_parts").front());
  std::error_code ignored;
  for (std::size_t k = 0; k < parts_; ++k)
    if (!fs::exists(part(k), ignored))
      throw FileError(
          fmt::format("{} is not there, but the checkpoint counts on it; put it back, or "
                      "run the scene again with --force",
                      part(k).string()));
  for (std::size_t k = parts_; fs::remove(part(k), ignored); ++k) {
  }
}

void Trajectory::begin() {
  tidy();
  std::error_code error;
  fs::remove(file_, error);
  if (!error) fs::remove(fs::path(file_).replace_extension(".xdmf"), error);
  if (error)
    throw FileError(fmt::format("{}: an old trajectory cannot be removed ({})", file_.string(),
                                error.message()));
}

void Trajectory::finish() {
  io::H5mdFile whole(file_, header_);
  std::vector<double> time;
  for (std::size_t k = 0; k < parts_; ++k)
    io::for_each_frame(part(k), [&](State const& state, std::int64_t step) {
      whole.append(state, step);
      time.push_back(state.time);
    });
  whole.close();
  auto const text =
      io::xdmf_of(file_.filename().string(), header_.diameter.size(), time, header_.spins);
  io::replace_text(fs::path(file_).replace_extension(".xdmf"), text);
}

void Trajectory::tidy() {
  std::error_code error;
  fs::remove_all(folder(), error);
  if (error)
    throw FileError(fmt::format("{} cannot be removed ({})", folder().string(), error.message()));
}

}  // namespace bagnold
