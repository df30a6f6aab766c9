// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/unwrapping.hpp"

#include <cmath>
#include <utility>

namespace bagnold {

io::Images Unwrapping::next(State const& state, double strain) {
  io::Images images(state.count(), {0, 0});
  double const length = state.box_length, height = state.box_height(), tilt = io::tilt_of(state);
  double const scale = begun_ ? length / length_ : 1;
  for (std::size_t i = 0; begun_ && i < state.count(); ++i) {
    auto const [x, y] = state.position[i];
    double const x_before = scale * position_[i][0], y_before = scale * position_[i][1];
    auto const [columns, rows] = images_[i];
    double const up = rows - std::round((y - y_before) / height);
    double const flow = (y_before + rows * height + y + up * height) / 2;
    double const expected =
        x_before + columns * length + rows * scale * tilt_ + (strain - strain_) * flow;
    double const along = std::round((expected - x - up * tilt) / length);
    images[i] = {static_cast<std::int32_t>(along), static_cast<std::int32_t>(up)};
  }
  go_on_from(state, strain, images);
  return images;
}

void Unwrapping::go_on_from(State const& state, double strain, io::Images images) {
  position_ = state.position;
  images_ = std::move(images);
  strain_ = strain;
  length_ = state.box_length;
  tilt_ = io::tilt_of(state);
  begun_ = true;
}

}  // namespace bagnold
