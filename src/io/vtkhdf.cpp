// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/vtkhdf.hpp"

#include <cstdint>
#include <numeric>

#include "src/io/hdf5_memory.hpp"
#include "src/io/hdf5_writer.hpp"

namespace bagnold::io {
namespace {

/// The group /VTKHDF of a new file (VTK's documentation: "VTK HDF file format").
void describe_grid(Hdf5Writer& out, std::size_t count) {
  constexpr std::uint8_t vertex = 1;  // VTK_VERTEX
  out.group("/VTKHDF");
  out.attribute("/VTKHDF", "Version", std::vector<std::int64_t>{2, 0});
  out.letters("/VTKHDF", "Type", "UnstructuredGrid");
  std::vector<std::int64_t> disks(count);
  std::iota(disks.begin(), disks.end(), 0);
  for (auto const* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    out.dataset(std::string("/VTKHDF/") + name,
                std::vector<std::int64_t>{static_cast<std::int64_t>(count)}, {1});
  out.dataset("/VTKHDF/Connectivity", disks, {count});
  disks.push_back(static_cast<std::int64_t>(count));
  out.dataset("/VTKHDF/Offsets", disks, {disks.size()});
  out.dataset("/VTKHDF/Types", std::vector(count, vertex), {count});
}

}  // namespace

std::vector<std::byte> vtkhdf_of(std::string const& h5md_name, std::size_t count,
                                 std::vector<double> const& time, bool spins) {
  Hdf5Writer out(create_in_memory(std::size_t{1} << 16, /*virtual_datasets=*/true));
  describe_grid(out, count);
  hsize_t const frames = time.size(), disks = count;
  std::vector<std::int64_t> const same(frames, 0), one(frames, 1);
  std::vector<std::int64_t> moving;
  for (hsize_t f = 0; f < frames; ++f) moving.push_back(static_cast<std::int64_t>(f * disks));

  std::string const steps = "/VTKHDF/Steps";
  out.group(steps);
  out.attribute(steps, "NSteps", static_cast<std::int64_t>(frames));
  out.dataset(steps + "/Values", time, {frames});
  out.dataset(steps + "/PartOffsets", same, {frames});
  out.dataset(steps + "/NumberOfParts", one, {frames});
  out.dataset(steps + "/PointOffsets", moving, {frames});
  for (auto const* name : {"/CellOffsets", "/ConnectivityIdOffsets"})
    out.dataset(steps + name, same, {frames, 1});

  std::string const trajectory = "/particles/trajectory/";
  out.group("/VTKHDF/PointData");
  out.group(steps + "/PointDataOffsets");
  out.virtual_dataset("/VTKHDF/Points", H5T_IEEE_F64LE, {frames * disks, 3},
                      {h5md_name, trajectory + "position/value", {frames, disks, 3}});
  auto const element = [&](std::string const& name, Shape const& there, hid_t type,
                           Shape const& here) {
    bool const moves = there.size() > 1;
    out.virtual_dataset("/VTKHDF/PointData/" + name, type, here,
                        {h5md_name, trajectory + name + (moves ? "/value" : ""), there});
    out.dataset(steps + "/PointDataOffsets/" + name, moves ? moving : same, {frames});
  };
  element("velocity", {frames, disks, 3}, H5T_IEEE_F64LE, {frames * disks, 3});
  if (spins) element("spin", {frames, disks}, H5T_IEEE_F64LE, {frames * disks});
  element("diameter", {disks}, H5T_IEEE_F64LE, {disks});
  element("species", {disks}, H5T_STD_I32LE, {disks});
  auto const content = out.content();
  return {content.begin(), content.end()};
}

}  // namespace bagnold::io
