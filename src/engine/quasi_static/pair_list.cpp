// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/pair_list.hpp"

#include <algorithm>
#include <utility>

#include "kernels/physics/box/list_criterion.hpp"

namespace bagnold::quasi_static {

namespace {

constexpr Real contact_margin = 1.02;  ///< of d_ij

}  // namespace

void PairList::build(Material const& material, std::vector<Vec2<Real>> position,
                     Moment const& now) {
  mark_ = now.clock.mark(now.step);
  part_ = now.part;
  box_ = box(now);
  at_build_ = std::move(position);
  search(material);
}

ShearedBox PairList::box(Moment const& now, ShearMark const& mark) {
  ShearedBox box = now.clock.box(now.step, mark);
  box.offset += now.part * (now.clock.offset(now.step + 1, mark) - box.offset);
  return box;
}

double PairList::strain(Moment const& now) const {
  double const begin = now.clock.strain_since(mark_, now.step);
  return begin + (now.part - part_) * (now.clock.strain_since(mark_, now.step + 1) - begin);
}

auto PairList::farthest(std::vector<Vec2<Real>> const& position, Moment const& now) const
    -> Farthest {
  double const since = strain(now);
  Farthest farthest;
  for (std::size_t i = 0; i < position.size(); ++i) {
    double const moved2 = nonaffine2(position[i], at_build_[i], since);
    if (moved2 > farthest.moved2) farthest = {moved2, i};
  }
  return farthest;
}

bool PairList::holds(std::vector<Vec2<Real>> const& position, Moment const& now,
                     double share) const {
  return list_holds(strain(now), farthest(position, now).moved2, share * skin_);
}

std::vector<NearPair> PairList::contacts() const {
  auto contacts = pairs_;
  std::erase_if(contacts, [&](NearPair const& pair) {
    auto const r = pair.separation(at_build_, box_);
    return dot(r, r) > contact_margin * contact_margin * pair.distance * pair.distance;
  });
  return contacts;
}

/// Within a step the offset may have passed L_x: the images are the same.
void PairList::search(Material const& material) {
  ShearedBox reduced = box_;
  bool const beyond = box_.offset >= box_.length;
  if (beyond) reduced.offset -= box_.length;
  pairs_ = near_pairs(at_build_, material.species, material.table, reduced, skin_);
  if (beyond)
    for (auto& pair : pairs_) pair.image.m -= pair.image.n;
}

}  // namespace bagnold::quasi_static
