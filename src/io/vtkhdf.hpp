// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bagnold::io {

/// File that lets ParaView, VTK and pyvista read an H5MD file beside it: VTKHDF 2.0, an
/// unstructured grid of vertices over time, with velocity, spin, diameter and species of each. Its
/// datasets are virtual: the values are those in the H5MD file. time: [frames], [tau_e]. Throws
/// FileError.
std::vector<std::byte> vtkhdf_of(std::string const& h5md_name, std::size_t count,
                                 std::vector<double> const& time, bool spins);

}  // namespace bagnold::io
