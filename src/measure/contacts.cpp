// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contacts.hpp"

#include <optional>

#include "src/measure/contact_histograms.hpp"
#include "src/measure/contact_samples.hpp"

namespace bagnold {

namespace {

/// What is found of the contacts of one system.
struct Found final : ContactListener {
  ContactHistograms histograms;
  std::optional<ContactSamples> samples;  ///< with measure.correlations

  explicit Found(double time_step) : histograms(time_step) {}
  void begins(ContactEvent const& event, std::size_t cluster) override {
    histograms.begins(event, cluster);
  }
  void ends(ContactEvent const& event, std::int64_t duration) override {
    histograms.ends(event, duration);
  }
  void sampled(OpenContact const& contact) override {
    if (samples) samples->add(contact);
  }
};

class Contacts final : public FrameObserver {
 public:
  Contacts(double time_step, std::shared_ptr<ContactRecord> record, std::shared_ptr<Found> found)
      : time_step_(time_step), record_(std::move(record)), found_(std::move(found)) {}

  void add(Frame const&) override {}

  void save(Numbers& numbers) override {
    auto& open = numbers["contacts_open"];
    for (auto const& c : record_->table.sorted())
      open.insert(open.end(), {static_cast<double>(c.a), static_cast<double>(c.b),
                               static_cast<double>(c.begin), c.binary ? 1.0 : 0.0});
    found_->histograms.save(numbers);
    if (!found_->samples) return;
    auto& looks = numbers["contacts_looks"];
    for (auto const& c : record_->table.sorted())
      looks.insert(looks.end(), {due_number(c.due), c.velocities.tangential,
                                 c.velocities.rotational, c.velocities.normal});
    found_->samples->save(numbers);
  }

  void load(Numbers const& numbers) override {
    auto const& open = numbers.at("contacts_open");
    std::vector<OpenContact> contacts;
    for (std::size_t k = 0; k + 3 < open.size(); k += 4)
      contacts.push_back({static_cast<std::uint32_t>(open[k]),
                          static_cast<std::uint32_t>(open[k + 1]),
                          static_cast<std::int64_t>(open[k + 2]), open[k + 3] != 0});
    if (found_->samples) {
      auto const& looks = numbers.at("contacts_looks");
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        contacts[k].due = due_step(looks.at(4 * k));
        contacts[k].velocities = {looks.at(4 * k + 1), looks.at(4 * k + 2), looks.at(4 * k + 3)};
      }
      found_->samples->load(numbers);
    }
    record_->restore(contacts);
    found_->histograms.load(numbers);
  }

  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override {
    ContactHistograms all(time_step_);
    auto samples = found_->samples;
    for (auto const* system : systems) {
      auto const& other = *dynamic_cast<Contacts const&>(*system).found_;
      all.add(other.histograms);
      if (samples && &other != found_.get()) samples->add(*other.samples);
    }
    for (auto& histogram : all.histograms()) results.histograms.push_back(std::move(histogram));
    if (!samples) return;
    for (auto& table : samples->samples()) results.samples.push_back(std::move(table));
  }

 private:
  // Steps that a double holds; -1 for a contact that is never looked at.
  static double due_number(std::int64_t due) {
    return due == SampleChoice::never ? -1.0 : static_cast<double>(due);
  }
  static std::int64_t due_step(double number) {
    return number < 0 ? SampleChoice::never : static_cast<std::int64_t>(number);
  }

  double time_step_;
  std::shared_ptr<ContactRecord> record_;
  std::shared_ptr<Found> found_;
};

}  // namespace

std::shared_ptr<ContactRecord> watch_contacts(Scene const& scene, Plan const& plan, int columns,
                                              std::int64_t seed, Frames& frames) {
  auto const found = std::make_shared<Found>(plan.time_step);
  SampleChoice choice;
  if (scene.measure.correlations) {
    choice = SampleChoice(seed);
    found->samples.emplace(choice, scene.rotates());
  }
  auto const record =
      std::make_shared<ContactRecord>(static_cast<std::size_t>(scene.disks.count), columns,
                                      plan.discarded_windows * plan.window_steps, found, choice);
  constexpr auto never = std::int64_t{1} << 60;
  frames.watch(std::make_unique<Contacts>(plan.time_step, record, found), never, never);
  return record;
}

}  // namespace bagnold
