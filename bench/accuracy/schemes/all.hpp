// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/schemes/groot_warren.hpp"
#include "bench/accuracy/schemes/implicit_verlet.hpp"
#include "bench/accuracy/schemes/increment.hpp"
#include "bench/accuracy/schemes/modified_velocity_verlet.hpp"
#include "bench/accuracy/schemes/pairwise.hpp"
#include "bench/accuracy/schemes/two_stage.hpp"

namespace bagnold::accuracy {

template <class World>
Pairwise<World> pairwise(std::string const& w) {
  Pairwise<World> s;
  auto const has = [&](char const* part) { return w.find(part) != std::string::npos; };
  auto& o = s.options;
  if (has("-be")) o.relaxation = Relaxation::backward_euler;
  if (has("-cn")) o.relaxation = Relaxation::implicit_midpoint;
  if (has("-fwd")) o.order = Order::forward;
  if (has("-sym")) o.order = Order::symmetric;
  if (has("-fit")) o.elastic = Elastic::fitted;
  if (has("-in")) o.elastic = Elastic::within;
  if (has("-x0")) o.across = 0;
  if (has("-x2")) o.across = 2;
  return s;
}

template <class World>
Increment<World> increment(std::string const& w) {
  Increment<World> s;
  auto const has = [&](char const* part) { return w.find(part) != std::string::npos; };
  if (has("-be")) s.share = Share::euler;
  if (has("-cn")) s.share = Share::midpoint;
  if (has("-0")) s.sweeps = 0;
  if (has("-2")) s.sweeps = 2;
  if (has("-4")) s.sweeps = 4;
  if (has("-9")) s.sweeps = 99;
  s.alternate = has("-alt");
  if (has("-pj")) s.pack = 8;
  s.jacobi = has("-jac");
  if (has("-l7")) s.least = 1 / 7.0;
  if (has("-l8")) s.least = 1 / 8.0;
  if (has("-l6")) s.least = 1 / 6.0;
  if (has("-j2")) s.jacobi_parts = 2;
  for (int n : {1, 3, 4, 5, 6})
    if (has(("-j" + std::to_string(n)).c_str())) s.jacobi_parts = n;
  return s;
}

/// use(scheme) for the scheme of that name.
template <class World, class Use>
void with_scheme(std::string const& name, Use const& use) {
  if (name == "heun") return use(ModifiedVelocityVerlet<World>{});
  if (name == "lag") return use(LaggedVelocityVerlet<World>{});
  if (name == "gw") return use(GrootWarren<World>{});
  if (name == "implicit") return use(ImplicitVerlet<World>{});
  if (name.rfind("pair", 0) == 0) return use(pairwise<World>(name));
  if (name.rfind("inc", 0) == 0) return use(increment<World>(name));
  if (name.rfind("two", 0) == 0) {
    TwoStage<World> s;
    if (name.find("-l8") != std::string::npos) s.least = 1.0 / 8;
    if (name.find("-l2") != std::string::npos) s.least = 1.0 / 2;
    return use(s);
  }
  throw InputError("no scheme " + name);
}

}  // namespace bagnold::accuracy
