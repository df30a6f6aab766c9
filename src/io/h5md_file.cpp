// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/h5md_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/config/errors.hpp"

namespace bagnold::io {
namespace {

constexpr char const* group = "/particles/trajectory";

/// at: an open file, or what lies in it.
void require(bool good, Handle const& at) {
  if (good) return;
  auto const why = hdf5_reason();
  std::string name(4096, '\0');
  auto const length = H5Fget_name(at.get(), name.data(), name.size());
  name.resize(static_cast<std::size_t>(std::clamp<ssize_t>(length, 0, 4095)));
  throw FileError(fmt::format(
      "cannot write {}: {}; check the disk and its space, then `bagnold resume`", name, why));
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length);
  return type;
}

void attribute(Handle const& at, char const* name, hid_t type, Handle const& space,
               void const* value) {
  Handle made(H5Acreate2(at.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(made.valid() && H5Awrite(made.get(), type, value) >= 0 && made.close(), at);
}

void write_words(Handle const& at, char const* name, std::string const& value) {
  auto const type = text_type(value.size() + 1);
  attribute(at, name, type.get(), Handle(H5Screate(H5S_SCALAR), H5Sclose), value.c_str());
}

Handle make_group(Handle const& file, char const* path) {
  auto const creation = without_times(H5P_GROUP_CREATE);
  Handle made(H5Gcreate2(file.get(), path, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
  require(made.valid(), file);
  return made;
}

void fixed(Handle const& file, std::string const& path, hid_t stored, hid_t type, hsize_t count,
           void const* values) {
  auto const creation = without_times(H5P_DATASET_CREATE);
  Handle const space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  Handle set(H5Dcreate2(file.get(), path.c_str(), stored, space.get(), H5P_DEFAULT, creation.get(),
                        H5P_DEFAULT),
             H5Dclose);
  require(set.valid() && H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0 &&
              set.close(),
          file);
}

/// No unit attributes: reduced units have none in H5MD, and readers refuse those they do not know.
void describe(Handle const& file, std::string const& version) {
  auto const h5md = make_group(file, "/h5md");
  hsize_t const two = 2;
  int const form[2] = {1, 1};
  attribute(h5md, "version", H5T_NATIVE_INT, Handle(H5Screate_simple(1, &two, nullptr), H5Sclose),
            form);
  write_words(make_group(file, "/h5md/author"), "name", "not stated");
  auto const creator = make_group(file, "/h5md/creator");
  write_words(creator, "name", "Bagnold");
  write_words(creator, "version", version);
  auto const parameters = make_group(file, "/parameters");
  write_words(parameters, "length_unit", "d_s");
  write_words(parameters, "time_unit", "tau_e");
  write_words(parameters, "mass_unit", "m");
}

/// The third axis is there for readers that know three dimensions only: nothing moves along it.
void describe_box(Handle const& file) {
  auto const box = make_group(file, "/particles/trajectory/box");
  int const dimension = 3;
  attribute(box, "dimension", H5T_NATIVE_INT, Handle(H5Screate(H5S_SCALAR), H5Sclose), &dimension);
  hsize_t const three = 3;
  constexpr char boundary[3][9] = {"periodic", "periodic", "none"};
  attribute(box, "boundary", text_type(9).get(),
            Handle(H5Screate_simple(1, &three, nullptr), H5Sclose), boundary);
}

std::vector<double> with_third_axis(std::vector<std::array<double, 2>> const& rows) {
  std::vector<double> out;
  out.reserve(3 * rows.size());
  for (auto const& [x, y] : rows) out.insert(out.end(), {x, y, 0.0});
  return out;
}

}  // namespace

H5mdFile::H5mdFile(Handle file, TrajectoryHeader const& header)
    : count_(header.diameter.size()),
      file_(std::move(file)),
      step_(-1, H5Dclose),
      time_(-1, H5Dclose),
      edges_(-1, H5Dclose),
      position_(-1, H5Dclose),
      velocity_(-1, H5Dclose),
      spin_(-1, H5Dclose) {
  describe(file_, header.version);
  make_group(file_, "/particles");
  make_group(file_, group);
  describe_box(file_);
  std::string const at = std::string(group) + "/";
  std::vector<std::int32_t> species;
  for (double const d : header.diameter) species.push_back(d > 1.2 ? 1 : 0);
  fixed(file_, at + "species", H5T_STD_I32LE, H5T_NATIVE_INT32, count_, species.data());
  fixed(file_, at + "diameter", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, count_, header.diameter.data());
  fixed(file_, at + "mass", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, count_, header.mass.data());
  position_ = series("position", H5T_IEEE_F64LE, {count_, 3});
  velocity_ = series("velocity", H5T_IEEE_F64LE, {count_, 3});
  edges_ = series("box/edges", H5T_IEEE_F64LE, {3, 3});
  if (header.spins) spin_ = series("spin", H5T_IEEE_F64LE, {count_});
}

H5mdFile::~H5mdFile() {
  quiet_hdf5();  // the members are closed on this thread
}

/// A time-dependent element: `value`, and `step` and `time`, which all elements share.
Handle H5mdFile::series(std::string const& name, hid_t type, Shape const& frame_shape) {
  auto const at = fmt::format("{}/{}", group, name);
  make_group(file_, at.c_str());
  auto const make = [&](std::string const& path, hid_t stored, Shape shape, hsize_t in_chunk) {
    shape.insert(shape.begin(), 0);
    Shape most = shape, chunk = shape;
    most.front() = H5S_UNLIMITED;
    chunk.front() = in_chunk;
    auto const creation = without_times(H5P_DATASET_CREATE);
    H5Pset_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data());
    Handle const space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), most.data()),
                       H5Sclose);
    Handle set(H5Dcreate2(file_.get(), path.c_str(), stored, space.get(), H5P_DEFAULT,
                          creation.get(), H5P_DEFAULT),
               H5Dclose);
    require(set.valid(), file_);
    return set;
  };
  if (!step_.valid()) {
    step_ = make(at + "/step", H5T_STD_I64LE, {}, 1024);
    time_ = make(at + "/time", H5T_IEEE_F64LE, {}, 1024);
  } else {
    for (auto const* what : {"/step", "/time"})
      require(H5Lcreate_hard(file_.get(), fmt::format("{}/position{}", group, what).c_str(),
                             file_.get(), (at + what).c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
              file_);
  }
  return make(at + "/value", type, frame_shape, 1);
}

/// One frame behind the last of a dataset.
void H5mdFile::put(Handle const& set, hid_t type, void const* values) {
  Handle const old(H5Dget_space(set.get()), H5Sclose);
  Shape shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(old.get())));
  H5Sget_simple_extent_dims(old.get(), shape.data(), nullptr);
  shape.front() = frames_ + 1;
  require(H5Dset_extent(set.get(), shape.data()) >= 0, file_);
  Shape start(shape.size(), 0);
  start.front() = frames_;
  shape.front() = 1;
  Handle const there(H5Dget_space(set.get()), H5Sclose);
  H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
  Handle const here(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                    H5Sclose);
  require(H5Dwrite(set.get(), type, here.get(), there.get(), H5P_DEFAULT, values) >= 0, file_);
}

void H5mdFile::append(State const& state, std::int64_t step) {
  quiet_hdf5();
  double const length = state.box_length;
  // floor, not round: a tilt of half a box stays as it is when it is written again
  double const tilt = state.offset - length * std::floor(state.offset / length + 0.5);
  double const edges[9] = {length, 0, 0, tilt, state.box_height(), 0, 0, 0, 1};
  put(step_, H5T_NATIVE_INT64, &step);
  put(time_, H5T_NATIVE_DOUBLE, &state.time);
  put(edges_, H5T_NATIVE_DOUBLE, edges);
  put(position_, H5T_NATIVE_DOUBLE, with_third_axis(state.position).data());
  put(velocity_, H5T_NATIVE_DOUBLE, with_third_axis(state.velocity).data());
  if (spin_.valid()) put(spin_, H5T_NATIVE_DOUBLE, state.spin.data());
  ++frames_;
}

std::size_t H5mdFile::bytes() const {
  hsize_t size = 0;
  require(H5Fget_filesize(file_.get(), &size) >= 0, file_);
  return size;
}

Handle H5mdFile::close() {
  quiet_hdf5();
  for (Handle* set : {&step_, &time_, &edges_, &position_, &velocity_, &spin_})
    require(set->close(), file_);
  require(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0, file_);
  return std::move(file_);
}

namespace {

/// One frame of a dataset.
template <class T>
std::vector<T> take(Handle const& file, std::string const& path, hid_t type, hsize_t frame) {
  Handle const set(H5Dopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Dclose);
  Handle const space(H5Dget_space(set.get()), H5Sclose);
  Shape shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
  if (shape.empty()) throw FileError(fmt::format("{} cannot be read: {}", path, hdf5_reason()));
  H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  Shape start(shape.size(), 0);
  start.front() = frame;
  shape.front() = 1;
  hsize_t numbers = 1;
  for (auto const length : shape) numbers *= length;
  std::vector<T> values(numbers);
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
  Handle const here(H5Screate_simple(1, &numbers, nullptr), H5Sclose);
  if (H5Dread(set.get(), type, here.get(), space.get(), H5P_DEFAULT, values.data()) < 0)
    throw FileError(fmt::format("{} cannot be read: {}", path, hdf5_reason()));
  return values;
}

std::vector<std::array<double, 2>> without_third_axis(std::vector<double> const& rows) {
  std::vector<std::array<double, 2>> out;
  for (std::size_t k = 0; k < rows.size(); k += 3) out.push_back({rows[k], rows[k + 1]});
  return out;
}

}  // namespace

void for_each_frame(Handle const& file,
                    std::function<void(State const&, std::int64_t)> const& visit) {
  std::string const at = group;
  Handle const steps(H5Dopen2(file.get(), (at + "/position/step").c_str(), H5P_DEFAULT), H5Dclose);
  Handle const space(H5Dget_space(steps.get()), H5Sclose);
  hsize_t frames = 0;
  H5Sget_simple_extent_dims(space.get(), &frames, nullptr);
  bool const spins = H5Lexists(file.get(), (at + "/spin").c_str(), H5P_DEFAULT) > 0;
  for (hsize_t f = 0; f < frames; ++f) {
    auto const doubles = [&](char const* name) {
      return take<double>(file, at + name, H5T_NATIVE_DOUBLE, f);
    };
    State state;
    state.position = without_third_axis(doubles("/position/value"));
    state.velocity = without_third_axis(doubles("/velocity/value"));
    if (spins) state.spin = doubles("/spin/value");
    auto const edges = doubles("/box/edges/value");
    state.box_length = edges[0];
    state.box_aspect = edges[4] / edges[0];
    state.offset = edges[3];
    state.time = doubles("/position/time").front();
    visit(state, take<std::int64_t>(file, at + "/position/step", H5T_NATIVE_INT64, f).front());
  }
}

}  // namespace bagnold::io
