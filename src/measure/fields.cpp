// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/fields.hpp"

#include "src/measure/local_fields.hpp"

namespace bagnold {

Fields::Fields()
    : packing_fraction_(even_edges(0.0, 1.2, 240)), strain_rate_(sinh_edges(1.0, 12.0, 240)) {}

void Fields::add(Frame const& frame) {
  State const& state = frame.state;
  auto const fields = local_fields(state);
  last_.clear();
  for (std::size_t i = 0; i < state.count(); ++i) {
    packing_fraction_.add(fields.packing_fraction[i]);
    strain_rate_.add(fields.strain_rate[i] / state.strain_rate.value());
    last_.insert(last_.end(), {state.position[i][0], state.position[i][1], state.diameter[i],
                               fields.packing_fraction[i], fields.strain_rate[i]});
  }
  frame_ = {static_cast<double>(frame.step), frame.strain, state.box_length, state.offset};
}

void Fields::save(ObserverState& numbers) {
  numbers["local_phi"] = packing_fraction_.numbers();
  numbers["local_gammadot"] = strain_rate_.numbers();
  numbers["fields"] = last_;
  numbers["fields_frame"] = frame_;
}

void Fields::load(ObserverState const& numbers) {
  packing_fraction_.restore(numbers.at("local_phi"));
  strain_rate_.restore(numbers.at("local_gammadot"));
  last_ = numbers.at("fields");
  frame_ = numbers.at("fields_frame");
}

void Fields::forget_before(double /*strain*/) { *this = Fields(); }

void Fields::report(std::vector<FrameObserver const*> const& systems, FrameResults& results) const {
  Fields all;
  for (auto const* system : systems) {
    auto const& of = dynamic_cast<Fields const&>(*system);
    all.packing_fraction_.add(of.packing_fraction_);
    all.strain_rate_.add(of.strain_rate_);
  }
  results.histograms.push_back(all.packing_fraction_.histogram(
      "local_phi", "1", "packing fraction within 4 d_s of a disk, P2 Fig. 27"));
  results.histograms.push_back(all.strain_rate_.histogram(
      "local_gammadot", "1", "strain rate within 4 d_s of a disk over gammadot, P2 Fig. 27"));
  results.samples.push_back(
      {"fields",
       "disks of the last frame and what is within 4 d_s of each, P2 Fig. 27",
       {"x [d_s]", "y [d_s]", "diameter [d_s]", "phi [1]", "gammadot [1/tau_e]"},
       last_});
  results.samples.push_back({"fields_frame",
                             "the frame of `fields`",
                             {"step [1]", "strain [1]", "box_length [d_s]", "offset [d_s]"},
                             frame_});
}

}  // namespace bagnold
