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

/// One frame of a time-dependent element, [count] or [count][3]: behind the path what to take of
/// the dataset, first:stride:count:shape. The hyperslabs of XDMF 2 crash ParaView's readers of
/// XDMF 3.
std::string one_frame(std::string const& file, char const* name, std::size_t frame,
                      std::size_t frames, std::size_t count, bool vector) {
  auto const with = [&](char const* third) { return vector ? third : ""; };
  return fmt::format(
      R"(<DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="{0}{1}">)"
      "{2}:/particles/trajectory/{3}/value|{4} 0{5}:1 1{6}:1 {0}{1}:{7} {0}{1}</DataItem>",
      count, with(" 3"), file, name, frame, with(" 0"), with(" 1"), frames);
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
    auto const item = [&](char const* name, bool vector) {
      return one_frame(file, name, f, time.size(), count, vector);
    };
    out +=
        fmt::format("  <Grid Name=\"disks\" GridType=\"Uniform\"><Time Value=\"{}\"/>\n", time[f]);
    out +=
        fmt::format("    <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n", count);
    out +=
        fmt::format("    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n", item("position", true));
    out += attribute("diameter", "Scalar",
                     whole(file, "diameter", R"(NumberType="Float" Precision="8")", count));
    out += attribute("species", "Scalar",
                     whole(file, "species", R"(NumberType="Int" Precision="4")", count));
    out += attribute("velocity", "Vector", item("velocity", true));
    if (spins) out += attribute("spin", "Scalar", item("spin", false));
    out += "  </Grid>\n";
  }
  return out + "</Grid>\n</Domain></Xdmf>\n";
}

}  // namespace bagnold::io
