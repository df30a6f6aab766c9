// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

namespace bagnold::io {

/// Lengths of the axes of a dataset, slowest first.
using Shape = std::vector<hsize_t>;

/// An HDF5 identifier, closed by its own function when it goes out of scope. Negative: the call
/// that made it failed.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  bool valid() const { return id_ >= 0; }
  /// Closes it now. False where HDF5 could not: what was to be written may not have been.
  [[nodiscard]] bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }
  hid_t get() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Stops HDF5 from printing its errors (on this thread), from loading filter plug-ins, and from
/// work at exit. Comes before any other use of HDF5 by a thread.
void quiet_hdf5();

/// Properties of a new file, group or dataset that keeps no times.
Handle without_times(hid_t kind);

/// The innermost reason of the HDF5 call that just failed; any further call forgets it.
std::string hdf5_reason();

}  // namespace bagnold::io
