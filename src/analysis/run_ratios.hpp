// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bagnold::analysis {

/// A function of the means of some observables.
using OfMeans = std::function<double(std::span<double const> means)>;

/// Standard error of f of the means of observables `names` of one run, from the series of its
/// result.h5: the jackknife over blocks whose length is that of f itself (statistics/estimate.hpp),
/// so what varies together in numerator and denominator does not count. NaN where the file or a
/// series is not there, or the run is too short for an error; rough ones count. Contacts that
/// windows cut compensate later ones: where twelve long blocks tell less than chance allows, theirs
/// counts. What falls as 1/T, as of tau_dur nu_coll/Z the contacts that the ends of a run of time T
/// cut, no blocks tell: twelve make it up to three times too large.
///
/// A window has a value of each observable. Their mean is over evaluations, or over what the
/// observable is itself a mean of (contacts that end for tau_dur, contacts for v_N_rms, pressure
/// for mu), so that it fluctuates as the observable of the whole run does.
double error_of_run(std::filesystem::path const& result, std::vector<std::string> const& names,
                    OfMeans const& f);

}  // namespace bagnold::analysis
