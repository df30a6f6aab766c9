// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_handle.hpp"

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

Handle without_times(hid_t kind) {
  Handle made(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(made.get(), false);
  return made;
}

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  if (reason.empty()) return "no reason given";
  // what the system said, which HDF5 hands on among much else
  constexpr std::string_view before = "error message = '";
  auto const begin = reason.find(before);
  if (begin == std::string::npos) return reason;
  auto const text = reason.substr(begin + before.size());
  return text.substr(0, text.find('\''));
}

}  // namespace bagnold::io
