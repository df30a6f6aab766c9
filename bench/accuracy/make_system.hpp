// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/accuracy/precision.hpp"
#include "bench/accuracy/schemes/groot_warren.hpp"
#include "bench/accuracy/schemes/implicit_verlet.hpp"
#include "bench/accuracy/schemes/increment_sweep.hpp"
#include "bench/accuracy/schemes/modified_velocity_verlet.hpp"
#include "bench/accuracy/schemes/pairwise_sweep.hpp"
#include "bench/accuracy/schemes/two_stage.hpp"
#include "bench/accuracy/system.hpp"
#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"
#include "src/config/scene_physics.hpp"
#include "src/config/skin.hpp"

namespace bagnold::accuracy {

/// Contacts without an elastic force.
struct NoRepulsion {
  static constexpr double force_exponent = 2.0;
  template <class T>
  T magnitude(Contact<T> const&) const {
    return 0;
  }
};

template <class W, Scheme<W> S>
class SteppedBy final : public System {
 public:
  SteppedBy(W world, S scheme, bool synchronous) : world_(std::move(world)), scheme_(scheme) {
    if (S::staggered && synchronous) half_a_step_back();
  }
  void step(Sample* sample) override { scheme_.step(world_, sample); }
  State state() const override { return world_.state(); }
  Counts counts() const override { return world_.counts; }
  void place(State const& state) override {
    for (std::size_t i = 0; i < world_.size(); ++i)
      world_.position[i] = {static_cast<typename W::Kept>(state.position[i][0]),
                            static_cast<typename W::Kept>(state.position[i][1])};
  }

 private:
  void half_a_step_back() {
    typename W::Touches touches;
    world_.find_touches(world_.position, world_.step, touches);
    auto const felt = world_.motion;
    double const time = -world_.clock.time_step / 2;
    kick_elastic(world_, touches, time, world_.motion);
    kick_dissipative(world_, touches, time, felt, world_.motion);
    world_.counts = {.builds = world_.counts.builds};
  }

  W world_;
  S scheme_;
};

template <template <class> class S, class W>
std::unique_ptr<System> stepped_by(W const& world, bool synchronous) {
  return std::make_unique<SteppedBy<W, S<W>>>(world, S<W>{}, synchronous);
}

template <class W>
std::unique_ptr<System> in_double(W const& world, std::string const& scheme, bool synchronous) {
  if (scheme == ModifiedVelocityVerlet<W>::name)
    return stepped_by<ModifiedVelocityVerlet>(world, synchronous);
  if (scheme == LaggedVelocityVerlet<W>::name)
    return stepped_by<LaggedVelocityVerlet>(world, synchronous);
  if (scheme == GrootWarren<W>::name) return stepped_by<GrootWarren>(world, synchronous);
  if (scheme == ImplicitVerlet<W>::name) return stepped_by<ImplicitVerlet>(world, synchronous);
  if (scheme == PairwiseSweep<W>::name) return stepped_by<PairwiseSweep>(world, synchronous);
  if (scheme == IncrementSweep<W>::name) return stepped_by<IncrementSweep>(world, synchronous);
  if (scheme == TwoStage<W>::name) return stepped_by<TwoStage>(world, synchronous);
  throw InputError("scheme = \"" + scheme + "\" (not known); --list names them");
}

/// Only the papers' scheme and the one that won: other precisions are a question to these.
template <class W>
std::unique_ptr<System> in_float(W const& world, std::string const& scheme, bool synchronous) {
  if (scheme == ModifiedVelocityVerlet<W>::name)
    return stepped_by<ModifiedVelocityVerlet>(world, synchronous);
  if (scheme == TwoStage<W>::name) return stepped_by<TwoStage>(world, synchronous);
  throw InputError(
      "scheme = \"" + scheme +
      "\" (in float only modified-velocity-verlet and two-stage); use --precision double");
}

/// Instantiated for each law in a source file of its own.
template <ContactLaw Law>
std::unique_ptr<System> make_for_law(Scene const& scene, State const& state, Method const& method,
                                     bool synchronous) {
  auto const world = [&]<class Repulsion, class Precision>() {
    World<Law, Repulsion, Precision> w(make_law<Law>(scene.disks),
                                       make_species_table(scene.mass_by_area()), state,
                                       scene.shear.strain_rate, method.time_step);
    w.skin = skin(scene);
    w.arrangement = method.arrangement;
    return w;
  };
  using R = HarmonicRepulsion;
  if (!method.elastic)
    return in_double(world.template operator()<NoRepulsion, DoublePrecision>(), method.scheme,
                     synchronous);
  if (method.precision == DoublePrecision::name)
    return in_double(world.template operator()<R, DoublePrecision>(), method.scheme, synchronous);
  if (method.precision == FloatPairs::name)
    return in_float(world.template operator()<R, FloatPairs>(), method.scheme, synchronous);
  if (method.precision == SinglePrecision::name)
    return in_float(world.template operator()<R, SinglePrecision>(), method.scheme, synchronous);
  throw InputError("precision = \"" + method.precision +
                   "\" (not known); use double, float-pairs or float");
}

extern template std::unique_ptr<System> make_for_law<CD>(Scene const&, State const&, Method const&,
                                                         bool);
extern template std::unique_ptr<System> make_for_law<CDn>(Scene const&, State const&, Method const&,
                                                          bool);
extern template std::unique_ptr<System> make_for_law<CDrot>(Scene const&, State const&,
                                                            Method const&, bool);

}  // namespace bagnold::accuracy
