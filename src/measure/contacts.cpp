// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contacts.hpp"

#include "src/measure/contact_histograms.hpp"

namespace bagnold {

namespace {

class Contacts final : public FrameObserver {
 public:
  Contacts(double time_step, std::shared_ptr<ContactRecord> record,
           std::shared_ptr<ContactHistograms> histograms)
      : time_step_(time_step), record_(std::move(record)), histograms_(std::move(histograms)) {}

  void add(Frame const&) override {}

  void save(Numbers& numbers) override {
    auto& open = numbers["contacts_open"];
    for (auto const& c : record_->table.sorted())
      open.insert(open.end(), {static_cast<double>(c.a), static_cast<double>(c.b),
                               static_cast<double>(c.begin), c.binary ? 1.0 : 0.0});
    histograms_->save(numbers);
  }

  void load(Numbers const& numbers) override {
    auto const& open = numbers.at("contacts_open");
    std::vector<OpenContact> contacts;
    for (std::size_t k = 0; k + 3 < open.size(); k += 4)
      contacts.push_back({static_cast<std::uint32_t>(open[k]),
                          static_cast<std::uint32_t>(open[k + 1]),
                          static_cast<std::int64_t>(open[k + 2]), open[k + 3] != 0});
    record_->table.restore(contacts);
    histograms_->load(numbers);
  }

  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override {
    ContactHistograms all(time_step_);
    for (auto const* system : systems) all.add(*dynamic_cast<Contacts const&>(*system).histograms_);
    for (auto& histogram : all.histograms()) results.histograms.push_back(std::move(histogram));
  }

 private:
  double time_step_;
  std::shared_ptr<ContactRecord> record_;
  std::shared_ptr<ContactHistograms> histograms_;
};

}  // namespace

std::shared_ptr<ContactRecord> watch_contacts(Scene const& scene, Plan const& plan, int columns,
                                              Frames& frames) {
  auto const histograms = std::make_shared<ContactHistograms>(plan.time_step);
  auto const record =
      std::make_shared<ContactRecord>(static_cast<std::size_t>(scene.disks.count), columns,
                                      plan.discarded_windows * plan.window_steps, histograms);
  constexpr auto never = std::int64_t{1} << 60;
  frames.watch(std::make_unique<Contacts>(plan.time_step, record, histograms), never, never);
  return record;
}

}  // namespace bagnold
