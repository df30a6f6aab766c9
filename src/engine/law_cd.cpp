// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/make_for_law.hpp"
#include "src/engine/ensemble/make_together.hpp"

namespace bagnold {

template std::unique_ptr<Simulation> make_for_law<CD>(Scene const&, Snapshot&,
                                                         std::string const&);
template std::shared_ptr<Ensemble> make_together_for_law<CD>(Scene const&,
                                                            std::vector<Snapshot> const&,
                                                            std::string const&);

}  // namespace bagnold
