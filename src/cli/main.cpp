// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "src/cli/commands.hpp"
#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/cli/signals.hpp"
#include "src/cli/standard_streams.hpp"
#include "src/config/errors.hpp"
#include "src/config/nearest_word.hpp"
#include "src/config/shown.hpp"
#include "src/run/provenance.hpp"

namespace {

/// Large arrays go back to the system as soon as they are freed: what comes after them needs the
/// room.
void give_back_large_arrays() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 8 << 20);  // small ones need not: they are wanted again
#endif
}

/// The words of the command line; `help COMMAND` becomes `COMMAND --help`.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  return words;
}

/// CLI11 would complain of the words behind it.
void refuse_unknown_command(std::vector<std::string> const& names,
                            std::vector<std::string> const& words) {
  if (words.empty() || words.front().starts_with("-")) return;
  if (std::ranges::count(names, words.front()) == 0)
    throw bagnold::InputError(fmt::format("unknown command {}; did you mean {}? See bagnold --help",
                                          bagnold::shown(words.front()),
                                          bagnold::nearest_word(words.front(), names)));
}

int run(int argc, char** argv) {
  bagnold::CommandLine line("Bagnold: dense granular flow of soft disks at vanishing shear rate");
  line.words().footer(bagnold::units_and_exit_codes);
  line.require_command([] {
    auto const made = bagnold::provenance();
    return fmt::format("bagnold {} ({})", made.version, made.git);
  });

  std::vector<bagnold::Command> commands;
  for (auto* add : bagnold::all_commands) commands.push_back(add(line.words()));

  auto const words = words_of(argc, argv);
  refuse_unknown_command(line.commands(), words);
  try {
    if (!line.parse(words)) return bagnold::done;
  } catch (bagnold::UnreadableWords const& error) {
    throw bagnold::InputError(fmt::format("{}; see bagnold --help", error.what()));
  }
  auto const wanted = std::ranges::find_if(
      commands, [](bagnold::Command const& command) { return command.words.given(); });
  return wanted->run();
}

}  // namespace

int main(int argc, char** argv) {
  bagnold::catch_checkpoint_signal();
  bagnold::open_standard_streams();
  give_back_large_arrays();
  int code = bagnold::internal_error;
  try {
    code = run(argc, argv);
  } catch (...) {
    code = bagnold::exit_code_of(std::current_exception());
  }
  auto const unwritten = bagnold::finish_output();
  if (code != bagnold::done || unwritten.empty()) return code;
  bagnold::say(unwritten);
  return bagnold::file_failure;
}
