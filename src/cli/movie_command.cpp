// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

Command add_movie(Words program) {
  struct Options {
    std::filesystem::path folder, file;
    std::string frames = ":", color = "velocity", series;
    int fps = 15;
    bool no_forces = false, quiet = false;
  };
  auto const options = std::make_shared<Options>();
  Words command = add_command(program, "movie",
                              "film a trajectory: disks, force chains, bands, and a series below");
  command.option("DIR", options->folder, "folder of a run with a trajectory").required();
  command.option("FILE", options->file, "NAME.gif, or NAME.mp4, which needs ffmpeg").required();
  command.option("--frames", options->frames, "A:B or A:B:K, from 0, every K-th [all]");
  command
      .option("--color", options->color,
              "of disks: velocity, speed, rate (bands), spin, contacts or size [velocity]")
      .one_of({"velocity", "speed", "rate", "spin", "contacts", "size"});
  command.flag("--no-forces", options->no_forces, "disks alone");
  command.option("--series", options->series, "drawn below [sigma; of a ramp its rate]");
  command.option("--fps", options->fps, "frames a second [15]").between(1, 120);
  command.flag("--quiet", options->quiet, "no progress; errors are still shown");
  return {command, [options] {
            std::vector<std::string> words{"movie",
                                           std::filesystem::absolute(options->folder),
                                           std::filesystem::absolute(options->file),
                                           "--frames=" + options->frames,
                                           "--color",
                                           options->color,
                                           "--fps",
                                           fmt::format("{}", options->fps)};
            if (!options->series.empty()) words.insert(words.end(), {"--series", options->series});
            if (options->no_forces) words.emplace_back("--no-forces");
            if (options->quiet) words.emplace_back("--quiet");
            return exit_code_of_package(call_package(words, "film"));
          }};
}

}  // namespace bagnold
