// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/shipped_inputs.hpp"

namespace bagnold {
namespace fs = std::filesystem;

std::optional<fs::path> find_shipped_input(fs::path const& name) {
  std::error_code ignored;
  auto const program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (auto const& folder :
       {fs::path("inputs"), program / "../../inputs", program / "../share/bagnold"})
    if (auto const file = folder / name; fs::exists(file, ignored)) return file.lexically_normal();
  return std::nullopt;
}

}  // namespace bagnold
