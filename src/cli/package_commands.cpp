// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

namespace fs = std::filesystem;

namespace {

/// A command that the Python package does: its words become those of `python -m bagnold NAME`,
/// which checks them, with absolute paths and without what is empty.
class PackageCommand {
 public:
  PackageCommand(Words program, char const* name, char const* description)
      : command_(add_command(program, name, description)) {
    add([=] { return name; });
  }

  template <class T>
  Word option(char const* name, char const* meaning, T const& otherwise) {
    auto const value = std::make_shared<T>(otherwise);
    add([=] {
      auto const text = word(*value);
      return *name != '-' || text.empty() ? text : fmt::format("{}={}", name, text);
    });
    return command_.option(name, *value, meaning);
  }
  Word path(char const* name, char const* meaning) { return option(name, meaning, fs::path()); }
  Word text(char const* name, char const* meaning) { return option(name, meaning, std::string()); }

  void flag(char const* name, char const* meaning) {
    auto const given = std::make_shared<bool>(false);
    add([=] { return *given ? name : ""; });
    command_.flag(name, *given, meaning);
  }

  /// Adds a word that is made when the command runs.
  void add(std::function<std::string()> make) { words_.push_back(std::move(make)); }

  /// wish: the task, for messages.
  Command to(char const* wish) const {
    return {command_, [make = words_, wish] {
              std::vector<std::string> words;
              for (auto const& one : make) words.push_back(one());
              std::erase(words, "");
              return exit_code_of_package(call_package(words, wish));
            }};
  }

 private:
  static std::string word(fs::path const& path) { return path.empty() ? path : fs::absolute(path); }
  template <class T>
  static std::string word(T const& value) {
    return fmt::format("{}", value);
  }

  Words command_;
  std::vector<std::function<std::string()>> words_;
};

}  // namespace

Command add_export(Words program) {
  PackageCommand command(program, "export", "write a trajectory for other programs");
  command.path("DIR", "folder of a run with a trajectory").required();
  command.text("--to", "lammps (dump), extxyz, gsd (needs its library) or vtk").required();
  command.text("--frames", "A:B, from frame A to before B, from 0 [all]");
  command.path("--out", "file [trajectory.ENDING in the folder]");
  command.flag("--contacts", "contacts and their forces too; not in extxyz");
  command.flag("--quiet", "do not tell the files; errors are still shown");
  return command.to("export");
}

Command add_import(Words program) {
  PackageCommand command(program, "import",
                         "write a state to start from of a configuration of another program");
  command.path("FILE", "LAMMPS data file, LAMMPS dump, or extended XYZ").required();
  command.path("--out", "state file to write, for start.file").required();
  command.text("--from", "format [as the file looks]").one_of({"lammps", "dump", "extxyz"});
  command.text("--frame", "from 0, or from the end [-1, the last]");
  command.text("--unit", "d_s in the file's unit [its smallest diameter]");
  command.text("--time-unit", "tau_e in the file's unit [1]");
  command.text("--strain-rate", "of the velocities, in the file's unit [as the file says]");
  command.text("--diameters", "TYPE=D,TYPE=D: by type, of a file that has none");
  command.text("--atom-style", "of a LAMMPS data file [its hint]");
  command
      .text("--bounds",
            "of a tilted cell in a dump: outer, of all that it covers, or edges, xlo and xhi [as "
            "the disks lie]")
      .one_of({"outer", "edges"});
  command.text("--tolerance", "relative, within which diameters are 1 and 1.4 [1e-6]");
  command.flag("--quiet", "do not tell what a scene needs");
  return command.to("import");
}

Command add_movie(Words program) {
  PackageCommand command(program, "movie",
                         "film a trajectory: disks, force chains, bands, and a series below");
  command.path("DIR", "folder of a run with a trajectory").required();
  command.path("FILE", "NAME.gif, or NAME.mp4, which needs ffmpeg").required();
  command.text("--frames", "A:B or A:B:K, from 0, every K-th [all]");
  command
      .text("--color", "of disks: velocity, speed, rate (bands), spin, contacts or size [velocity]")
      .one_of({"velocity", "speed", "rate", "spin", "contacts", "size"});
  command.flag("--no-forces", "disks alone");
  command.text("--series", "drawn below [sigma; of a ramp its rate]");
  command.option("--fps", "frames a second [15]", 15).between(1, 120);
  command.flag("--quiet", "no progress; errors are still shown");
  return command.to("film");
}

Command add_report(Words program) {
  PackageCommand command(program, "report",
                         "one page of HTML to mail: table, warnings, pictures, scene, provenance");
  command.path("DIR", "folder of a run, a cascade or a sweep").required();
  command.path("--out", "file [report.html in the folder]");
  command.flag("--quiet", "do not tell the file; errors are still shown");
  return command.to("write a report");
}

Command add_watch(Words program) {
  PackageCommand command(program, "watch",
                         "see a run, a cascade or a sweep go on: p, sigma, Z, time left, until "
                         "nobody works on it");
  command.path("DIR", "folder of a run, a cascade or a sweep").required();
  command.option("--every", "seconds between looks [2]", 2.0).between(0.1, 86400.0);
  command.flag("--once", "one look");
  command.add([] { return "--program=" + fs::read_symlink("/proc/self/exe").string(); });
  return command.to("watch");
}

}  // namespace bagnold
