// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/h5md_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/config/errors.hpp"
#include "src/io/growing_dataset.hpp"

namespace bagnold::io {
namespace {

constexpr char const* group = "/particles/trajectory";
constexpr char const* scalars = "/observables/trajectory";

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length);
  return type;
}

void attribute(Handle const& at, char const* name, hid_t type, Handle const& space,
               void const* value) {
  Handle made(H5Acreate2(at.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require_written(made.valid() && H5Awrite(made.get(), type, value) >= 0 && made.close(), at);
}

void write_words(Handle const& at, char const* name, std::string const& value) {
  auto const type = text_type(value.size() + 1);
  attribute(at, name, type.get(), Handle(H5Screate(H5S_SCALAR), H5Sclose), value.c_str());
}

Handle make_group(Handle const& file, char const* path) {
  auto const creation = without_times(H5P_GROUP_CREATE);
  Handle made(H5Gcreate2(file.get(), path, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
  require_written(made.valid(), file);
  return made;
}

void fixed(Handle const& file, std::string const& path, hid_t stored, hid_t type, hsize_t count,
           void const* values) {
  auto const creation = without_times(H5P_DATASET_CREATE);
  Handle const space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  Handle set(H5Dcreate2(file.get(), path.c_str(), stored, space.get(), H5P_DEFAULT, creation.get(),
                        H5P_DEFAULT),
             H5Dclose);
  require_written(set.valid() &&
                      H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0 &&
                      set.close(),
                  file);
}

/// No unit attributes: reduced units have none in H5MD, and readers refuse those they do not know.
void describe(Handle const& file, std::string const& version, std::string const& scene) {
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
  if (!scene.empty()) write_words(parameters, "scene", scene);
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
      spin_(-1, H5Dclose),
      image_(-1, H5Dclose),
      strain_(-1, H5Dclose),
      rate_(-1, H5Dclose),
      offset_(-1, H5Dclose) {
  describe(file_, header.version, header.numbers ? header.scene : "");
  make_group(file_, "/particles");
  make_group(file_, group);
  describe_box(file_);
  std::string const at = std::string(group) + "/";
  std::vector<std::int32_t> species;
  for (double const d : header.diameter) species.push_back(d > 1.2 ? 1 : 0);
  fixed(file_, at + "species", H5T_STD_I32LE, H5T_NATIVE_INT32, count_, species.data());
  fixed(file_, at + "diameter", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, count_, header.diameter.data());
  fixed(file_, at + "mass", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, count_, header.mass.data());
  position_ = series(at + "position", H5T_IEEE_F64LE, {count_, 3});
  velocity_ = series(at + "velocity", H5T_IEEE_F64LE, {count_, 3});
  edges_ = series(at + "box/edges", H5T_IEEE_F64LE, {3, 3});
  if (header.spins) spin_ = series(at + "spin", H5T_IEEE_F64LE, {count_});
  if (header.contacts) contacts_.emplace(file_, 2 * count_);
  if (!header.numbers) return;
  image_ = series(at + "image", H5T_STD_I32LE, {count_, 3});
  make_group(file_, "/observables");
  make_group(file_, scalars);
  auto const scalar = [&](char const* name) {
    return series(fmt::format("{}/{}", scalars, name), H5T_IEEE_F64LE, {});
  };
  strain_ = scalar("strain");
  rate_ = scalar("strain_rate");
  offset_ = scalar("offset");
}

H5mdFile::~H5mdFile() {
  quiet_hdf5();  // the members are closed on this thread
}

/// A time-dependent element: `value`, and `step` and `time`, which all elements share.
Handle H5mdFile::series(std::string const& at, hid_t type, Shape const& frame_shape) {
  make_group(file_, at.c_str());
  if (!step_.valid()) {
    step_ = make_growing(file_, at + "/step", H5T_STD_I64LE, {}, 1024);
    time_ = make_growing(file_, at + "/time", H5T_IEEE_F64LE, {}, 1024);
  } else {
    for (auto const* what : {"/step", "/time"})
      require_written(
          H5Lcreate_hard(file_.get(), fmt::format("{}/position{}", group, what).c_str(),
                         file_.get(), (at + what).c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
          file_);
  }
  return make_growing(file_, at + "/value", type, frame_shape, frame_shape.empty() ? 1024 : 1);
}

double tilt_of(State const& state) {
  return state.offset - state.box_length * std::floor(state.offset / state.box_length + 0.5);
}

void H5mdFile::append(State const& state, FrameNumbers const& numbers) {
  quiet_hdf5();
  double const edges[9] = {state.box_length, 0, 0, tilt_of(state), state.box_height(), 0, 0, 0, 1};
  append_rows(step_, H5T_NATIVE_INT64, &numbers.step, 1);
  append_rows(time_, H5T_NATIVE_DOUBLE, &state.time, 1);
  append_rows(edges_, H5T_NATIVE_DOUBLE, edges, 1);
  append_rows(position_, H5T_NATIVE_DOUBLE, with_third_axis(state.position).data(), 1);
  append_rows(velocity_, H5T_NATIVE_DOUBLE, with_third_axis(state.velocity).data(), 1);
  if (spin_.valid()) append_rows(spin_, H5T_NATIVE_DOUBLE, state.spin.data(), 1);
  if (image_.valid()) {
    std::vector<std::int32_t> images(3 * count_, 0);
    for (std::size_t i = 0; i < numbers.images.size(); ++i) {
      images[3 * i] = numbers.images[i][0];
      images[3 * i + 1] = numbers.images[i][1];
    }
    append_rows(image_, H5T_NATIVE_INT32, images.data(), 1);
    double const rate = state.strain_rate.value_or(std::numeric_limits<double>::quiet_NaN());
    append_rows(strain_, H5T_NATIVE_DOUBLE, &numbers.strain, 1);
    append_rows(rate_, H5T_NATIVE_DOUBLE, &rate, 1);
    append_rows(offset_, H5T_NATIVE_DOUBLE, &state.offset, 1);
  }
  if (contacts_) contacts_->append(numbers.contacts);
}

std::size_t H5mdFile::bytes() const {
  hsize_t size = 0;
  require_written(H5Fget_filesize(file_.get(), &size) >= 0, file_);
  return size;
}

Handle H5mdFile::close() {
  quiet_hdf5();
  for (Handle* set : {&step_, &time_, &edges_, &position_, &velocity_, &spin_, &image_, &strain_,
                      &rate_, &offset_})
    require_written(set->close(), file_);
  if (contacts_) contacts_->close();
  require_written(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0, file_);
  return std::move(file_);
}

namespace {

std::vector<std::array<double, 2>> without_third_axis(std::vector<double> const& rows) {
  std::vector<std::array<double, 2>> out;
  for (std::size_t k = 0; k < rows.size(); k += 3) out.push_back({rows[k], rows[k + 1]});
  return out;
}

Images images_in(std::vector<std::int32_t> const& rows) {
  Images out;
  for (std::size_t k = 0; k < rows.size(); k += 3) out.push_back({rows[k], rows[k + 1]});
  return out;
}

/// Reads the numbers of a frame, and sets those that are part of its state.
FrameNumbers numbers_of(Handle const& file, hsize_t frame, State& state) {
  auto const scalar = [&](char const* name) {
    return read_rows<double>(file, fmt::format("{}/{}/value", scalars, name), H5T_NATIVE_DOUBLE,
                             frame, 1)
        .front();
  };
  state.offset = scalar("offset");
  if (double const rate = scalar("strain_rate"); !std::isnan(rate)) state.strain_rate = rate;
  auto const at = fmt::format("{}/image/value", group);
  return {0, scalar("strain"),
          images_in(read_rows<std::int32_t>(file, at, H5T_NATIVE_INT32, frame, 1))};
}

}  // namespace

bool has_numbers(Handle const& file) {
  return H5Lexists(file.get(), fmt::format("{}/image", group).c_str(), H5P_DEFAULT) > 0;
}

void for_each_frame(Handle const& file,
                    std::function<void(State const&, FrameNumbers const&)> const& visit) {
  std::string const at = group;
  auto const frames = rows_in(file, at + "/position/step");
  H5mdContactsReader contacts(file);
  bool const in_contact = has_contacts(file);
  bool const spins = H5Lexists(file.get(), (at + "/spin").c_str(), H5P_DEFAULT) > 0;
  for (hsize_t f = 0; f < frames; ++f) {
    auto const doubles = [&](char const* name) {
      return read_rows<double>(file, at + name, H5T_NATIVE_DOUBLE, f, 1);
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
    FrameNumbers numbers;
    if (has_numbers(file)) numbers = numbers_of(file, f, state);
    numbers.step =
        read_rows<std::int64_t>(file, at + "/position/step", H5T_NATIVE_INT64, f, 1).front();
    if (in_contact) numbers.contacts = contacts.next();
    visit(state, numbers);
  }
}

}  // namespace bagnold::io
