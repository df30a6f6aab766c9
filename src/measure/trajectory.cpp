// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/trajectory.hpp"

#include <fmt/format.h>

#include <limits>
#include <mutex>
#include <set>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/h5md_join.hpp"
#include "src/io/hash.hpp"
#include "src/io/hdf5_memory.hpp"
#include "src/io/seal.hpp"
#include "src/io/vtkhdf.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// Locked where HDF5 is used while systems are stepped: not every build of it is thread-safe.
std::mutex one_at_a_time;

constexpr std::size_t increment = std::size_t{1} << 16;  ///< of a part in memory, [bytes]

constexpr char const* saved_hashes = "trajectory_hashes";
constexpr char const* saved_last_step = "trajectory_last_step";

constexpr int half = 32;  ///< bits of a hash in a double

/// Two checkpoints are kept: at the third save both count this run's parts and no others.
constexpr int saves_that_replace_all = 3;

}  // namespace

Trajectory::Trajectory(fs::path file, io::TrajectoryHeader header, std::size_t part_bytes,
                       Contacts contacts)
    : file_(std::move(file)),
      header_(std::move(header)),
      part_bytes_(part_bytes),
      contacts_(std::move(contacts)) {}

void Trajectory::know_contacts(std::shared_ptr<ContactRecord const> const& record) {
  record_ = record;
}

fs::path Trajectory::folder() const { return fs::path(file_).replace_extension(".parts"); }

fs::path Trajectory::vtkhdf() const { return fs::path(file_).replace_extension(".vtkhdf"); }

fs::path Trajectory::part(std::size_t number) const {
  return folder() / fmt::format("{:06}_{:016x}.h5md", number, hashes_[number]);
}

void Trajectory::add(Frame const& frame) {
  io::FrameNumbers numbers{frame.step, frame.strain};
  if (header_.contacts) numbers.contacts = contacts_(frame, record_.get());
  std::lock_guard const lock(one_at_a_time);
  if (joined() && !outdated_) take_apart();
  if (!unwrapping_.begun() && !hashes_.empty()) go_on_from_parts();
  last_step_ = frame.step;
  if (!open_) open_.emplace(io::create_in_memory(increment), header_);
  if (header_.numbers) numbers.images = unwrapping_.next(frame.state, frame.strain);
  open_->append(frame.state, numbers);
  if (open_->bytes() >= part_bytes_) write_part();
}

/// Continues the trajectory of a resumed run. If the last part is lost, which lost() reports,
/// images begin anew.
void Trajectory::go_on_from_parts() {
  try {
    auto image = read_part(hashes_.size() - 1);
    auto const file = io::open_in_memory(image);
    header_.numbers = io::has_numbers(file);
    if (!header_.numbers) return;
    State last;
    io::FrameNumbers known;
    io::for_each_frame(file, [&](State const& state, io::FrameNumbers const& numbers) {
      last = state;
      known = numbers;
    });
    unwrapping_.go_on_from(last, known.strain, std::move(known.images));
  } catch (FileError const&) {
  }
}

void Trajectory::write_part() {
  std::error_code error;
  fs::create_directory(folder(), error);  // not what it lies in: a run that was moved stays away
  if (error)
    throw FileError(fmt::format("{} cannot be made ({}); check the folder, then `bagnold resume`",
                                folder().string(), error.message()));
  auto const file = open_->close();
  open_.reset();
  auto const content = io::content_of(file);
  hashes_.push_back(io::xxh3(content));
  io::replace_sealed(part(hashes_.size() - 1), content);
}

void Trajectory::save(ObserverState& numbers) {
  if (open_) write_part();
  if (++saves_ == saves_that_replace_all) {  // no checkpoint is left that does not count the parts
    remove_other_parts();
    if (outdated_) remove_joined();
  }
  std::vector<double> halves;
  for (auto const hash : hashes_)
    halves.insert(halves.end(), {static_cast<double>(hash >> half),
                                 static_cast<double>(hash & ((std::uint64_t{1} << half) - 1))});
  numbers[saved_hashes] = std::move(halves);
  numbers[saved_last_step] = {static_cast<double>(last_step_)};
}

void Trajectory::load(ObserverState const& numbers) {
  auto const saved = numbers.find(saved_hashes);
  if (saved == numbers.end())
    throw InputError(
        fmt::format("{}: the checkpoint knows no hashes of its parts: go on with the older version "
                    "that wrote it",
                    file_.string()));
  auto const& halves = saved->second;
  for (std::size_t k = 0; k + 1 < halves.size(); k += 2)
    hashes_.push_back(static_cast<std::uint64_t>(halves[k]) << half |
                      static_cast<std::uint64_t>(halves[k + 1]));
  auto const last = numbers.find(saved_last_step);  // an older version knew all frames at its end
  last_step_ = last == numbers.end() ? std::numeric_limits<std::int64_t>::max()
                                     : static_cast<std::int64_t>(last->second.front());
  outdated_ = joined() && !hashes_.empty() && parts_are_whole();
}

/// Frames beyond the checkpoint's are left out: a longer run may have its frames elsewhere.
void Trajectory::take_apart() {
  auto const last = last_step_;
  hashes_.clear();
  io::read_h5md(file_, [&](State const& state, io::FrameNumbers const& numbers) {
    if (numbers.step > last) return;
    header_.numbers = !numbers.images.empty();
    if (header_.numbers) unwrapping_.go_on_from(state, numbers.strain, numbers.images);
    if (!open_) open_.emplace(io::create_in_memory(increment), header_);
    open_->append(state, numbers);
    if (open_->bytes() >= part_bytes_) write_part();
  });
  outdated_ = true;
}

void Trajectory::remove_joined() {
  io::remove_file(file_);
  io::remove_file(vtkhdf());
  outdated_ = false;
}

void Trajectory::remove_other_parts() const {
  std::set<fs::path> counted;
  for (std::size_t k = 0; k < hashes_.size(); ++k) counted.insert(part(k));
  std::error_code ignored;  // they do no harm
  for (fs::directory_iterator file(folder(), ignored), end; !ignored && file != end;
       file.increment(ignored))
    if (!counted.contains(file->path())) fs::remove(file->path(), ignored);
}

std::vector<std::byte> Trajectory::read_part(std::size_t number) const {
  auto const path = part(number);
  std::string reason;
  try {
    auto content = io::read_file(path);
    reason = io::remove_seal(content);
    if (reason.empty() && io::xxh3(content) == hashes_[number]) return content;
    if (reason.empty()) reason = "is not the part that the checkpoint counts";
    reason = fmt::format("{} {}", path.string(), reason);
  } catch (FileError const& error) {
    reason = error.what();
  }
  throw FileError(fmt::format(
      "{}; put the part back and `bagnold resume` makes {}, or remove {} to do without: every part "
      "is a trajectory of its own",
      reason, file_.filename().string(), folder().string()));
}

bool Trajectory::joined() const {
  std::error_code ignored;
  return fs::exists(file_, ignored);
}

bool Trajectory::parts_are_whole() const {
  try {
    for (std::size_t k = 0; k < hashes_.size(); ++k) (void)read_part(k);
    return true;
  } catch (FileError const&) {
    return false;
  }
}

std::string Trajectory::lost() const {
  if (joined()) return {};
  try {
    for (std::size_t k = 0; k < hashes_.size(); ++k) (void)read_part(k);
  } catch (FileError const& error) {
    return error.what();
  }
  return {};
}

void Trajectory::begin() {
  tidy();
  remove_joined();
}

void Trajectory::finish() {
  if (joined() && !outdated_) return;
  if (open_) write_part();
  if (!hashes_.empty()) {  // perhaps of an older version
    auto image = read_part(0);
    header_.numbers = io::has_numbers(io::open_in_memory(image));
  }
  auto const temporary = io::temporary_of(file_);
  auto const time = io::join_h5md(temporary, header_, hashes_.size(),
                                  [&](std::size_t k) { return read_part(k); });
  auto const beside =
      io::vtkhdf_of(file_.filename().string(), header_.diameter.size(), time, header_.spins);
  try {
    io::replace_file(vtkhdf(), beside);
    io::rename_file(temporary, file_);  // the last: where it is, all is
  } catch (...) {
    io::remove_file(temporary);
    throw;
  }
  io::sync_folder(file_.parent_path());
}

void Trajectory::tidy() {
  std::error_code error;
  fs::remove_all(folder(), error);
  if (error)
    throw FileError(fmt::format("{} cannot be removed ({})", folder().string(), error.message()));
}

}  // namespace bagnold
