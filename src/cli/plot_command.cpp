// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "src/analysis/analyse.hpp"
#include "src/cli/exit_code.hpp"
#include "src/cli/options.hpp"
#include "src/config/cascade.hpp"
#include "src/config/errors.hpp"
#include "src/config/run_time.hpp"
#include "src/config/scene_file.hpp"
#include "src/config/shell_word.hpp"
#include "src/run/messages.hpp"
#include "src/run/pictures.hpp"
#include "src/run/plot.hpp"
#include "src/run/status.hpp"

namespace bagnold {

namespace {

namespace fs = std::filesystem;

/// Prints the name of the picture, and the part of a run that it shows.
void say_drawn(fs::path const& picture, std::string const& of) {
  if (fs::exists(picture)) fmt::print("{}{}\n", picture.string(), of);
}

void refuse(std::string const& wrong) {
  if (!wrong.empty()) throw FileError(wrong);
}

/// Draws the pictures of a run, from its last checkpoint if it is not done.
void plot_run(fs::path const& folder, std::string const& format) {
  auto const status = status_of(folder);
  auto const result = folder / "result.h5";
  if (!fs::exists(result))
    throw InputError(fmt::format(
        "{}: has nothing to draw before its first checkpoint; {}", folder.string(),
        status.state == RunStatus::State::running
            ? "`kill -USR1 PID` writes one now"
            : fmt::format("`bagnold resume {}` goes on with it", shell_word(folder.string()))));
  auto of = fmt::format(", of strain {:.4g} of {:.4g}", status.strain, status.whole);
  if (status.state == RunStatus::State::done) of.clear();
  if (status.age > 0)
    of += fmt::format(" ({} ago{})", time_text(status.age),
                      status.state == RunStatus::State::running
                          ? "; `kill -USR1 PID` writes a checkpoint now"
                          : "");
  auto const picture = [&](char const* name) {
    return folder / fmt::format("{}.{}", name, format);
  };
  refuse(draw_plot(result, picture("plot")));
  say_drawn(picture("plot"), of);
  Scene const scene = read_kept_scene(folder / "scene.toml");
  if (!scene.measure.profiles && !makes_histograms(scene)) return;
  refuse(draw_frames(result, format == "png" ? folder : picture("frames")));
  say_drawn(picture("profiles"), of);
  say_drawn(picture("fields"), of);
  say_drawn(picture("histograms"), of);
}

/// Draws each rate that has begun, and the flow curve once all are done.
void plot_cascade(fs::path const& folder, Scene const& cascade, std::string const& format) {
  for (auto const& stage : stage_folders(cascade))
    if (fs::exists(folder / stage / "result.h5")) plot_run(folder / stage, format);
  if (!fs::exists(folder / "summary.json")) return;
  auto const picture = folder / ("flow_curve." + format);
  refuse(draw_plot(folder, picture));
  say_drawn(picture, "");
}

/// Draws the table of a sweep as `analyse table` does; false where it cannot be told what its
/// curves are, with a remark.
bool plot_table(fs::path const& folder, std::string const& format) {
  analysis::Analysis made;
  try {
    made = analysis::analyse(folder, {.kind = "table"});
  } catch (InputError const& error) {
    warn(fmt::format("no table is drawn: {}", error.what()));
    return false;
  }
  made.picture.replace_extension(format);
  for (auto const& note : made.report.notes) warn(note);
  if (!made.report.drawn.rows.empty()) refuse(draw_plot(made.drawn, made.picture));
  say_drawn(made.picture, "; `bagnold analyse table --help` for other axes");
  return true;
}

/// Draws the table of a sweep, and its points at first sight where they have averages.
void plot_sweep(fs::path const& folder, std::string const& format) {
  if (!fs::exists(folder / "sweep.h5"))
    throw InputError(
        fmt::format("{}: has no tables yet; `bagnold sweep {} --out {} --collect` writes those of "
                    "the points that are done",
                    folder.string(), shell_word((folder / "sweep.toml").string()),
                    shell_word(folder.string())));
  bool const tabled = plot_table(folder, format);
  auto const picture = folder / ("sweep." + format);
  auto const wrong = draw_plot(folder, picture);
  if (!tabled) refuse(wrong);
  if (wrong.empty()) say_drawn(picture, "");
}

int plot_command(PlotOptions const& options) {
  auto const& folder = options.folder;
  if (fs::exists(folder / "points.json")) {
    plot_sweep(folder, options.format);
    return done;
  }
  status_of(folder);  // or it holds nothing
  Scene const scene = read_kept_scene(folder / "scene.toml");
  if (scene.shear.run_per_rate())
    plot_cascade(folder, scene, options.format);
  else
    plot_run(folder, options.format);
  return done;
}

}  // namespace

Command add_plot(Words program) {
  auto const options = std::make_shared<PlotOptions>();
  Words command = add_command(program, "plot",
                              "draw the pictures of a run, a cascade or a sweep now, also while it "
                              "runs: of its last checkpoint");
  command.option("DIR", options->folder, "folder of a run or a sweep").required();
  add_picture_format(command, options->format);
  return {command, [options] { return plot_command(*options); }};
}

}  // namespace bagnold
