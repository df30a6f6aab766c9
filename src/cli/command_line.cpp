// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

#include "src/config/nearest_word.hpp"
#include "src/config/shown.hpp"

namespace bagnold {

Word& Word::required() {
  option_->required();
  return *this;
}

Word& Word::between(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Word& Word::between(double least, double most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Word& Word::one_of(std::initializer_list<char const*> names) {
  option_->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
  return *this;
}

Word& Word::not_empty() {
  option_->check(
      [](std::string const& text) { return std::string(text.empty() ? "is empty" : ""); });
  return *this;
}

Word& Word::values(int count) {
  option_->expected(count);
  return *this;
}

Word& Word::one_value_each() {
  option_->allow_extra_args(false);
  return *this;
}

Word& Word::excludes(Word const& other) {
  option_->excludes(other.option_);
  return *this;
}

Words Words::command(char const* name, char const* description) {
  return Words(*app_->add_subcommand(name, description));
}

template <class T>
Word Words::option(char const* name, T& value, char const* description) {
  return Word(*app_->add_option(name, value, description));
}

template Word Words::option(char const*, std::string&, char const*);
template Word Words::option(char const*, std::filesystem::path&, char const*);
template Word Words::option(char const*, int&, char const*);
template Word Words::option(char const*, std::int64_t&, char const*);
template Word Words::option(char const*, std::uint32_t&, char const*);
template Word Words::option(char const*, std::uint64_t&, char const*);
template Word Words::option(char const*, double&, char const*);
template Word Words::option(char const*, std::vector<std::string>&, char const*);
template Word Words::option(char const*, std::vector<double>&, char const*);
template Word Words::option(char const*, std::optional<double>&, char const*);
template Word Words::option(char const*, std::optional<std::pair<double, double>>&, char const*);

Word Words::option(char const* name, std::function<void(std::vector<std::string> const&)> read,
                   char const* description) {
  return Word(*app_->add_option_function(name, std::move(read), description));
}

Word Words::flag(char const* name, bool& value, char const* description) {
  return Word(*app_->add_flag(name, value, description));
}

void Words::footer(std::string const& text) { app_->footer(text); }

bool Words::given() const { return app_->parsed(); }

CommandLine::CommandLine(char const* description)
    : app_(std::make_unique<CLI::App>(description, "bagnold")) {}

CommandLine::~CommandLine() = default;

Words CommandLine::words() { return Words(*app_); }

void CommandLine::require_command(std::function<std::string()> version) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", std::move(version));
}

std::vector<std::string> CommandLine::commands() const {
  std::vector<std::string> names;
  for (auto const* command : std::as_const(*app_).get_subcommands({}))
    names.push_back(command->get_name());
  return names;
}

namespace {

/// The first word that is no option of the command that was given, and the option most like it.
std::string wrong_option(CLI::App& app, std::vector<std::string> const& words) {
  auto const given = app.get_subcommands();
  auto const& command = given.empty() ? app : *given.front();
  std::vector<std::string> known;
  for (auto const* option : command.get_options())
    for (auto const& name : option->get_lnames()) known.push_back("--" + name);
  for (auto const& word : words) {
    auto const name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::ranges::count(known, name) > 0) continue;
    return fmt::format("unknown option {} (did you mean {}?)", shown(name),
                       nearest_word(name, known));
  }
  return {};
}

}  // namespace

bool CommandLine::parse(std::vector<std::string> const& words) {
  try {
    app_->parse(std::vector(words.rbegin(), words.rend()));  // the first one last
  } catch (CLI::ExtrasError const& error) {
    auto const wrong = wrong_option(*app_, words);
    throw UnreadableWords(wrong.empty() ? error.what() : wrong);
  } catch (CLI::ParseError const& error) {
    if (error.get_exit_code() != 0) throw UnreadableWords(error.what());
    app_->exit(error);
    return false;
  }
  return true;
}

void CommandLine::parse_line(std::string const& line) {
  try {
    app_->parse(line);
  } catch (CLI::ParseError const& error) {
    throw UnreadableWords(error.what());
  }
}

}  // namespace bagnold
