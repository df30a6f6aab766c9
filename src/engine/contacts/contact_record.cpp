// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/contacts/contact_record.hpp"

#include <algorithm>
#include <tuple>

namespace bagnold {

void ContactRecord::add(std::vector<ContactEvent>& events, Sampling const& sampling,
                        OpenWindows& windows) {
  std::vector<ContactSample> none;
  add(events, none, sampling, windows);
}

void ContactRecord::add(std::vector<ContactEvent>& events, std::vector<ContactSample>& samples,
                        Sampling const& sampling, OpenWindows& windows) {
  std::sort(events.begin(), events.end());
  std::ranges::sort(samples, {}, [](auto const& s) { return std::tuple(s.step, s.a, s.b); });
  auto sample = samples.cbegin();
  for (auto event = events.cbegin(); event != events.cend();) {
    auto const step = event->step;
    for (; sample != samples.cend() && sample->step < step; ++sample) add(*sample);
    auto const window = sampling.window(step);
    auto const ended = event;
    while (event != events.cend() && event->step == step && !event->begins) ++event;
    auto const clusters = clusters_of(ended, event);
    for (auto one = ended; one != event; ++one)
      end(*one, clusters.empty() ? 0 : clusters[static_cast<std::size_t>(one - ended)], window,
          windows);
    auto const begun = event;
    for (; event != events.cend() && event->step == step; ++event) open(*event);
    if (step == 0 || begun == event) continue;
    add(ContactColumns::begun, static_cast<double>(event - begun), window, windows);
    tell_begun(begun, event);
  }
  for (; sample != samples.cend(); ++sample) add(*sample);
  events.clear();
  samples.clear();
}

void ContactRecord::open(ContactEvent const& event) {
  // No step is chosen for a contact of the first configuration: its beginning is unknown.
  auto const due = event.step == 0 ? SampleChoice::never : choice.first(event.step);
  table.open(event.a, event.b, event.step, due);
  if (due != SampleChoice::never) due_[due].push_back({event.a, event.b});
}

void ContactRecord::add(ContactSample const& sample) {
  auto* const contact = table.find(sample.a, sample.b);
  contact->velocities = sample.velocities;
  if (counts_clusters())
    contact->cluster = static_cast<std::uint32_t>(table.cluster(sample.a, largest_cluster));
  contact->due = choice.next(sample.a, sample.b, contact->begin, sample.step);
  due_[contact->due].push_back({sample.a, sample.b});
}

std::vector<OpenContact> ContactRecord::due(std::int64_t step) const {
  std::vector<OpenContact> found;
  auto const here = due_.find(step);
  if (here == due_.end()) return found;
  for (auto const& [a, b] : here->second)
    if (auto const* const contact = table.find(a, b); contact != nullptr && contact->due == step)
      found.push_back(*contact);
  return found;
}

void ContactRecord::restore(std::vector<OpenContact> const& contacts) {
  table.restore(contacts);
  due_.clear();
  for (auto const& contact : contacts)
    if (contact.due != SampleChoice::never) due_[contact.due].push_back({contact.a, contact.b});
}

/// Disks of the clusters of contacts that end in one configuration, in the one before it; empty
/// where nobody asks for them.
std::vector<std::size_t> ContactRecord::clusters_of(Events first, Events last) const {
  std::vector<std::size_t> disks;
  if (first == last || !counts_clusters() || first->step < first_step_) return disks;
  for (; first != last; ++first) disks.push_back(table.cluster(first->a, largest_cluster));
  return disks;
}

void ContactRecord::end(ContactEvent const& event, std::size_t cluster, std::int64_t window,
                        OpenWindows& windows) {
  auto const contact = table.close(event.a, event.b);
  if (contact.begin == 0) return;
  auto const duration = event.step - contact.begin;
  add(ContactColumns::ended, 1, window, windows);
  add(ContactColumns::duration, static_cast<double>(duration), window, windows);
  if (contact.binary) add(ContactColumns::binary, 1, window, windows);
  if (!listener_ || event.step < first_step_) return;
  listener_->ends(event, duration);
  if (contact.due == SampleChoice::never) return;
  listener_->sampled(contact);
  if (cluster > 0) listener_->sampled_in_cluster(contact, duration, cluster);
}

void ContactRecord::tell_begun(Events first, Events last) const {
  if (!listener_ || first->step < first_step_) return;
  for (; first != last; ++first)
    listener_->begins(*first, table.cluster(first->a, largest_cluster));
}

void ContactRecord::add(int column, double value, std::int64_t window, OpenWindows& windows) const {
  auto& sums = windows.of(window).sums;
  auto const size = first_column_ + ContactColumns::count;
  if (sums.size() < size) sums.resize(size);
  sums[first_column_ + static_cast<std::size_t>(column)] += value;
}

void ContactRecord::evaluated(std::int64_t begin, std::int64_t end, Sampling const& sampling,
                              OpenWindows& windows) {
  due_.erase(due_.begin(), due_.lower_bound(end));
  while (begin < end) {
    auto const window = sampling.window(begin);
    auto const next = std::min(end, (window + 1) * sampling.window_steps);
    add(ContactColumns::steps, static_cast<double>(next - begin), window, windows);
    begin = next;
  }
}

void ContactRecord::add(ContactMotion const& motion, std::int64_t step, Sampling const& sampling,
                        OpenWindows& windows) const {
  for (int c = 0; c < ContactMotion::count; ++c)
    add(ContactColumns::motion + c, motion.value[c], sampling.window(step), windows);
  if (listener_ && step >= first_step_) listener_->evaluated(motion);
}

ContactPicker ContactRecord::picker() const {
  return {{choice, first_step_, listener_ ? listener_->limit() : 0}};
}

void ContactRecord::add(std::vector<ContactPick>& picks) const {
  for (auto const& pick : picks) listener_->picked(pick);
  picks.clear();
}

}  // namespace bagnold
