// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>

#include "kernels/physics/vec2.hpp"

/// Forms of schemes. Engines are templates on the scheme, written for a form, so a scheme of one of
/// these forms runs in all of them. A new form needs its DeviceStep (kernels/device/dynamics), its
/// BlockStep (kernels/cpu/steps) and its step of a lone pair
/// (kernels/cpu/islands/binary_collisions.hpp).
///
/// Under any form a disk without force flies exactly r + v dt and keeps its v and its spin, to the
/// last bit. Renewal of lists, steps for few contacts and lookahead rely on it
/// (tests/kernels/physics/schemes/forms_test.cpp).
namespace bagnold {

/// Predict and correct: forces at the start of the step give a trial state a step later, whose
/// positions are r + v dt; forces there give the new state. For the velocity or the spin of a disk:
///
///     v~ = trial_velocity(v_0, f(r_0, v_0), dt/m),   r~ = trial_position(r_0, v_0, dt)
///     v_1 = velocity(v_0, v~, f(r~, v~), dt/2m),     r_1 = position(r_0, v_0, v_1, dt/2)
template <class S>
concept PredictCorrectScheme = requires(Vec2<Real> v, Real t) {
  { S::trial_velocity(v, v, t) } -> std::same_as<Vec2<Real>>;
  { S::trial_position(v, v, t) } -> std::same_as<Vec2<Real>>;
  { S::velocity(v, v, v, t) } -> std::same_as<Vec2<Real>>;
  { S::position(v, v, v, t) } -> std::same_as<Vec2<Real>>;
};

/// Two stages: all forces once a step; then the damping of the changes that they make, of which
/// `share` acts:
///
///     a = change(f(r_0, v_0), dt/m),          b_ij: the damping at share(z) (a_i - a_j)
///     v_1 = velocity(v_0, a, sum b, dt/m),    r_1 = position(r_0, v_1, dt)
///
/// z: SecondStage. velocity_of_pair: v_1 of a disk of a lone pair, from the forces of both stages.
template <class S>
concept TwoStageScheme = requires(Vec2<Real> v, Real t) {
  { S::share(t) } -> std::same_as<Real>;
  { S::change(v, t) } -> std::same_as<Vec2<Real>>;
  { S::velocity(v, v, v, t) } -> std::same_as<Vec2<Real>>;
  { S::velocity_of_pair(v, v, t) } -> std::same_as<Vec2<Real>>;
  { S::position(v, v, t) } -> std::same_as<Vec2<Real>>;
};

/// All forces once a step; then the change w of all velocities from an equation in which the
/// damping of w acts with the weight theta, solved by as many Chebyshev iterations as `terms` says,
/// of a polynomial with the given lift (ChebyshevIterations):
///
///     a = change(f(r_0, v_0), dt/m),          w - (theta dt/m) f_dis(r_0, w) = a
///     v_1 = velocity(v_0, w),                 r_1 = position(r_0, v_1, dt)
///
/// with f_dis(w) the damping of the contacts at r_0 where disks move with w.
template <class S>
concept ImplicitScheme = requires(Vec2<Real> v, Real t) {
  { S::theta } -> std::convertible_to<Real>;
  { S::terms(true) } -> std::same_as<int>;
  { S::lift } -> std::convertible_to<Real>;
  { S::change(v, t) } -> std::same_as<Vec2<Real>>;
  { S::velocity(v, v) } -> std::same_as<Vec2<Real>>;
  { S::position(v, v, t) } -> std::same_as<Vec2<Real>>;
};

}  // namespace bagnold
