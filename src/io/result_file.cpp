// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/result_file.hpp"

#include "src/io/atomic_file.hpp"

namespace bagnold::io {

void write_result(std::filesystem::path const& path, Result const& result) {
  Hdf5Writer file;
  for (auto const& [name, value] : result.attributes) file.attribute("/", name, value);
  file.group("/series");
  file.attribute("/series", "discarded_windows", result.discarded_windows);
  for (auto const& series : result.series) {
    Shape shape{series.value.size() / result.replicas};
    if (result.replicas > 1) shape.insert(shape.begin(), result.replicas);
    file.dataset("/series/" + series.name, series.value, shape,
                 {{"unit", series.unit}, {"description", series.description}});
  }
  replace_file(path, file.image());
}

}  // namespace bagnold::io
