// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "src/config/scene.hpp"
#include "src/measure/frame_observer.hpp"

/// Hand-made states for the tests of frames.
namespace bagnold::test {

inline Scene plain_scene(std::string const& model, double strain_rate) {
  Scene scene;
  scene.disks.model = model;
  scene.disks.elasticity = 2.0;
  scene.disks.mass = "equal";
  scene.disks.packing_fraction = 0.5;
  scene.shear.strain_rate = strain_rate;
  return scene;
}

/// side x side small disks on a square lattice that fills the box, in the mean flow; N = side^2.
inline State square_lattice(int side, double spacing, double strain_rate) {
  State state;
  state.box_length = side * spacing;
  state.strain_rate = strain_rate;
  for (int k = 0; k < side * side; ++k) {
    double const x = (k % side + 0.5) * spacing, y = (k / side + 0.5) * spacing;
    state.position.push_back({x, y});
    state.velocity.push_back({strain_rate * y, 0.0});
    state.diameter.push_back(1.0);
  }
  return state;
}

/// y - from within one period, in -L/2 .. L/2.
inline double around(double y, double from, double length) {
  return y - from - length * std::round((y - from) / length);
}

template <class Table>
Table const& named(std::vector<Table> const& tables, std::string const& name) {
  for (auto const& table : tables)
    if (table.name == name) return table;
  throw std::out_of_range(name);
}

}  // namespace bagnold::test
