// SPDX-License-Identifier: BSD-3-Clause
#include <initializer_list>
#include <memory>
#include <utility>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

namespace {

/// The words of `python -m bagnold import`, which checks them, with absolute paths.
std::vector<std::string> words_of(ImportOptions const& options) {
  std::vector<std::string> words{"import", std::filesystem::absolute(options.file), "--out",
                                 std::filesystem::absolute(options.state)};
  std::initializer_list<std::pair<std::string, std::string>> const wishes{
      {"--from", options.format},
      {"--frame", options.frame},
      {"--unit", options.unit},
      {"--time-unit", options.time_unit},
      {"--strain-rate", options.rate},
      {"--diameters", options.diameters},
      {"--atom-style", options.atom_style},
      {"--bounds", options.bounds},
      {"--tolerance", options.tolerance}};
  for (auto const& [name, value] : wishes)
    if (!value.empty()) words.push_back(name + "=" + value);
  if (options.quiet) words.emplace_back("--quiet");
  return words;
}

}  // namespace

Command add_import(Words program) {
  auto const options = std::make_shared<ImportOptions>();
  Words command = add_command(program, "import",
                              "write a state to start from of a configuration of another program");
  command.option("FILE", options->file, "LAMMPS data file, LAMMPS dump, or extended XYZ")
      .required();
  command.option("--out", options->state, "state file to write, for start.file").required();
  command.option("--from", options->format, "format [as the file looks]")
      .one_of({"lammps", "dump", "extxyz"});
  command.option("--frame", options->frame, "from 0, or from the end [-1, the last]");
  command.option("--unit", options->unit, "d_s in the file's unit [its smallest diameter]");
  command.option("--time-unit", options->time_unit, "tau_e in the file's unit [1]");
  command.option("--strain-rate", options->rate,
                 "of the velocities, in the file's unit [as the file says]");
  command.option("--diameters", options->diameters,
                 "TYPE=D,TYPE=D: by type, of a file that has none");
  command.option("--atom-style", options->atom_style, "of a LAMMPS data file [its hint]");
  command
      .option("--bounds", options->bounds,
              "of a tilted cell in a dump: outer, of all that it covers, or edges, xlo and xhi [as "
              "the disks lie]")
      .one_of({"outer", "edges"});
  command.option("--tolerance", options->tolerance,
                 "relative, within which diameters are 1 and 1.4 [1e-6]");
  command.flag("--quiet", options->quiet, "do not tell what a scene needs");
  return {command,
          [options] { return exit_code_of_package(call_package(words_of(*options), "import")); }};
}

}  // namespace bagnold
