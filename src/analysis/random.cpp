// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/random.hpp"

#include <Random123/philox.h>

#include <Random123/uniform.hpp>
#include <cmath>
#include <numbers>

namespace bagnold::analysis {
namespace {

using Philox = r123::Philox2x64;

/// Two random words that depend on the draw and the purpose alone.
Philox::ctr_type random_words(Draw const& draw, std::uint64_t purpose) {
  Philox const philox;
  std::uint64_t const which = (std::uint64_t{draw.replica} << 32) | draw.datum;
  return philox(Philox::ctr_type{{which, purpose}}, Philox::key_type{{draw.seed}});
}

/// FNV-1a, with the highest bit set: no index has it.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (char const letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  return hash | (std::uint64_t{1} << 63);
}

}  // namespace

std::size_t random_index(Draw const& draw, std::uint32_t k, std::size_t count) {
  auto const words = random_words(draw, k);
  auto const index =
      static_cast<std::size_t>(r123::u01<double>(words[0]) * static_cast<double>(count));
  return index < count ? index : count - 1;
}

double random_offset(Draw const& draw, std::string_view purpose) {
  return r123::u01<double>(random_words(draw, hash_of(purpose))[0]) - 0.5;
}

double random_normal(Draw const& draw, std::string_view purpose) {
  auto const words = random_words(draw, hash_of(purpose));
  double const radius = std::sqrt(-2.0 * std::log(r123::u01<double>(words[0])));
  return radius * std::cos(2.0 * std::numbers::pi * r123::u01<double>(words[1]));
}

}  // namespace bagnold::analysis
