// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/law_engines.hpp"

#include "kernels/physics/laws/laws.hpp"
#include "kernels/physics/named_entries.hpp"

namespace bagnold {

namespace {

NamedEntries<LawEngines>& engines() {
  return NamedEntries<LawEngines>::of<Laws>([]<class Law>() { return engines_of<Law>(); });
}

}  // namespace

LawEngines const& engines_for(std::string_view model) { return *engines().find(model); }

void register_engines(LawEngines const& added) { engines().add(added); }

}  // namespace bagnold
