// SPDX-License-Identifier: BSD-3-Clause
#include "src/simulation/contact_record.hpp"

#include <algorithm>

namespace bagnold {

void ContactRecord::add(std::vector<ContactEvent>& events, Sampling const& sampling,
                        OpenWindows& windows) {
  std::sort(events.begin(), events.end());
  for (auto event = events.cbegin(); event != events.cend();) {
    auto const step = event->step;
    auto const window = sampling.window(step);
    for (; event != events.cend() && event->step == step && !event->begins; ++event)
      end(*event, window, windows);
    auto const begun = event;
    for (; event != events.cend() && event->step == step; ++event)
      table.open(event->a, event->b, step);
    if (step == 0 || begun == event) continue;
    add(ContactColumns::begun, static_cast<double>(event - begun), window, windows);
    tell_begun(begun, event);
  }
  events.clear();
}

void ContactRecord::end(ContactEvent const& event, std::int64_t window, OpenWindows& windows) {
  auto const contact = table.close(event.a, event.b);
  if (contact.begin == 0) return;
  auto const duration = event.step - contact.begin;
  add(ContactColumns::ended, 1, window, windows);
  add(ContactColumns::duration, static_cast<double>(duration), window, windows);
  if (contact.binary) add(ContactColumns::binary, 1, window, windows);
  if (listener_ && event.step >= first_step_) listener_->ends(event, duration);
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

void ContactRecord::looked(std::int64_t begin, std::int64_t end, Sampling const& sampling,
                           OpenWindows& windows) const {
  while (begin < end) {
    auto const window = sampling.window(begin);
    auto const next = std::min(end, (window + 1) * sampling.window_steps);
    add(ContactColumns::steps, static_cast<double>(next - begin), window, windows);
    begin = next;
  }
}

void ContactRecord::add(ContactMotion const& motion, std::int64_t window,
                        OpenWindows& windows) const {
  add(ContactColumns::normal2, motion.normal2, window, windows);
  add(ContactColumns::tangential2, motion.tangential2, window, windows);
}

}  // namespace bagnold
