// SPDX-License-Identifier: BSD-3-Clause
#include "src/simulation/make_for_law.hpp"

namespace bagnold {

template std::unique_ptr<Simulation> make_for_law<CDn>(Scene const&, Snapshot const&,
                                                         std::string const&);

}  // namespace bagnold
