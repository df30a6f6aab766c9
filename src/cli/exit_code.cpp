// SPDX-License-Identifier: BSD-3-Clause
#include "src/cli/exit_code.hpp"

#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "src/cli/signals.hpp"
#include "src/config/errors.hpp"
#include "src/run/messages.hpp"

namespace bagnold {

namespace {

/// Message with long lines cut in the middle, as where a file has a word of a megabyte.
std::string with_short_lines(std::string const& message) {
  constexpr std::size_t head = 1000, tail = 300;
  std::string out;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > head + tail)
      line = line.substr(0, head) + " ... " + line.substr(line.size() - tail);
    out += (out.empty() ? "" : "\n") + line;
  }
  return out;
}

ExitCode told(std::string const& message, ExitCode code) {
  say(with_short_lines(message));
  return code;
}

}  // namespace

ExitCode exit_code_of(std::exception_ptr const& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (InputError const& error) {
    return told(error.what(), bad_input);
  } catch (NumericalError const& error) {
    return told(error.what(), numerical_failure);
  } catch (FileError const& error) {
    return told(error.what(), file_failure);
  } catch (std::system_error const& error) {
    return told(error.what(), file_failure);
  } catch (std::bad_alloc const&) {
    return told("out of memory; use fewer disks or a machine with more", bad_input);
  } catch (std::length_error const& error) {
    return told(
        std::string(error.what()) +
            ": disks.count and integration.skin ask for more than lists can hold; use fewer "
            "disks or a smaller skin",
        bad_input);
  } catch (std::exception const& error) {
    return told(
        std::string("internal error (") + error.what() + "); please report it, with the scene",
        internal_error);
  } catch (...) {
    return told("internal error; please report it, with the scene", internal_error);
  }
}

int exit_code_of(RunEnd end) { return end == RunEnd::done ? done : 128 + stop_signal(); }

int exit_code_of(sweep::SweepEnd end) {
  if (end == sweep::SweepEnd::stopped) return 128 + stop_signal();
  return end == sweep::SweepEnd::done ? done : points_failed;
}

int exit_code_of_package(int code) {
  bool const ours = code == done || code == bad_input || code == file_failure || code > 128;
  return ours ? code : internal_error;
}

}  // namespace bagnold
