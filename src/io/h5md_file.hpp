// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/io/h5md_contacts.hpp"
#include "src/io/hdf5_handle.hpp"
#include "src/state/state.hpp"

namespace bagnold::io {

/// Data that all frames of a trajectory share.
struct TrajectoryHeader {
  std::string version;           ///< of Bagnold
  std::vector<double> diameter;  ///< [N], [d_s]
  std::vector<double> mass;      ///< [N], [m]
  bool spins = false;            ///< whether frames have them
  std::string scene = {};        ///< TOML, for /parameters; "": none
  bool numbers = true;    ///< whether frames have strain, rate, offset and images: parts of older
                          ///< versions have none
  bool contacts = false;  ///< whether frames have theirs
};

/// [N]: how many cell vectors along x and y to add to a position to follow a disk.
using Images = std::vector<std::array<std::int32_t, 2>>;

/// Numbers of a frame, beside its state.
struct FrameNumbers {
  std::int64_t step = 0;
  double strain = 0;   ///< since step 0
  Images images = {};  ///< empty: all zero
  FrameContacts contacts = {};
};

/// Shift in x of the image above, in [-L_x/2, L_x/2), [d_s]. floor, not round: a tilt of half a box
/// stays as it is when it is written again.
double tilt_of(State const& state);

/// A trajectory in the form H5MD 1.1 (P. de Buyl, P. Colberg, F. Hoefling, Comput. Phys. Commun.
/// 185, 1546 (2014)), frame by frame; docs/files.md tells what is in it. Its calls may come from
/// one thread after the other. Throws FileError.
class H5mdFile {
 public:
  /// file: new and empty, in memory or on a disk.
  H5mdFile(Handle file, TrajectoryHeader const& header);
  ~H5mdFile();
  H5mdFile(H5mdFile&&) = default;

  /// Disks of the state in the box.
  void append(State const& state, FrameNumbers const& numbers);

  /// Length so far.
  std::size_t bytes() const;

  /// The file with all that was written to it, and nothing in it left open. Nothing may follow.
  Handle close();

 private:
  Handle series(std::string const& path, hid_t type, Shape const& frame_shape);

  hsize_t count_;  ///< N
  Handle file_, step_, time_, edges_, position_, velocity_, spin_, image_, strain_, rate_, offset_;
  std::optional<H5mdContacts> contacts_;
};

/// visit(state, numbers) for every frame of an open file, in order; bits are those that were
/// appended, but of the time-independent members only those of the box are set, box_aspect up to
/// rounding: the height is exact. Of files of older versions there are neither strain, rate nor
/// images. Throws FileError.
void for_each_frame(Handle const& file,
                    std::function<void(State const&, FrameNumbers const&)> const& visit);

/// True if the frames of an open file have strain, rate, offset and images.
bool has_numbers(Handle const& file);

}  // namespace bagnold::io
