// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "src/io/hdf5_handle.hpp"
#include "src/state/frame_contact.hpp"

namespace bagnold::io {

/// The contacts of the frames of a trajectory, in its group /contacts: `count`, of each frame, and
/// those of all frames end to end. docs/files.md tells what is in it. Throws FileError.
class H5mdContacts {
 public:
  /// file: without that group. contact_count: about, of a frame.
  H5mdContacts(Handle const& file, hsize_t contact_count);

  void append(FrameContacts const& contacts);
  void close();

 private:
  Handle count_, pair_, overlap_, normal_, velocity_, elastic_, dissipative_, age_;
};

bool has_contacts(Handle const& file);

/// Reads the contacts of the frames of a file, one after the other, bit for bit.
class H5mdContactsReader {
 public:
  explicit H5mdContactsReader(Handle const& file) : file_(file) {}
  FrameContacts next();

 private:
  Handle const& file_;
  hsize_t frame_ = 0, first_ = 0;
};

}  // namespace bagnold::io
