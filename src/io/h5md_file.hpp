// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "src/io/hdf5_handle.hpp"
#include "src/state/state.hpp"

namespace bagnold::io {

/// What all frames of a trajectory have in common.
struct TrajectoryHeader {
  std::string version;           ///< of Bagnold
  std::vector<double> diameter;  ///< [N], [d_s]
  std::vector<double> mass;      ///< [N], [m]
  bool spins = false;            ///< whether frames have them
};

/// A trajectory in the form H5MD 1.1 (P. de Buyl, P. Colberg, F. Hoefling, Comput. Phys. Commun.
/// 185, 1546 (2014)), frame by frame; SCHEMA.md tells what is in it. Its calls may come from one
/// thread after the other. Throws FileError.
class H5mdFile {
 public:
  /// file: new and empty, in memory or on a disk.
  H5mdFile(Handle file, TrajectoryHeader const& header);
  ~H5mdFile();
  H5mdFile(H5mdFile&&) = default;

  /// Disks of the state in the box.
  void append(State const& state, std::int64_t step);

  /// Length so far.
  std::size_t bytes() const;

  /// The file with all that was written to it, and nothing in it left open. Nothing may follow.
  Handle close();

 private:
  Handle series(std::string const& name, hid_t type, Shape const& frame_shape);
  void put(Handle const& set, hid_t type, void const* values);

  hsize_t count_;  ///< N
  hsize_t frames_ = 0;
  Handle file_, step_, time_, edges_, position_, velocity_, spin_;
};

/// visit(state, step) for every frame of an open file, in order; bits are those that were appended,
/// but of the time-independent members only those of the box are set, box_aspect up to rounding:
/// the height is exact. Throws FileError.
void for_each_frame(Handle const& file,
                    std::function<void(State const&, std::int64_t)> const& visit);

}  // namespace bagnold::io
