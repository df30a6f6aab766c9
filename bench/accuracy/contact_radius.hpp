// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "src/config/scene.hpp"

namespace bagnold::accuracy {

/// Spectral radii of one step for two small disks held in contact.
struct ContactRadius {
  double normal;      ///< of the overlap and its velocity
  double tangential;  ///< of the sliding
};

/// By the eigenvalues of the step's matrix (Eigen), written down for each scheme from its
/// definition for mu x'' = -k_e x - k_d x'. InputError for a scheme it does not know.
ContactRadius contact_radius(Scene const& scene, std::string const& scheme, double time_step);

}  // namespace bagnold::accuracy
