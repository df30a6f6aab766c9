// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "src/cli/options.hpp"
#include "src/config/names.hpp"

namespace bagnold {

namespace {

int models_command() {
  for (auto const name : model_names()) fmt::print("{}\n", name);
  return 0;
}

}  // namespace

Command add_models(Words program) {
  return {add_command(program, "models", "names of the contact laws"), models_command};
}

}  // namespace bagnold
