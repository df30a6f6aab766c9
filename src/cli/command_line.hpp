// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "src/config/errors.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Command line: its words, and the variables that they are read into. An interface to CLI11, which
/// takes four seconds to compile and is included by command_line.cpp alone.
namespace bagnold {

/// An argument, an option or a flag.
class Word {
 public:
  explicit Word(CLI::Option& option) : option_(&option) {}

  Word& required();
  Word& between(int least, int most);
  Word& between(double least, double most);
  Word& one_of(std::initializer_list<char const*> names);
  Word& values(int count);  ///< so many, one after the other
  Word& one_value_each();   ///< it is repeated for more
  Word& excludes(Word const& other);
  Word& needs(Word const& other);

 private:
  CLI::Option* option_;
};

/// Words of the program, or of a command. What they are read into must outlive the parsing.
class Words {
 public:
  explicit Words(CLI::App& app) : app_(&app) {}

  Words command(char const* name, char const* description);

  /// "NAME" or "--name". T: std::string, std::filesystem::path, int, std::int64_t, std::uint32_t,
  /// std::uint64_t, double; std::vector of strings or doubles; std::optional of a double, an
  /// std::int64_t or a pair. Numbers are decimal; an empty word is refused.
  template <class T>
  Word option(char const* name, T& value, char const* description);

  /// Values are given to `read`.
  Word option(char const* name, std::function<void(std::vector<std::string> const&)> read,
              char const* description);

  Word flag(char const* name, bool& value, char const* description);

  void footer(std::string const& text);  ///< below the help
  bool given() const;                    ///< the command was

 private:
  CLI::App* app_;
};

/// Error in the words of the command line.
struct UnreadableWords : InputError {
  using InputError::InputError;
};

class CommandLine {
 public:
  explicit CommandLine(char const* description = "");
  ~CommandLine();

  Words words();

  /// Requires one of the commands; --version prints `version`.
  void require_command(std::function<std::string()> version);
  std::vector<std::string> commands() const;

  /// Parses the words. Returns false if help or the version was asked for and printed. Throws
  /// UnreadableWords.
  bool parse(std::vector<std::string> const& words);

  /// Parses a line of words, quoted as in a shell. Throws UnreadableWords, also for help.
  void parse_line(std::string const& line);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace bagnold
