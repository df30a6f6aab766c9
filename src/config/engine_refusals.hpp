// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/config/laws.hpp"
#include "src/config/refusal.hpp"
#include "src/config/scene.hpp"

namespace bagnold {

/// Keys of a scene that an engine, asked for by name, cannot satisfy.
class EngineRefusals {
 public:
  explicit EngineRefusals(std::string_view engine) : engine_(engine) {}

  /// "integration.engine = "..." (why); remedy"
  static std::string because(std::string_view engine, std::string const& why,
                             std::string const& remedy) {
    return fmt::format("integration.engine = \"{}\" ({}); {}", engine, why, remedy);
  }

  void operator()(std::vector<std::string_view> keys, std::string const& why,
                  std::string const& remedy) {
    keys.emplace_back("integration.engine");
    list_.push_back({std::move(keys), because(engine_, why, remedy)});
  }

  /// True if the law of the scene is linear in the velocity. Refuses disks.model otherwise.
  bool unless_linear(Scene const& scene, std::string const& remedy) {
    auto const* law = known_laws().find(scene.disks.model);
    if (!law) return true;  // refused by its name
    auto const constants = law->constants(scene.disks);
    if (constants.normal > 0 || constants.tangential > 0) return true;
    (*this)({"disks.model"},
            fmt::format("needs damping that is linear in the velocity, which model \"{}\" has not",
                        scene.disks.model),
            remedy);
    return false;
  }

  std::vector<Refusal> take() { return std::move(list_); }

 private:
  std::string_view engine_;
  std::vector<Refusal> list_;
};

}  // namespace bagnold
