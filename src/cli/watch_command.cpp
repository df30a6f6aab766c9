// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

Command add_watch(Words program) {
  struct Options {
    std::filesystem::path folder;
    double every = 2;
    bool once = false;
  };
  auto const options = std::make_shared<Options>();
  Words command =
      add_command(program, "watch",
                  "see a run, a cascade or a sweep go on: p, sigma, Z, time left, until "
                  "nobody works on it");
  command.option("DIR", options->folder, "folder of a run, a cascade or a sweep").required();
  command.option("--every", options->every, "seconds between looks [2]").between(0.1, 86400.0);
  command.flag("--once", options->once, "one look");
  return {command, [options] {
            std::vector<std::string> words{
                "watch",     std::filesystem::absolute(options->folder),
                "--every",   fmt::format("{}", options->every),
                "--program", std::filesystem::read_symlink("/proc/self/exe")};
            if (options->once) words.emplace_back("--once");
            return exit_code_of_package(call_package(words, "watch"));
          }};
}

}  // namespace bagnold
