// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/checkpoint.hpp"

#include <fmt/format.h>

#include <exception>
#include <span>
#include <utility>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/descriptor.hpp"
#include "src/io/seal.hpp"
#include "src/io/state_file.hpp"

namespace bagnold::io {
namespace {

constexpr std::int64_t schema = 8;  ///< of the file, see docs/files.md

std::filesystem::path newest_of(std::filesystem::path const& folder) {
  return folder / "checkpoint.h5";
}
std::filesystem::path previous_of(std::filesystem::path const& folder) {
  return folder / "checkpoint.previous.h5";
}

/// The verified temporary becomes the newest; a newest that rotted does not take the place of the
/// one before. After a kill between the renames there is no newest, but the temporary and the one
/// before are whole.
void take_names(std::filesystem::path const& folder) {
  auto const newest = newest_of(folder);
  if (is_sealed(newest)) rename_file(newest, previous_of(folder));
  rename_file(temporary_of(newest), newest);
  sync_folder(folder);
}

/// A kill may have left a whole temporary without its name, perhaps the one resumed from: it is
/// not overwritten.
void adopt_whole_temporary(std::filesystem::path const& folder) {
  if (is_sealed(temporary_of(newest_of(folder)))) take_names(folder);
}

/// Where a system lies in the file: one alone at the root, several in groups of their own, because
/// they pause at steps of their own, with numbers of windows that differ.
std::string place_of(std::size_t system, std::size_t systems) {
  return systems == 1 ? "" : fmt::format("/replicas/{}", system);
}

void put_system(Hdf5Writer& file, SystemCheckpoint system, std::string const& at,
                double wall_seconds) {
  std::vector<State> state;
  state.push_back(std::move(system.state));
  auto const count = state.front().count();
  put_states(file, std::move(state), at);

  file.group(at + "/list");
  file.dataset(at + "/list/position", flat(std::exchange(system.list_position, {})), {count, 2},
               {{"unit", "d_s"}});
  file.attribute(at + "/list", "step", system.list_step);
  file.attribute(at + "/list", "builds", system.list_builds);

  file.group(at + "/run");
  file.attribute(at + "/run", "step", system.step);
  file.attribute(at + "/run", "initial_offset", system.initial_offset);
  file.attribute(at + "/run", "initial_time", system.initial_time);
  file.attribute(at + "/run", "wall_seconds", wall_seconds);

  auto const windows = at + "/windows";
  file.group(windows);
  auto const columns = static_cast<hsize_t>(system.columns);
  file.dataset(windows + "/sums", system.window_sums, {system.window_weight.size(), columns});
  file.dataset(windows + "/weight", system.window_weight, {system.window_weight.size()});
  file.dataset(windows + "/open_sums", system.open_sums, {system.open_sums.size()});
  file.attribute(windows, "columns", system.columns);
  file.attribute(windows, "open_weight", system.open_weight);

  file.group(at + "/engine");
  for (auto const& [name, value] : system.memory) file.attribute(at + "/engine", name, value);

  if (!system.arrays.empty()) {
    file.group(at + "/events");
    for (auto const& [name, numbers] : system.arrays) {
      file.dataset(at + "/events/" + name, numbers, {numbers.size()});
      file.attribute(at + "/events", name, static_cast<std::int64_t>(numbers.size()));
    }
  }

  file.group(at + "/counters");
  for (auto const& [name, value] : system.counters) file.attribute(at + "/counters", name, value);

  file.group(at + "/start_record");
  for (auto const& [name, value] : system.start_record)
    file.attribute(at + "/start_record", name, value);

  file.group(at + "/frames");
  for (auto const& [name, numbers] : system.frames) {
    file.dataset(at + "/frames/" + name, numbers, {numbers.size()});
    file.attribute(at + "/frames", name, static_cast<std::int64_t>(numbers.size()));
  }
}

SystemCheckpoint get_system(Hdf5Reader const& file, std::string const& at) {
  SystemCheckpoint system;
  auto states = get_states(file, at);
  if (states.size() != 1)
    throw InputError(fmt::format("{}: {}/state holds {} states (must be one); the file is damaged",
                                 file.name(), at, states.size()));
  system.state = std::move(states.front());
  system.list_position = file.pairs(at + "/list/position", {system.state.count()});
  system.list_step = file.integer(at + "/list", "step");
  system.list_builds = file.integer(at + "/list", "builds");

  system.step = file.integer(at + "/run", "step");
  system.initial_offset = file.number(at + "/run", "initial_offset");
  system.initial_time = file.number(at + "/run", "initial_time");

  auto const windows = at + "/windows";
  system.columns = file.integer(windows, "columns");
  system.window_weight = file.doubles(windows + "/weight", file.shape(windows + "/weight"));
  system.window_sums = file.doubles(
      windows + "/sums", {system.window_weight.size(), static_cast<hsize_t>(system.columns)});
  system.open_sums = file.doubles(windows + "/open_sums", file.shape(windows + "/open_sums"));
  system.open_weight = file.number(windows, "open_weight");

  for (auto const& name : file.attribute_names(at + "/engine"))
    system.memory[name] = file.number(at + "/engine", name);

  if (file.has(at + "/events"))
    for (auto const& name : file.attribute_names(at + "/events"))
      system.arrays[name] = file.doubles(
          at + "/events/" + name, {static_cast<hsize_t>(file.integer(at + "/events", name))});

  for (auto const& name : file.attribute_names(at + "/counters"))
    system.counters[name] = file.number(at + "/counters", name);

  for (auto const& record : file.attribute_names(at + "/start_record"))
    system.start_record[record] = file.number(at + "/start_record", record);

  for (auto const& frames : file.attribute_names(at + "/frames"))
    system.frames[frames] = file.doubles(
        at + "/frames/" + frames, {static_cast<hsize_t>(file.integer(at + "/frames", frames))});
  return system;
}

/// A file whose seal is true. Throws InputError.
Hdf5Reader open_checkpoint(std::string const& name, std::vector<std::byte> image) {
  if (auto const reason = remove_seal(image); !reason.empty())
    throw InputError(fmt::format("{} {}", name, reason));
  Hdf5Reader file(name, std::move(image), Hashed::yes);
  if (auto const found = file.integer("/", "schema"); found != schema)
    throw InputError(fmt::format("{}: schema = {} (must be {}): use the version that wrote it",
                                 name, found, schema));
  return file;
}

/// Where its systems lie.
std::vector<std::string> places(Hdf5Reader const& file) {
  std::int64_t const count =
      file.has_attribute("/", "replicas") ? file.integer("/", "replicas") : 1;
  if (count < 1)
    throw InputError(fmt::format("{}: replicas = {} (must be at least 1): the file is damaged",
                                 file.name(), count));
  std::vector<std::string> all;
  for (std::int64_t r = 0; r < count; ++r) {
    all.push_back(place_of(static_cast<std::size_t>(r), static_cast<std::size_t>(count)));
    if (count > 1 && !file.has(all.back())) break;  // reading it will say what is missing
  }
  return all;
}

Checkpoint get_checkpoint(Hdf5Reader const& file) {
  Checkpoint checkpoint;
  checkpoint.scene = file.text("/scene");
  if (file.has("/simd")) checkpoint.simd = file.text("/simd");
  checkpoint.whole = file.has_attribute("/", "whole") && file.integer("/", "whole") == 1;
  auto const all = places(file);
  for (auto const& at : all) checkpoint.systems.push_back(get_system(file, at));
  checkpoint.wall_seconds = file.number(all.front() + "/run", "wall_seconds");
  return checkpoint;
}

/// As Checkpoint::steps, before its arrays are read.
std::int64_t steps_in(Hdf5Reader const& file) {
  std::int64_t sum = 0;
  for (auto const& at : places(file)) sum += file.integer(at + "/run", "step");
  return sum;
}

/// The file without its seal.
Hdf5Writer checkpoint_file(Checkpoint checkpoint) {
  Hdf5Writer file(Hashed::yes);
  auto const count = checkpoint.systems.size();
  file.attribute("/", "format", "bagnold-checkpoint");
  file.attribute("/", "schema", schema);
  if (count > 1) file.attribute("/", "replicas", static_cast<std::int64_t>(count));
  file.text("/scene", checkpoint.scene);
  if (!checkpoint.simd.empty()) file.text("/simd", checkpoint.simd);
  file.attribute("/", "whole", std::int64_t{checkpoint.whole ? 1 : 0});
  if (count > 1) file.group("/replicas");
  for (std::size_t r = 0; r < count; ++r) {
    auto const at = place_of(r, count);
    if (!at.empty()) file.group(at);
    put_system(file, std::move(checkpoint.systems[r]), at, checkpoint.wall_seconds);
  }
  return file;
}

}  // namespace

std::int64_t Checkpoint::steps() const {
  std::int64_t sum = 0;
  for (auto const& system : systems) sum += system.step;
  return sum;
}

std::vector<std::byte> checkpoint_image(Checkpoint checkpoint) {
  auto const file = checkpoint_file(std::move(checkpoint));
  std::vector<std::byte> image(file.content().begin(), file.content().end());
  add_seal(image);
  return image;
}

Checkpoint parse_checkpoint(std::string const& name, std::vector<std::byte> image) {
  return get_checkpoint(open_checkpoint(name, std::move(image)));
}

void write_checkpoint(std::filesystem::path const& folder, Checkpoint checkpoint) {
  auto const file = checkpoint_file(std::move(checkpoint));
  auto const seal = seal_of(file.content());
  adopt_whole_temporary(folder);
  write_verified(temporary_of(newest_of(folder)), file.content(), std::as_bytes(std::span(seal)));
  take_names(folder);
}

std::optional<Checkpoint> newest_checkpoint(std::filesystem::path const& folder,
                                            std::vector<std::string>* remarks) {
  std::optional<Checkpoint> best;
  std::exception_ptr unreadable;
  for (auto const& path :
       {newest_of(folder), temporary_of(newest_of(folder)), previous_of(folder)}) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored) && !ignored) continue;
    try {
      auto const file = open_checkpoint(path.string(), read_file(path));
      if (!best || steps_in(file) > best->steps()) best = get_checkpoint(file);
    } catch (std::exception const& error) {
      if (remarks != nullptr) remarks->push_back(error.what());
      if (dynamic_cast<FileError const*>(&error) != nullptr) unreadable = std::current_exception();
    }
  }
  if (!best && unreadable) std::rethrow_exception(unreadable);
  return best;
}

void remove_checkpoints(std::filesystem::path const& folder) {
  for (auto const& path : {newest_of(folder), temporary_of(newest_of(folder)), previous_of(folder)})
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail_on("remove", path, errno);
  sync_folder(folder);
}

}  // namespace bagnold::io
