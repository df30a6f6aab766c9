// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contact_histograms.hpp"

#include <cmath>

namespace bagnold {

namespace {

constexpr double first_angle = -181.8;  // so that 0 and +-90 are centres of bins

double wrapped(double theta) { return theta >= first_angle + 360 ? theta - 360 : theta; }

std::vector<double> angles() { return even_edges(first_angle, first_angle + 360, 100); }

/// Edges of durations, twenty bins a decade.
std::vector<double> durations() {
  std::vector<double> edges;
  for (double const power : even_edges(-2, 8, 200)) edges.push_back(std::pow(10.0, power));
  return edges;
}

}  // namespace

std::vector<double> cluster_edges() {
  constexpr auto most = ContactRecord::largest_cluster;
  return even_edges(1.5, static_cast<double>(most) + 0.5, most - 1);
}

ContactHistograms::ContactHistograms(double time_step)
    : time_step_(time_step),
      theta_begin_(angles()),
      theta_end_(angles()),
      duration_(durations()),
      cluster_(cluster_edges()) {}

void ContactHistograms::begins(ContactEvent const& event, std::size_t cluster) {
  theta_begin_.add(wrapped(event.theta));
  cluster_.add(static_cast<double>(cluster));
}

void ContactHistograms::ends(ContactEvent const& event, std::int64_t duration) {
  theta_end_.add(wrapped(event.theta));
  duration_.add(time_step_ * static_cast<double>(duration));
}

void ContactHistograms::save(ObserverState& numbers) const {
  numbers["contacts_theta_begin"] = theta_begin_.numbers();
  numbers["contacts_theta_end"] = theta_end_.numbers();
  numbers["contacts_duration"] = duration_.numbers();
  numbers["contacts_cluster"] = cluster_.numbers();
}

void ContactHistograms::load(ObserverState const& numbers) {
  theta_begin_.restore(numbers.at("contacts_theta_begin"));
  theta_end_.restore(numbers.at("contacts_theta_end"));
  duration_.restore(numbers.at("contacts_duration"));
  cluster_.restore(numbers.at("contacts_cluster"));
}

void ContactHistograms::add(ContactHistograms const& other) {
  theta_begin_.add(other.theta_begin_);
  theta_end_.add(other.theta_end_);
  duration_.add(other.duration_);
  cluster_.add(other.cluster_);
}

std::vector<statistics::Histogram> ContactHistograms::histograms() const {
  Counts theta = theta_begin_;
  theta.add(theta_end_);
  return {theta.histogram("theta", "degrees",
                          "collision angle of P2 Eq. 27, at begins and ends of contacts"),
          theta_begin_.histogram("theta_begin", "degrees", "at the first step in contact"),
          theta_end_.histogram("theta_end", "degrees", "at the first step out of contact"),
          duration_.histogram("tau_dur", "tau_e", "whole durations of contacts that ended"),
          cluster_.histogram("cluster_disks", "1",
                             "disks in the connected cluster in which a contact begins; the last "
                             "bin: that many or more")};
}

}  // namespace bagnold
