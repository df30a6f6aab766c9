// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/listed.hpp"

#include <algorithm>

#include "kernels/physics/drives/drives.hpp"
#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/type_list.hpp"
#include "src/config/drives.hpp"

namespace bagnold {

namespace {

template <class List>
bool lists(std::string_view name) {
  return std::ranges::count(names_of<List>(), name) > 0;
}

}  // namespace

bool is_listed(std::string_view law, std::string_view drive) {
  return lists<Laws>(law) && (drive == no_drive || lists<Drives>(drive));
}

}  // namespace bagnold
