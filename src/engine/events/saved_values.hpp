// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "src/config/errors.hpp"

/// How a checkpoint holds paths, contacts and clusters: as numbers in one order, in which they are
/// written and read.
namespace bagnold::events {

/// Numbers one after the other, written or read in one order.
struct Write {
  std::vector<double>& to;

  template <class Value>
  void operator()(Value const& value) {
    to.push_back(static_cast<double>(value));
  }
};

struct Read {
  std::vector<double> const& from;
  std::size_t next = 0;

  bool done() const { return next == from.size(); }
  double take() {
    if (done()) throw InputError("the checkpoint lacks events: it is damaged");
    return from[next++];
  }
  template <class Value>
  void operator()(Value& value) {
    value = static_cast<Value>(take());
  }
};

template <class Visit, class Vector>
void visit_vector(Visit& visit, Vector& v) {
  visit(v.x);
  visit(v.y);
}

template <bool Rotates, class Visit, class Moving>
void visit_moving(Visit& visit, Moving& of) {
  visit_vector(visit, of.position);
  visit_vector(visit, of.motion.velocity);
  if constexpr (Rotates) visit(of.motion.spin);
}

template <class Visit, class P>
void visit_path(Visit& visit, P& path) {
  visit_vector(visit, path.place);
  visit_vector(visit, path.velocity);
  visit(path.begun);
  visit(path.straight);
  visit(path.deviation);
}

template <bool Rotates, class Visit, class Contact>
void visit_contact(Visit& visit, Contact& contact) {
  visit(contact.i);
  visit(contact.other.packed);
  visit(contact.fresh);
  visit(contact.binary);
  visit(contact.begun);
  visit(contact.touched);
  visit_vector(visit, contact.start.separation);
  visit_vector(visit, contact.start.velocity);
  if constexpr (Rotates) {
    visit(contact.start.spin_i);
    visit(contact.start.spin_j);
  }
  visit_vector(visit, contact.centre.position);
  visit_vector(visit, contact.centre.velocity);
}

template <class Visit, class L>
void visit_link(Visit& visit, L& link) {
  visit(link.a);
  visit(link.b);
  visit(link.other.packed);
  visit(link.touched);
}

}  // namespace bagnold::events
