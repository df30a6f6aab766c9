// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/checkpoint.hpp"

#include <fmt/format.h>

#include <exception>
#include <span>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/descriptor.hpp"
#include "src/io/seal.hpp"
#include "src/io/state_file.hpp"

namespace bagnold::io {
namespace {

constexpr std::int64_t schema = 3;  ///< of the file, see SCHEMA.md

std::filesystem::path newest_of(std::filesystem::path const& folder) {
  return folder / "checkpoint.h5";
}
std::filesystem::path previous_of(std::filesystem::path const& folder) {
  return folder / "checkpoint.previous.h5";
}

Checkpoint load(std::filesystem::path const& path) {
  return parse_checkpoint(path.string(), read_file(path));
}

bool sealed(std::filesystem::path const& path) {
  if (!std::filesystem::exists(path)) return false;
  auto content = read_file(path);
  return remove_seal(content).empty();
}

/// The verified temporary becomes the newest; a newest that rotted does not take the place of the
/// one before. After a kill between the renames there is no newest, but the temporary and the one
/// before are whole.
void take_names(std::filesystem::path const& folder) {
  auto const newest = newest_of(folder);
  if (sealed(newest)) rename_file(newest, previous_of(folder));
  rename_file(temporary_of(newest), newest);
  sync_folder(folder);
}

/// A kill may have left a whole temporary without its name, perhaps the one resumed from: it is
/// not overwritten.
void adopt_whole_temporary(std::filesystem::path const& folder) {
  if (sealed(temporary_of(newest_of(folder)))) take_names(folder);
}

}  // namespace

std::vector<std::byte> checkpoint_image(Checkpoint const& checkpoint) {
  Hdf5Writer file(Hashed::yes);
  file.attribute("/", "format", "bagnold-checkpoint");
  file.attribute("/", "schema", schema);
  file.text("/scene", checkpoint.scene);
  put_state(file, checkpoint.state);

  file.group("/list");
  file.dataset("/list/position", flat(checkpoint.list_position), {checkpoint.state.count(), 2},
               {{"unit", "d_s"}});
  file.attribute("/list", "step", checkpoint.list_step);
  file.attribute("/list", "builds", checkpoint.builds);

  file.group("/run");
  file.attribute("/run", "step", checkpoint.step);
  file.attribute("/run", "initial_offset", checkpoint.initial_offset);
  file.attribute("/run", "initial_time", checkpoint.initial_time);
  file.attribute("/run", "wall_seconds", checkpoint.wall_seconds);

  file.group("/windows");
  auto const columns = static_cast<hsize_t>(checkpoint.columns);
  file.dataset("/windows/sums", checkpoint.window_sums, {checkpoint.window_weight.size(), columns});
  file.dataset("/windows/weight", checkpoint.window_weight, {checkpoint.window_weight.size()});
  file.dataset("/windows/open_sums", checkpoint.open_sums, {checkpoint.open_sums.size()});
  file.attribute("/windows", "columns", checkpoint.columns);
  file.attribute("/windows", "open_weight", checkpoint.open_weight);

  file.group("/engine");
  for (auto const& [name, value] : checkpoint.engine) file.attribute("/engine", name, value);

  file.group("/start_record");
  for (auto const& [name, value] : checkpoint.start_record)
    file.attribute("/start_record", name, value);

  file.group("/frames");
  for (auto const& [name, numbers] : checkpoint.frames) {
    file.dataset("/frames/" + name, numbers, {numbers.size()});
    file.attribute("/frames", name, static_cast<std::int64_t>(numbers.size()));
  }

  auto image = file.image();
  add_seal(image);
  return image;
}

Checkpoint parse_checkpoint(std::string const& name, std::vector<std::byte> image) {
  if (auto const reason = remove_seal(image); !reason.empty())
    throw InputError(fmt::format("{} {}", name, reason));
  Hdf5Reader const file(name, std::move(image), Hashed::yes);
  if (auto const found = file.integer("/", "schema"); found != schema)
    throw InputError(fmt::format("{}: schema = {} (must be {}): use the version that wrote it",
                                 name, found, schema));
  Checkpoint checkpoint;
  checkpoint.scene = file.text("/scene");
  checkpoint.state = get_state(file);
  checkpoint.list_position = file.pairs("/list/position", checkpoint.state.count());
  checkpoint.list_step = file.integer("/list", "step");
  checkpoint.builds = file.integer("/list", "builds");

  checkpoint.step = file.integer("/run", "step");
  checkpoint.initial_offset = file.number("/run", "initial_offset");
  checkpoint.initial_time = file.number("/run", "initial_time");
  checkpoint.wall_seconds = file.number("/run", "wall_seconds");

  checkpoint.columns = file.integer("/windows", "columns");
  auto const weight_shape = file.shape("/windows/weight");
  checkpoint.window_weight = file.doubles("/windows/weight", weight_shape);
  checkpoint.window_sums = file.doubles(
      "/windows/sums", {checkpoint.window_weight.size(), static_cast<hsize_t>(checkpoint.columns)});
  checkpoint.open_sums = file.doubles("/windows/open_sums", file.shape("/windows/open_sums"));
  checkpoint.open_weight = file.number("/windows", "open_weight");

  for (auto const& counter : file.attribute_names("/engine"))
    checkpoint.engine[counter] = file.number("/engine", counter);

  for (auto const& record : file.attribute_names("/start_record"))
    checkpoint.start_record[record] = file.number("/start_record", record);

  for (auto const& name : file.attribute_names("/frames"))
    checkpoint.frames[name] = file.doubles(
        "/frames/" + name, {static_cast<hsize_t>(file.integer("/frames", name))});
  return checkpoint;
}

void write_checkpoint(std::filesystem::path const& folder, Checkpoint const& checkpoint) {
  auto const image = checkpoint_image(checkpoint);
  adopt_whole_temporary(folder);
  write_verified(temporary_of(newest_of(folder)), image);
  take_names(folder);
}

std::optional<Checkpoint> newest_checkpoint(std::filesystem::path const& folder,
                                            std::vector<std::string>* remarks) {
  std::optional<Checkpoint> best;
  for (auto const& path :
       {newest_of(folder), temporary_of(newest_of(folder)), previous_of(folder)}) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored) && !ignored) continue;
    try {
      auto found = load(path);
      if (!best || found.step > best->step) best = std::move(found);
    } catch (std::exception const& error) {
      if (remarks != nullptr) remarks->push_back(error.what());
    }
  }
  return best;
}

void remove_checkpoints(std::filesystem::path const& folder) {
  for (auto const& path : {newest_of(folder), temporary_of(newest_of(folder)), previous_of(folder)})
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail_on("remove", path, errno);
  sync_folder(folder);
}

}  // namespace bagnold::io
