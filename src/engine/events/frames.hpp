// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "src/engine/events/event_disks.hpp"

namespace bagnold::events {

/// Takes all disks into the box, each with its path, contacts and clusters, and counts times from
/// there. A disk's place is seen from its image w = (m, n) from then on:
///
///     r' = r - (m L_x + n gamma L_y, n L_y),   v' = v - n gammadot L_y x^
template <bool Rotates>
class Frames {
 public:
  /// before: the box when times were last counted from; box: at `time`, its offset in [0, L_x).
  Frames(EventDisks<Rotates> const& disks, ShearedBox const& before, ShearedBox const& box,
         Real time)
      : disks_(disks),
        box_(box),
        time_(time),
        turns_(static_cast<int>(
            std::lround((before.offset + before.strain_rate * before.height * time - box.offset) /
                        box.length))) {
    for (std::uint32_t i = 0; i < disks.count(); ++i) {
      auto position = disks.at(i, time).position;
      auto const n = static_cast<int>(std::floor(position.y / box.height));
      position = position - Vec2<Real>{n * box.offset, n * box.height};
      auto const m = static_cast<int>(std::floor(position.x / box.length));
      position.x -= m * box.length;
      position_.push_back(position);
      image_.push_back({m, n});
    }
  }

  std::vector<Vec2<Real>> const& position() const { return position_; }

  void move(std::uint32_t i, Path& path) const {
    path.place = path.at(time_) - shift(i, time_);
    path.velocity.x -= speed(i);
    path.begun -= time_;
    path.straight -= time_;
  }

  /// But for its times, which are those of all contacts.
  void move(LoneContact<Rotates>& contact) const {
    auto& centre = contact.centre;
    centre.position = centre.position - shift(contact.i, contact.begun);
    centre.velocity.x -= speed(contact.i);
    contact.other = seen(contact.i, contact.other);
  }

  void move(Cluster<Rotates>& cluster) const {
    for (auto& m : cluster.members) {
      m.begin.position = m.begin.position - shift(m.disk, cluster.time);
      m.begin.motion.velocity.x -= speed(m.disk);
    }
    for (auto& link : cluster.links) {
      link.other = seen(cluster.members[link.a].disk, link.other);
      link.touched -= time_;
    }
    cluster.time -= time_;
  }

 private:
  Real speed(std::uint32_t i) const { return box_.velocity_shift(image_[i]); }
  Vec2<Real> shift(std::uint32_t i, Real time) const {
    auto of = box_.shift(image_[i]);
    of.x += speed(i) * (time - time_);
    return of;
  }

  /// The image of a neighbour, as i sees it from its new place.
  Neighbor seen(std::uint32_t i, Neighbor other) const {
    auto const old = other.image();
    auto const &of_i = image_[i], &of_j = image_[other.index()];
    return Neighbor::make(other.index(),
                          {old.m + old.n * turns_ - of_i.m + of_j.m, old.n - of_i.n + of_j.n},
                          other.big());
  }

  EventDisks<Rotates> const& disks_;
  ShearedBox box_;
  Real time_;
  int turns_;  ///< of the offset through the box
  std::vector<Vec2<Real>> position_;
  std::vector<Image> image_;
};

}  // namespace bagnold::events
