// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

namespace {

/// The words of `python -m bagnold export`, which checks them, with absolute paths.
std::vector<std::string> words_of(ExportOptions const& options) {
  std::vector<std::string> words{"export", std::filesystem::absolute(options.folder), "--to",
                                 options.format, "--frames=" + options.frames};
  if (!options.file.empty())
    words.insert(words.end(), {"--out", std::filesystem::absolute(options.file)});
  if (options.contacts) words.emplace_back("--contacts");
  if (options.quiet) words.emplace_back("--quiet");
  return words;
}

}  // namespace

Command add_export(Words program) {
  auto const options = std::make_shared<ExportOptions>();
  Words command = add_command(program, "export", "write a trajectory for other programs");
  command.option("DIR", options->folder, "folder of a run with a trajectory").required();
  command.option("--to", options->format, "lammps (dump), extxyz, gsd (needs its library) or vtk")
      .required();
  command.option("--frames", options->frames, "A:B, from frame A to before B, from 0 [all]");
  command.option("--out", options->file, "file [trajectory.ENDING in the folder]");
  command.flag("--contacts", options->contacts, "contacts and their forces too; not in extxyz");
  command.flag("--quiet", options->quiet, "do not tell the files; errors are still shown");
  return {command,
          [options] { return exit_code_of_package(call_package(words_of(*options), "export")); }};
}

}  // namespace bagnold
