// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/vtkhdf.hpp"

#include <cstdint>
#include <limits>

#include "src/io/growing_dataset.hpp"
#include "src/io/hdf5_memory.hpp"

namespace bagnold::io {
namespace {

/// The group /VTKHDF of a new file (VTK's documentation: "VTK HDF file format").
class VtkHdf {
 public:
  VtkHdf(Handle const& file, std::string h5md) : file_(file), h5md_(std::move(h5md)) {}

  void group(std::string const& path) const {
    auto const creation = without_times(H5P_GROUP_CREATE);
    Handle made(H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                H5Gclose);
    require_written(made.valid() && made.close(), file_);
  }

  void attribute(std::string const& path, char const* name, hid_t type, Shape const& shape,
                 void const* values) const {
    Handle const at(H5Oopen(file_.get(), path.c_str(), H5P_DEFAULT), H5Oclose);
    auto const space = space_of(shape);
    Handle made(H5Acreate2(at.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require_written(made.valid() && H5Awrite(made.get(), type, values) >= 0 && made.close(), file_);
  }

  void numbers(std::string const& path, std::vector<std::int64_t> const& values,
               Shape const& shape) const {
    write(path, H5T_STD_I64LE, H5T_NATIVE_INT64, shape, values.data());
  }
  void numbers(std::string const& path, std::vector<double> const& values) const {
    write(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {values.size()}, values.data());
  }
  void numbers(std::string const& path, std::vector<std::uint8_t> const& values) const {
    write(path, H5T_STD_U8LE, H5T_NATIVE_UINT8, {values.size()}, values.data());
  }

  /// The values of a dataset of the H5MD file, in the same order but another shape; NaN (of
  /// integers 0) where that file is not there.
  void values_of(std::string const& source, Shape const& there, std::string const& path, hid_t type,
                 Shape const& here) const {
    auto const creation = without_times(H5P_DATASET_CREATE);
    double const none = std::numeric_limits<double>::quiet_NaN();
    if (H5Tget_class(type) == H5T_FLOAT)
      H5Pset_fill_value(creation.get(), H5T_NATIVE_DOUBLE, &none);
    auto const from = space_of(there), to = space_of(here);
    require_written(
        H5Pset_virtual(creation.get(), to.get(), h5md_.c_str(), source.c_str(), from.get()) >= 0,
        file_);
    Handle made(H5Dcreate2(file_.get(), path.c_str(), type, to.get(), H5P_DEFAULT, creation.get(),
                           H5P_DEFAULT),
                H5Dclose);
    require_written(made.valid() && made.close(), file_);
  }

 private:
  static Handle space_of(Shape const& shape) {
    return {shape.empty() ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
            H5Sclose};
  }

  void write(std::string const& path, hid_t stored, hid_t type, Shape const& shape,
             void const* values) const {
    auto const creation = without_times(H5P_DATASET_CREATE);
    auto const space = space_of(shape);
    Handle made(H5Dcreate2(file_.get(), path.c_str(), stored, space.get(), H5P_DEFAULT,
                           creation.get(), H5P_DEFAULT),
                H5Dclose);
    require_written(made.valid() &&
                        H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0 &&
                        made.close(),
                    file_);
  }

  Handle const& file_;
  std::string h5md_;
};

void describe_grid(VtkHdf const& out, std::int64_t count) {
  constexpr char type[] = "UnstructuredGrid";
  constexpr std::uint8_t vertex = 1;  // VTK_VERTEX
  Handle const text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.get(), sizeof type - 1);
  H5Tset_strpad(text.get(), H5T_STR_NULLPAD);
  std::int64_t const version[2] = {2, 0};
  out.group("/VTKHDF");
  out.attribute("/VTKHDF", "Version", H5T_NATIVE_INT64, {2}, version);
  out.attribute("/VTKHDF", "Type", text.get(), {}, type);
  for (auto const* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    out.numbers(std::string("/VTKHDF/") + name, {count}, {1});
  std::vector<std::int64_t> disks;
  for (std::int64_t i = 0; i < count; ++i) disks.push_back(i);
  out.numbers("/VTKHDF/Connectivity", disks, {disks.size()});
  disks.push_back(count);
  out.numbers("/VTKHDF/Offsets", disks, {disks.size()});
  out.numbers("/VTKHDF/Types", std::vector(static_cast<std::size_t>(count), vertex));
}

}  // namespace

std::vector<std::byte> vtkhdf_of(std::string const& h5md_name, std::size_t count,
                                 std::vector<double> const& time, bool spins) {
  auto const file = create_in_memory(std::size_t{1} << 16, /*virtual_datasets=*/true);
  VtkHdf const out(file, h5md_name);
  describe_grid(out, static_cast<std::int64_t>(count));
  hsize_t const frames = time.size(), disks = count;
  std::vector<std::int64_t> const same(frames, 0), one(frames, 1);
  std::vector<std::int64_t> moving;
  for (hsize_t f = 0; f < frames; ++f) moving.push_back(static_cast<std::int64_t>(f * disks));

  std::string const steps = "/VTKHDF/Steps";
  auto const frame_count = static_cast<std::int64_t>(frames);
  out.group(steps);
  out.attribute(steps, "NSteps", H5T_NATIVE_INT64, {}, &frame_count);
  out.numbers(steps + "/Values", time);
  out.numbers(steps + "/PartOffsets", same, {frames});
  out.numbers(steps + "/NumberOfParts", one, {frames});
  out.numbers(steps + "/PointOffsets", moving, {frames});
  for (auto const* name : {"/CellOffsets", "/ConnectivityIdOffsets"})
    out.numbers(steps + name, same, {frames, 1});

  std::string const trajectory = "/particles/trajectory/";
  out.group("/VTKHDF/PointData");
  out.group(steps + "/PointDataOffsets");
  out.values_of(trajectory + "position/value", {frames, disks, 3}, "/VTKHDF/Points", H5T_IEEE_F64LE,
                {frames * disks, 3});
  auto const element = [&](std::string const& name, Shape const& there, hid_t type,
                           Shape const& here) {
    bool const moves = there.size() > 1;
    out.values_of(trajectory + name + (moves ? "/value" : ""), there, "/VTKHDF/PointData/" + name,
                  type, here);
    out.numbers(steps + "/PointDataOffsets/" + name, moves ? moving : same, {frames});
  };
  element("velocity", {frames, disks, 3}, H5T_IEEE_F64LE, {frames * disks, 3});
  if (spins) element("spin", {frames, disks}, H5T_IEEE_F64LE, {frames * disks});
  element("diameter", {disks}, H5T_IEEE_F64LE, {disks});
  element("species", {disks}, H5T_STD_I32LE, {disks});
  auto const content = content_of(file);
  return {content.begin(), content.end()};
}

}  // namespace bagnold::io
