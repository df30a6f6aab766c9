// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_handle.hpp"

#include <atomic>

namespace bagnold::io {
namespace {

herr_t keep_first(unsigned, H5E_error2_t const* error, void* text) {
  auto& reason = *static_cast<std::string*>(text);
  if (reason.empty() && error->desc != nullptr) reason = error->desc;
  return 0;
}

}  // namespace

void quiet_hdf5() {
  // At exit HDF5 would close again, and crash on, a file that a full disk kept it from closing. It
  // must be told before its first use; nothing is left open that the end of the program should
  // close.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

std::string name_in_memory() {
  static std::atomic<unsigned long> count = 0;
  return "memory " + std::to_string(++count);
}

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason.empty() ? "no reason given" : reason;
}

}  // namespace bagnold::io
