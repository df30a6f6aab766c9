// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/xdmf.hpp"

#include <fmt/format.h>

namespace bagnold::io {
namespace {

/// A dataset of the trajectory that is the same in every frame.
std::string whole(std::string const& file, char const* name, char const* type, std::size_t count) {
  return fmt::format(
      R"(<DataItem Format="HDF" {} Dimensions="{}">{}:/particles/trajectory/{}</DataItem>)", type,
      count, file, name);
}

/// One frame of a time-dependent element of `width` numbers a disk.
std::string one_frame(std::string const& file, char const* name, std::size_t frame,
                      std::size_t frames, std::size_t count, int width) {
  bool const row = width > 1;
  auto const third = row ? fmt::format(" {}", width) : "";
  return fmt::format(
      R"(<DataItem ItemType="HyperSlab" Dimensions="1 {1}{2}"><DataItem Dimensions="3 {3}" Format="XML">{4} 0{5} 1 1{6} 1 {1}{2}</DataItem><DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="{7} {1}{2}">{0}:/particles/trajectory/{8}/value</DataItem></DataItem>)",
      file, count, third, row ? 3 : 2, frame, row ? " 0" : "", row ? " 1" : "", frames, name);
}

std::string attribute(char const* name, char const* kind, std::string const& item) {
  return fmt::format(
      "    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n", name,
      kind, item);
}

}  // namespace

std::string xdmf_of(std::string const& file, std::size_t count, std::vector<double> const& time,
                    bool spins) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>\n"
      "<Grid Name=\"trajectory\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t f = 0; f < time.size(); ++f) {
    auto const item = [&](char const* name, int width) {
      return one_frame(file, name, f, time.size(), count, width);
    };
    out +=
        fmt::format("  <Grid Name=\"disks\" GridType=\"Uniform\"><Time Value=\"{}\"/>\n", time[f]);
    out +=
        fmt::format("    <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n", count);
    out += fmt::format("    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n", item("position", 3));
    out += attribute("diameter", "Scalar",
                     whole(file, "diameter", R"(NumberType="Float" Precision="8")", count));
    out += attribute("species", "Scalar",
                     whole(file, "species", R"(NumberType="Int" Precision="4")", count));
    out += attribute("velocity", "Vector", item("velocity", 3));
    if (spins) out += attribute("spin", "Scalar", item("spin", 1));
    out += "  </Grid>\n";
  }
  return out + "</Grid>\n</Domain></Xdmf>\n";
}

}  // namespace bagnold::io
