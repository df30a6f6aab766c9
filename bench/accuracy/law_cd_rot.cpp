// SPDX-License-Identifier: BSD-3-Clause
#include "bench/accuracy/make_system.hpp"

namespace bagnold::accuracy {

template std::unique_ptr<System> make_for_law<CDrot>(Scene const&, State const&, Method const&,
                                                     bool);

}  // namespace bagnold::accuracy
