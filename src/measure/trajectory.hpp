// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "src/io/h5md_file.hpp"
#include "src/measure/frame_observer.hpp"

namespace bagnold {

/// Frames on the disk: in parts while a run goes on, NAME.parts/000000.h5md and so on, one for each
/// stretch between two checkpoints, and one file NAME.h5md in the end.
///
/// HDF5 does not survive a kill while it writes, so no file that a checkpoint counts on is ever
/// opened for writing again: a part is closed and brought to the disk before the checkpoint that
/// counts it is written, and a resumed run drops the parts that its checkpoint does not count.
/// Every part is a trajectory of its own. Nothing is copied but once, at the end.
class Trajectory final : public FrameObserver {
 public:
  /// file: NAME.h5md.
  Trajectory(std::filesystem::path file, io::TrajectoryHeader header);

  /// Those of several systems may be called by threads of their own.
  void add(Frame const& frame) override;
  void save(Numbers& numbers) override;
  /// FileError where a part that the checkpoint counts is gone.
  void load(Numbers const& numbers) override;
  void report(std::vector<FrameObserver const*> const&, FrameResults&) const override {}

  /// Drops what an earlier run left.
  void begin() override;

  /// Joins the parts into NAME.h5md, and writes NAME.xdmf beside it. May be called again.
  void finish() override;

  /// Removes the parts.
  void tidy() override;

 private:
  std::filesystem::path part(std::size_t number) const;
  std::filesystem::path folder() const;

  std::filesystem::path file_;
  io::TrajectoryHeader header_;
  std::optional<io::H5mdFile> open_;
  std::size_t parts_ = 0;  ///< closed
};

}  // namespace bagnold
