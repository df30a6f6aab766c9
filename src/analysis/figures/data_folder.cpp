// SPDX-License-Identifier: BSD-3-Clause
#include "src/analysis/figures/data_folder.hpp"

#include <fmt/format.h>

#include <vector>

#include "src/config/errors.hpp"
#include "src/run/messages.hpp"

namespace bagnold::analysis {

void check_tables(Figure const& figure, DataFolder const& data) {
  std::vector<std::string> missing;
  for (auto const& name : figure.data)
    if (!std::filesystem::exists(data.measured(name)) &&
        !std::filesystem::exists(data.pictured(name)))
      missing.push_back(data.measured(name).filename().string());
  if (missing.empty()) return;
  auto const said =
      fmt::format("{}: {} not in {}", figure.name, fmt::join(missing, ", "), data.folder.string());
  if (missing.size() == figure.data.size())
    throw InputError(said + "; without --data its sweeps are run");
  warn(said + ": drawn without");
}

}  // namespace bagnold::analysis
