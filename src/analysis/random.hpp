// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace bagnold::analysis {

/// Index of a draw: the resampling and the datum. Replica 0 is the measured data; replicas from 1
/// on are resampled.
struct Draw {
  std::uint64_t seed = 1;
  std::uint32_t replica = 0;
  std::uint32_t datum = 0;
};

/// An index below `count`, for the k-th of a datum's seeds.
std::size_t random_index(Draw const& draw, std::uint32_t k, std::size_t count);

/// A number, uniform in (-1/2, 1/2), different for each purpose.
double random_offset(Draw const& draw, std::string_view purpose);

/// A normal number of mean 0 and variance 1, different for each purpose (the name of a quantity).
double random_normal(Draw const& draw, std::string_view purpose);

}  // namespace bagnold::analysis
