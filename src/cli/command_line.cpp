// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>

#include "src/config/meant_key.hpp"
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

Word& Word::needs(Word const& other) {
  option_->needs(other.option_);
  return *this;
}

Words Words::command(char const* name, char const* description) {
  return Words(*app_->add_subcommand(name, description));
}

namespace {

/// "-007" as "-7", to base ten; nothing where it is no integer of this type. CLI11 would read a
/// leading zero as octal, and an empty word as 0.
template <class T>
std::optional<std::string> decimal_digits(std::string const& text) {
  T value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return fmt::format("{}", value);
}

constexpr char const* is_empty = "is empty (must be a value); give one, or leave it out";

template <class T>
CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            if (text.empty()) return is_empty;
            auto const decimal = decimal_digits<T>(text);
            if (!decimal)
              return fmt::format("{} (must be a whole number in decimal digits)", shown(text));
            text = *decimal;
            return {};
          },
          ""};
}

/// Validator of decimal numbers with a fraction. strtod() would read "0x10" as 16.
CLI::Validator decimal_number() {
  return {[](std::string& text) -> std::string {
            double value = 0;
            auto const* begin = text.data() + (text.starts_with('+') ? 1 : 0);
            auto const* const last = text.data() + text.size();
            auto const [end, error] = std::from_chars(begin, last, value);
            bool const read =
                end == last && error != std::errc::invalid_argument && !std::isnan(value);
            return read ? std::string() : fmt::format("{} (must be a decimal number)", shown(text));
          },
          ""};
}

template <class T>
constexpr bool holds_doubles = false;
template <>
constexpr bool holds_doubles<double> = true;
template <>
constexpr bool holds_doubles<std::vector<double>> = true;
template <>
constexpr bool holds_doubles<std::optional<double>> = true;
template <>
constexpr bool holds_doubles<std::optional<std::pair<double, double>>> = true;

/// Refuses an empty word: it comes from a shell variable that is not set.
CLI::Option& with_words(CLI::Option& option) {
  option.check([](std::string const& text) { return std::string(text.empty() ? is_empty : ""); });
  return option;
}

}  // namespace

template <class T>
Word Words::option(char const* name, T& value, char const* description) {
  auto& option = with_words(*app_->add_option(name, value, description));
  if constexpr (std::is_integral_v<T>)
    option.transform(whole_number<T>());
  else if constexpr (std::is_same_v<T, std::optional<std::int64_t>>)
    option.transform(whole_number<std::int64_t>());
  else if constexpr (holds_doubles<T>)
    option.check(decimal_number());
  return Word(option);
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
template Word Words::option(char const*, std::optional<std::int64_t>&, char const*);
template Word Words::option(char const*, std::optional<std::pair<double, double>>&, char const*);

Word Words::option(char const* name, std::function<void(std::vector<std::string> const&)> read,
                   char const* description) {
  return Word(with_words(*app_->add_option_function(name, std::move(read), description)));
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

/// Suggestion for an unknown option: another option, or a key of the scene.
std::string hint_of_option(CLI::App const& command, std::string const& name,
                           std::vector<std::string> const& known) {
  if (auto const near = did_you_mean(name, known); !near.empty())
    return fmt::format(" ({})", near.substr(2));
  bool const sets = std::ranges::count(known, "--set") > 0;
  if (!sets && command.get_name() != "sweep") return {};
  auto const meant = meant_key(name.substr(name.find_first_not_of('-')));
  if (meant.key.empty()) return meant.remark.starts_with(" (") ? meant.remark : "";
  return sets ? fmt::format(" (a key of the scene: --set {}=VALUE)", meant.key)
              : fmt::format(" (a key of the scene: {}, in its file)", meant.key);
}

/// First word that is not an option of the command.
std::string wrong_option(CLI::App& app, std::vector<std::string> const& words) {
  auto const given = app.get_subcommands();
  auto const& command = given.empty() ? app : *given.front();
  std::vector<std::string> known;
  for (auto const* option : command.get_options())
    for (auto const& name : option->get_lnames()) known.push_back("--" + name);
  for (auto const& word : words) {
    auto const name = word.substr(0, word.find('='));
    bool const is_option =
        name.starts_with('-') && name.find_first_not_of('-') != std::string::npos &&
        std::isalpha(static_cast<unsigned char>(name[name.find_first_not_of('-')]));
    if (!is_option || name == "-h" || std::ranges::count(known, name) > 0) continue;
    return fmt::format("unknown option {}{}", shown(name), hint_of_option(command, name, known));
  }
  return {};
}

/// Refuses an option without its value. CLI11 would take the next word for it.
void refuse_value_left_out(std::vector<std::string> const& words) {
  for (auto const& word : words)
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      throw UnreadableWords(fmt::format("{} (is empty, must be a value); give one, or leave {} out",
                                        shown(word), shown(word.substr(0, word.size() - 1))));
}

}  // namespace

bool CommandLine::parse(std::vector<std::string> const& words) {
  refuse_value_left_out(words);
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
