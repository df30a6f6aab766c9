// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "src/io/h5md_file.hpp"
#include "src/measure/frame_observer.hpp"
#include "src/measure/unwrapping.hpp"

namespace bagnold {

/// Frames on the disk: in parts during a run, NAME.parts/000000_HASH.h5md and so on, and one file
/// NAME.h5md in the end.
///
/// A part is built in memory and written as a whole, sealed, before each checkpoint and when it has
/// grown to `part_bytes`. A checkpoint holds the hash of every part that it counts. No part
/// replaces one that an older checkpoint counts, or one that could not be read; parts of other
/// lineages are removed when no checkpoint can count them any more. Every part is a trajectory of
/// its own. Data are copied once, at the end.
///
/// If a finished run is made longer, NAME.h5md becomes parts again at the first new frame: those
/// frames of it that the checkpoint counts. It is removed when a checkpoint counts these parts.
class Trajectory final : public FrameObserver {
 public:
  using Contacts = std::function<FrameContacts(Frame const&, ContactRecord const*)>;

  /// file: NAME.h5md. part_bytes: memory that frames may take; a part has one frame at least.
  /// contacts: of a frame, where header.contacts.
  Trajectory(std::filesystem::path file, io::TrajectoryHeader header, std::size_t part_bytes,
             Contacts contacts = {});

  /// Adds a frame. Trajectories of several systems may be called from different threads.
  void add(Frame const& frame) override;
  void know_contacts(std::shared_ptr<ContactRecord const> const& record) override;
  void save(ObserverState& numbers) override;
  void load(ObserverState const& numbers) override;
  void report(std::vector<FrameObserver const*> const&, FrameResults&) const override {}

  /// First part that the checkpoint counts and that is missing or changed, and what to do.
  std::string lost() const override;

  /// Removes files of an earlier run.
  void begin() override;

  /// Joins the parts into NAME.h5md, and writes NAME.vtkhdf beside it, unless that has been done.
  /// FileError if a part is lost, or the disk fails: the parts are then left unchanged.
  void finish() override;

  /// Removes the parts.
  void tidy() override;

 private:
  std::filesystem::path part(std::size_t number) const;
  std::filesystem::path folder() const;
  std::filesystem::path vtkhdf() const;
  std::vector<std::byte> read_part(std::size_t number) const;
  void write_part();
  void go_on_from_parts();
  void remove_other_parts() const;
  bool joined() const;
  bool parts_are_whole() const;
  void take_apart();  ///< NAME.h5md
  void remove_joined();

  std::filesystem::path file_;
  io::TrajectoryHeader header_;
  std::size_t part_bytes_;
  Contacts contacts_;
  std::shared_ptr<ContactRecord const> record_;  ///< or none
  std::optional<io::H5mdFile> open_;             ///< the part in memory
  Unwrapping unwrapping_;
  std::vector<std::uint64_t> hashes_;  ///< of the parts on the disk, seals left out
  std::int64_t last_step_ = -1;        ///< of the frames so far
  bool outdated_ = false;              ///< NAME.h5md, which lacks frames that the parts have
  int saves_ = 0;
};

}  // namespace bagnold
