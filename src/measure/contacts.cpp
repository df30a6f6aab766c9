// SPDX-License-Identifier: BSD-3-Clause
#include "src/measure/contacts.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "src/measure/contact_clusters.hpp"
#include "src/measure/contact_histograms.hpp"
#include "src/measure/contact_samples.hpp"
#include "src/measure/each_frame.hpp"

namespace bagnold {

namespace {

/// Velocities in contact of one system, with measure.correlations.
struct FoundVelocities {
  ContactSamples contacts;    ///< any contact in any evaluated configuration: weighted by duration
  ContactSamples collisions;  ///< each contact once
  ContactMotion motion;       ///< over all that `contacts` is a choice of, [d_s / tau_e]

  void add(FoundVelocities const& other) {
    contacts.add(other.contacts);
    collisions.add(other.collisions);
    motion += other.motion;
  }
};

/// Results on the contacts of one system.
struct FoundContacts final : ContactListener {
  ContactHistograms histograms;
  SampleChoice choice;
  std::optional<FoundVelocities> velocities;
  std::optional<ContactClusters> clusters;  ///< with measure.clusters

  explicit FoundContacts(double time_step) : histograms(time_step) {}
  void begins(ContactEvent const& event, std::size_t cluster) override {
    histograms.begins(event, cluster);
  }
  void ends(ContactEvent const& event, std::int64_t duration) override {
    histograms.ends(event, duration);
  }
  void sampled(OpenContact const& c) override {
    if (velocities) velocities->collisions.add({choice.rank(c.a, c.b, c.begin), c.velocities});
  }
  bool asks_for_clusters() const override { return clusters.has_value(); }
  void sampled_in_cluster(OpenContact const& c, std::int64_t duration,
                          std::size_t cluster) override {
    clusters->ends(c, duration, cluster);
  }
  void evaluated(ContactMotion const& motion) override {
    if (velocities) velocities->motion += motion;
  }
  void picked(ContactPick const& pick) override { velocities->contacts.add(pick); }
  Real limit() const override { return velocities ? velocities->contacts.limit() : 0; }
};

/// Sums in [d_s / tau_e] converted to sums over gammadot d_s.
ContactMotion over_rate(ContactMotion motion, double strain_rate) {
  using M = ContactMotion;
  for (int c = M::normal2; c <= M::rotational_normal; ++c)
    motion.value[c] /= strain_rate * strain_rate;
  for (int c : {M::tangential, M::rotational, M::normal}) motion.value[c] /= strain_rate;
  return motion;
}

class Contacts final : public FrameObserver {
 public:
  Contacts(Scene const& scene, double time_step, std::shared_ptr<ContactRecord> record,
           std::shared_ptr<FoundContacts> found)
      : strain_rate_(scene.shear.strain_rate),
        rotates_(scene.rotates()),
        has_target_(!scene.shear.target_error.empty()),
        time_step_(time_step),
        record_(std::move(record)),
        found_(std::move(found)) {}

  void add(Frame const&) override {}

  void save(ObserverState& numbers) override {
    auto& open = numbers["contacts_open"];
    for (auto const& c : record_->table.sorted())
      open.insert(open.end(), {static_cast<double>(c.a), static_cast<double>(c.b),
                               static_cast<double>(c.begin), c.binary ? 1.0 : 0.0});
    found_->histograms.save(numbers);
    if (!found_->velocities) return;
    auto& samples = numbers["contacts_samples"];
    for (auto const& c : record_->table.sorted())
      samples.insert(samples.end(), {due_number(c.due), c.velocities.tangential,
                                     c.velocities.rotational, c.velocities.normal});
    auto const& [contacts, collisions, motion] = *found_->velocities;
    numbers["contact_velocities"] = contacts.numbers();
    numbers["collision_velocities"] = collisions.numbers();
    numbers["contact_motion"].assign(std::begin(motion.value), std::end(motion.value));
    if (!found_->clusters) return;
    found_->clusters->save(numbers);
    auto& sampled = numbers["contacts_sampled_clusters"];
    for (auto const& c : record_->table.sorted()) sampled.push_back(c.cluster);
  }

  void load(ObserverState const& numbers) override {
    auto const& open = numbers.at("contacts_open");
    std::vector<OpenContact> contacts;
    for (std::size_t k = 0; k + 3 < open.size(); k += 4)
      contacts.push_back({static_cast<std::uint32_t>(open[k]),
                          static_cast<std::uint32_t>(open[k + 1]),
                          static_cast<std::int64_t>(open[k + 2]), open[k + 3] != 0});
    if (found_->velocities) {
      auto const& samples = numbers.at("contacts_samples");
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        contacts[k].due = due_step(samples.at(4 * k));
        contacts[k].velocities = {samples.at(4 * k + 1), samples.at(4 * k + 2),
                                  samples.at(4 * k + 3)};
      }
      auto& [chosen, collisions, motion] = *found_->velocities;
      chosen.restore(numbers.at("contact_velocities"));
      collisions.restore(numbers.at("collision_velocities"));
      std::ranges::copy(numbers.at("contact_motion"), motion.value);
    }
    if (found_->clusters) {
      found_->clusters->load(numbers);
      auto const& sampled = numbers.at("contacts_sampled_clusters");
      for (std::size_t k = 0; k < contacts.size(); ++k)
        contacts[k].cluster = static_cast<std::uint32_t>(sampled.at(k));
    }
    record_->restore(contacts);
    found_->histograms.load(numbers);
  }

  void forget_before(double /*strain*/) override {
    found_->histograms = ContactHistograms(time_step_);
    if (found_->velocities) found_->velocities.emplace();
    if (found_->clusters) found_->clusters.emplace();
  }

  void report(std::vector<FrameObserver const*> const& systems,
              FrameResults& results) const override {
    if (has_target_) return;
    ContactHistograms all(time_step_);
    auto velocities = found_->velocities;
    auto clusters = found_->clusters;
    for (auto const* system : systems) {
      auto const& other = *dynamic_cast<Contacts const&>(*system).found_;
      all.add(other.histograms);
      if (&other == found_.get()) continue;
      if (velocities) velocities->add(*other.velocities);
      if (clusters) clusters->add(*other.clusters);
    }
    for (auto& histogram : all.histograms()) results.histograms.push_back(std::move(histogram));
    if (clusters) {
      results.histograms.push_back(clusters->at_end());
      for (auto& table : clusters->tables(rotates_)) results.samples.push_back(std::move(table));
    }
    if (!velocities) return;
    auto const tell = [&](VelocityTables const& tables, ContactSamples const& samples,
                          ContactMotion const& sums) {
      for (auto& one : tables(samples.velocities(), sums))
        results.samples.push_back(std::move(one));
    };
    auto const& [contacts, collisions, motion] = *velocities;
    tell({"contact_velocities",
          "relative velocities over gammadot d_s (P2 Eqs. 30-34), each of a contact in an "
          "evaluated configuration; means, covariance and axes are over all of these",
          rotates_},
         contacts, over_rate(motion, strain_rate_));
    tell({"collision_velocities",
          "likewise, each of one collision at a random step of it: long ones count as short ones",
          rotates_},
         collisions, sums_of(collisions.velocities()));
  }

 private:
  // Step number as a double; -1 for a contact that is never sampled.
  static double due_number(std::int64_t due) {
    return due == SampleChoice::never ? -1.0 : static_cast<double>(due);
  }
  static std::int64_t due_step(double number) {
    return number < 0 ? SampleChoice::never : static_cast<std::int64_t>(number);
  }

  double strain_rate_;
  bool rotates_;
  bool has_target_;  ///< where the run ends is not known, so not where histograms would begin
  double time_step_;
  std::shared_ptr<ContactRecord> record_;
  std::shared_ptr<FoundContacts> found_;
};

}  // namespace

std::shared_ptr<ContactRecord> watch_contacts(Scene const& scene, Plan const& plan, int columns,
                                              std::int64_t seed, Frames& frames) {
  auto const found = std::make_shared<FoundContacts>(plan.time_step);
  SampleChoice choice;
  if (scene.measure.correlations) {
    choice = SampleChoice(seed);
    found->choice = choice;
    found->velocities.emplace();
    if (scene.measure.clusters) found->clusters.emplace();
  }
  auto const record = std::make_shared<ContactRecord>(static_cast<std::size_t>(scene.disks.count),
                                                      columns, plan.first_step(), found, choice);
  frames.know_contacts(record);
  auto contacts = std::make_unique<Contacts>(scene, plan.time_step, record, found);
  constexpr auto never = std::int64_t{1} << 60;
  if (plan.ramp)
    frames.add_observer(std::make_unique<EachFrame>("contacts", std::move(contacts), plan),
                        plan.frame_steps, plan.first_step());
  else
    frames.add_observer(std::move(contacts), never, never);
  return record;
}

}  // namespace bagnold
