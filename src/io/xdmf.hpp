// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bagnold::io {

/// What ParaView needs to know of an H5MD file beside it: XDMF 3, points with diameter, species,
/// velocity and spin. time: [frames], [tau_e].
std::string xdmf_of(std::string const& h5md_name, std::size_t count,
                    std::vector<double> const& time, bool spins);

}  // namespace bagnold::io
