// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
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

/// Makes malloc return large arrays to the system as soon as they are freed: later ones need the
/// memory.
void give_back_large_arrays() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 8 << 20);  // small ones need not: they are wanted again
#endif
}

/// Names this program to the Python package that it calls, which asks it for the status of a run.
void name_this_program() {
  std::error_code unknown;
  auto const program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (std::filesystem::exists(program, unknown))
    setenv("BAGNOLD_PROGRAM", program.c_str(), /*overwrite=*/1);
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

/// Commands by the names that other programs give them.
struct Elsewhere {
  char const* command;
  std::vector<std::string_view> words;
};
Elsewhere const elsewhere[] = {
    {"run", {"start", "simulate", "execute", "exec", "go"}},
    {"validate", {"check", "test", "dry-run", "lint", "verify"}},
    {"resume", {"continue", "restart", "extend", "rerun"}},
    {"status", {"list", "ls", "ps", "top", "progress", "show", "queue"}},
    {"plot", {"draw", "view", "picture", "graph"}},
    {"analyse", {"fit", "find"}},
    {"sweep", {"scan", "batch", "array", "collect", "submit"}},
    {"export", {"convert", "write", "dump"}},
    {"import", {"read", "load"}},
    {"init", {"new", "create", "template", "example"}},
    {"units", {"si", "convert-units", "grains"}},
    {"info", {"about", "config", "machine"}},
    {"--version", {"version"}},
};

/// Refuses an unknown command. CLI11 would complain of the words behind it.
void refuse_unknown_command(std::vector<std::string> const& names,
                            std::vector<std::string> const& words) {
  if (words.empty() || words.front().starts_with("-")) return;
  auto const& word = words.front();
  if (std::ranges::count(names, word) > 0) return;
  auto const found = std::ranges::find_if(elsewhere, [&](auto const& one) {
    return std::ranges::count(one.words, std::string_view(word)) > 0;
  });
  auto const hint = found == std::end(elsewhere)
                        ? bagnold::did_you_mean(word, names, ".")
                        : fmt::format("; did you mean {}?", found->command);
  throw bagnold::InputError(
      fmt::format("unknown command {}{} See bagnold --help", bagnold::shown(word), hint));
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
  name_this_program();
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
