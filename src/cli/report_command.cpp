// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/run/python_package.hpp"

namespace bagnold {

Command add_report(Words program) {
  struct Options {
    std::filesystem::path folder, file;
    bool quiet = false;
  };
  auto const options = std::make_shared<Options>();
  Words command = add_command(
      program, "report", "one page of HTML to mail: table, warnings, pictures, scene, provenance");
  command.option("DIR", options->folder, "folder of a run, a cascade or a sweep").required();
  command.option("--out", options->file, "file [report.html in the folder]");
  command.flag("--quiet", options->quiet, "do not tell the file; errors are still shown");
  return {command, [options] {
            std::vector<std::string> words{"report", std::filesystem::absolute(options->folder)};
            if (!options->file.empty())
              words.insert(words.end(), {"--out", std::filesystem::absolute(options->file)});
            if (options->quiet) words.emplace_back("--quiet");
            return exit_code_of_package(call_package(words, "write a report"));
          }};
}

}  // namespace bagnold
