// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "kernels/physics/box/sheared_box.hpp"
#include "kernels/physics/closed_form/contact_integrals.hpp"
#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/repulsion/repulsion.hpp"

namespace bagnold::test {

using Long = long double;

/// Two disks and an image of the second one that they touch through, in a sheared box.
template <class Law>
struct TwoDisks {
  static constexpr bool rotates = Law::rotates;

  Law law;
  bool mass_by_area;
  Species species_i, species_j;
  ShearedBox box;  ///< at s = 0
  Image image;     ///< of j
  DiskMotion<rotates> i, j;

  SpeciesTable table() const { return make_species_table(mass_by_area); }
  ContactClass<rotates> contact_class() const {
    return ContactClass<rotates>::of_constants(law.normal_damping(), law.tangential_damping(),
                                               table(), species_i, species_j);
  }
  DiskMotion<rotates> image_of_j() const {
    auto of = j;
    of.position += box.shift(image);
    of.motion.velocity.x += box.velocity_shift(image);
    return of;
  }
  PairMotion<rotates> pair() const { return pair_motion(i, image_of_j()); }
  ClosedContact<rotates> begin() const {
    return ClosedContact<rotates>::begin(contact_class(), pair());
  }
  Real mass(Species species) const { return 1 / table().inverse_mass[species]; }
};

/// The motion of two disks, step by step in long double: the law's own force, Gauss's scheme of
/// three stages, sixth order, on positions, velocities, spins of both and on integrals of all sums.
template <class Law>
class Integrated {
 public:
  static constexpr bool rotates = Law::rotates;
  static constexpr int columns = SumColumns::count_rotating;

  struct Sums {
    std::array<Long, columns> column{};
    std::array<Long, ContactMotion::count> motion{};
    Long virial[2][2]{}, velocity[2][2]{};  ///< f_a r_b of both forces, v_a v_b of v_ij
  };
  struct At {
    Long time = 0;
    std::array<Long, 10> y{};  ///< x, y, v_x, v_y, thetadot of i, of j
    Sums sums;
  };

  /// j is moved by a rounding error, to where it touches i exactly: that would change the time of
  /// the end by the error over the speed.
  explicit Integrated(TwoDisks<Law> const& of) : of_(of) {
    auto const put = [&](int at, DiskMotion<rotates> const& disk) {
      start_.y[at] = disk.position.x;
      start_.y[at + 1] = disk.position.y;
      start_.y[at + 2] = disk.motion.velocity.x;
      start_.y[at + 3] = disk.motion.velocity.y;
      if constexpr (rotates) start_.y[at + 4] = disk.motion.spin;
    };
    put(0, of.i);
    put(5, of.j);
    auto const r = pair(start_.y, 0).separation;
    Long const more = 1 - distance() / std::sqrt(dot(r, r));
    start_.y[5] += more * r.x;
    start_.y[6] += more * r.y;
  }

  At const& start() const { return start_; }

  At after(At at, Long time, int steps = 100) const {
    for (int n = 0; n < steps; ++n) step(at, time / steps);
    return at;
  }

  /// From near the end to where r_ij = d_ij.
  At end(Long near) const {
    At at = after(start_, near);
    for (int n = 0; n < 5; ++n) {
      auto const p = pair(at.y, at.time);
      Long const r = std::sqrt(dot(p.separation, p.separation));
      Long const speed = dot(p.separation, p.velocity) / r;
      at = after(at, (distance() - r) / speed, 1);
    }
    return at;
  }

  struct Pair {
    Vec2<Long> separation, velocity;
    Long spins;  ///< d_i thetadot_i + d_j thetadot_j
  };
  Pair pair(std::array<Long, 10> const& y, Long time) const {
    Long const strain_rate = of_.box.strain_rate, n = of_.image.n;
    Long const speed = n * strain_rate * of_.box.height;
    Vec2<Long> const shift{
        of_.image.m * (Long)of_.box.length + n * (Long)of_.box.offset + time * speed,
        n * (Long)of_.box.height};
    return {{y[0] - y[5] - shift.x, y[1] - y[6] - shift.y},
            {y[2] - y[7] - speed, y[3] - y[8]},
            d_i() * y[4] + d_j() * y[9]};
  }

  PairForce<Long> force(Pair const& p) const {
    Long const r = std::sqrt(dot(p.separation, p.separation));
    ::bagnold::Contact<Long> contact;
    contact.normal = (1 / r) * p.separation;
    contact.relative_overlap = 1 - r / distance();
    contact.inverse_distance = 1 / distance();
    contact.velocity =
        velocity_at_contact<Law>(p.velocity, p.separation, contact.inverse_distance, p.spins);
    return {p.separation, HarmonicRepulsion{}.magnitude(contact) * contact.normal,
            of_.law.dissipative_force(contact), contact.relative_overlap, contact.velocity};
  }

  Long distance() const { return class_distance(pair_class(of_.species_i, of_.species_j)); }

 private:
  using Y = std::array<Long, 10>;

  Long d_i() const { return of_.species_i ? big_diameter : small_diameter; }
  Long d_j() const { return of_.species_j ? big_diameter : small_diameter; }

  Y slope(Y const& y, Long time) const {
    auto const f = force(pair(y, time));
    auto const t = of_.table();
    Vec2<Long> const on_i = f.elastic + f.dissipative;
    Long const torque = f.torque_per_diameter(1 / distance());
    Long const i = t.inverse_mass[of_.species_i], j = t.inverse_mass[of_.species_j];
    Y of{y[2], y[3], i * on_i.x, i * on_i.y, 0, y[7], y[8], -j * on_i.x, -j * on_i.y, 0};
    if constexpr (rotates) {
      of[4] = torque * d_i() * t.inverse_inertia[of_.species_i];
      of[9] = torque * d_j() * t.inverse_inertia[of_.species_j];
    }
    return of;
  }

  void add(Sums& to, Y const& y, Long time, Long weight) const {
    using C = SumColumns;
    auto const p = pair(y, time);
    auto const f = force(p);
    auto const of = columns_of(f);
    for (int k = 0; k < pair_columns; ++k) to.column[k] += weight * of.value[k];
    to.column[C::contacts] += 2 * weight;
    auto const disk = [&](int at, Long mass) {
      Long const u = y[at + 2] - of_.box.strain_rate * y[at + 1], v = y[at + 3];
      to.column[C::kinetic_xx] += weight * mass * u * u;
      to.column[C::kinetic_xy] += weight * mass * u * v;
      to.column[C::kinetic_yy] += weight * mass * v * v;
      to.column[C::velocity_x2] += weight * u * u;
      to.column[C::velocity_y2] += weight * v * v;
      to.column[C::spin] += weight * y[at + 4];
      to.column[C::spin2] += weight * y[at + 4] * y[at + 4];
    };
    disk(0, of_.mass(of_.species_i));
    disk(5, of_.mass(of_.species_j));
    to.column[C::torque_power] +=
        weight * f.torque_per_diameter(1 / distance()) * (d_i() * y[4] + d_j() * y[9]);
    // ContactMotion, by P2 Eqs. (30)-(34)
    Long const r = std::sqrt(dot(p.separation, p.separation));
    Long const normal = -dot(p.velocity, p.separation) / r;
    Long const tangential = cross(p.velocity, p.separation) / r;
    Long const rolling = r * p.spins / (d_i() + d_j());
    using M = ContactMotion;
    Long const products[M::count] = {normal * normal,
                                     tangential * tangential,
                                     rolling * rolling,
                                     tangential * rolling,
                                     tangential * normal,
                                     rolling * normal,
                                     tangential,
                                     rolling,
                                     normal,
                                     1};
    for (int k = 0; k < M::count; ++k) to.motion[k] += weight * products[k];
    Vec2<Long> const total = f.elastic + f.dissipative;
    Long const force[2] = {total.x, total.y}, at[2] = {p.separation.x, p.separation.y};
    Long const v[2] = {p.velocity.x, p.velocity.y};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        to.virial[a][b] += weight * force[a] * at[b];
        to.velocity[a][b] += weight * v[a] * v[b];
      }
  }

  void step(At& at, Long h) const {
    static Long const q = std::sqrt(15.0L);
    static Long const a[3][3] = {{5 / 36.0L, 2 / 9.0L - q / 15, 5 / 36.0L - q / 30},
                                 {5 / 36.0L + q / 24, 2 / 9.0L, 5 / 36.0L - q / 24},
                                 {5 / 36.0L + q / 30, 2 / 9.0L + q / 15, 5 / 36.0L}};
    static Long const b[3] = {5 / 18.0L, 4 / 9.0L, 5 / 18.0L};
    static Long const c[3] = {0.5L - q / 10, 0.5L, 0.5L + q / 10};
    Y slopes[3], stage[3];
    for (auto& s : slopes) s = slope(at.y, at.time);
    bool changed = true;
    for (int iteration = 0; changed && iteration < 20; ++iteration) {
      for (int k = 0; k < 3; ++k) {
        stage[k] = at.y;
        for (int l = 0; l < 3; ++l)
          for (std::size_t n = 0; n < 10; ++n) stage[k][n] += h * a[k][l] * slopes[l][n];
      }
      changed = false;
      for (int k = 0; k < 3; ++k) {
        auto const next = slope(stage[k], at.time + c[k] * h);
        Long change = 0, size = 0;
        for (std::size_t n = 0; n < 10; ++n) {
          change += std::abs(next[n] - slopes[k][n]);
          size += std::abs(next[n]);
        }
        changed = changed || change > 1e-18L + 1e-17L * size;  // rounding of 1 - r/d
        slopes[k] = next;
      }
    }
    for (int k = 0; k < 3; ++k) {
      for (std::size_t n = 0; n < 10; ++n) at.y[n] += h * b[k] * slopes[k][n];
      add(at.sums, stage[k], at.time + c[k] * h, h * b[k]);
    }
    at.time += h;
  }

  TwoDisks<Law> of_;
  At start_;
};

/// How disks meet: angles of the normal and from it to the approach, [rad]; rolling: d_i thetadot_i
/// + d_j thetadot_j over the sliding that it stops, difference: of the spins, over speed.
struct Meeting {
  char const* name;
  Real normal, obliquity, rolling, difference;
};
inline std::vector<Meeting> meetings() {
  return {{"head-on", 0.4, 0, 0, 0},    {"head-on, spinning", 2.1, 0, 0.8, 0.3},
          {"oblique", -1.3, 0.7, 0, 0}, {"oblique, spinning", 0.9, -0.9, -0.6, 0.5},
          {"rolling", 2.7, 0.8, 1, 0},  {"nearly grazing", -2.2, 1.45, 0, 0.2}};
}

template <class Law>
struct Scene {
  std::string name;
  TwoDisks<Law> disks;
};

/// Two disks that meet with a relative speed, of every class, both rules of mass, each meeting, in
/// the box and across its images.
template <class Law>
std::vector<Scene<Law>> scenes(Law const& law, Real speed) {
  std::vector<Scene<Law>> all;
  int number = 0;
  for (bool by_area : {false, true})
    for (Species a : {0, 1})
      for (Species b : {0, 1})
        for (auto const& meeting : meetings()) {
          Image const images[] = {{0, 0}, {1, 0}, {-1, 1}, {2, -1}, {0, -1}};
          Real const strain_rate = speed / 7, length = 5.5;
          Image const image = images[number % 5];
          TwoDisks<Law> two{law, by_area, a, b, {length, 1.7, strain_rate, 4.5}, image, {}, {}};
          ++number;
          auto const d = class_distance(pair_class(a, b));
          Real const angle = meeting.normal, toward = angle + meeting.obliquity;
          Vec2<Real> const separation{d * std::cos(angle), d * std::sin(angle)};
          Vec2<Real> const relative{-speed * std::cos(toward), -speed * std::sin(toward)};
          two.i.position = {2.3, 1.1};
          two.i.motion.velocity = {1.3 * speed, -0.6 * speed};
          two.j.position = two.i.position - separation - two.box.shift(image);
          two.j.motion.velocity = two.i.motion.velocity - relative;
          two.j.motion.velocity.x -= two.box.velocity_shift(image);
          if constexpr (Law::rotates) {
            Real const sliding = -speed * std::sin(meeting.obliquity);
            Real const rolling = meeting.obliquity == 0 ? speed : sliding;
            Real const spins = 2 * meeting.rolling * rolling;
            Real const d_i = a ? 1.4 : 1.0, d_j = b ? 1.4 : 1.0;
            two.i.motion.spin = (spins / 2 + meeting.difference * speed) / d_i;
            two.j.motion.spin = (spins / 2 - meeting.difference * speed) / d_j;
          }
          all.push_back({std::string(Law::name) + ", " + meeting.name + (by_area ? ", area" : "") +
                             ", species " + std::to_string(a) + std::to_string(b) + ", image " +
                             std::to_string(image.m) + std::to_string(image.n),
                         two});
        }
  return all;
}

}  // namespace bagnold::test
