// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/state_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"

namespace bagnold::io {
namespace {

/// Refuses values that no state can have.
class StateCheck {
 public:
  explicit StateCheck(std::string file) : file_(std::move(file)) {}

  void operator()(State const& state) const {
    if (state.count() < 2)
      fail("number of disks", static_cast<double>(state.count()), "at least 2");
    one("/state@box_length", state.box_length, above_zero);
    one("/state@offset", state.offset, finite);
    one("/state@time", state.time, finite);
    if (state.strain_rate) one("/state@strain_rate", *state.strain_rate, finite);
    each("/state/position", flat(state.position), 2, finite);
    each("/state/velocity", flat(state.velocity), 2, finite);
    each("/state/spin", state.spin, 1, finite);
    each("/state/diameter", state.diameter, 1, above_zero);
  }

 private:
  static constexpr std::string_view finite = "a finite number";
  static constexpr std::string_view above_zero = "finite and above 0, in units of d_s";

  static bool good(double value, std::string_view rule) {
    return std::isfinite(value) && (rule != above_zero || value > 0.0);
  }
  void one(std::string_view what, double value, std::string_view rule) const {
    if (!good(value, rule)) fail(what, value, rule);
  }
  void each(std::string_view what, std::span<double const> values, std::size_t width,
            std::string_view rule) const {
    for (std::size_t index = 0; index < values.size(); ++index)
      if (!good(values[index], rule))
        fail(fmt::format("{}, disk {} (from 0)", what, index / width), values[index], rule);
  }
  [[noreturn]] void fail(std::string_view what, double value, std::string_view rule) const {
    throw InputError(fmt::format("{}: {} = {} (must be {}); correct the file or make it again",
                                 file_, what, value, rule));
  }

  std::string file_;
};

}  // namespace

void put_state(Hdf5Writer& file, State const& state) {
  hsize_t const count = state.count();
  file.group("/state");
  file.dataset("/state/position", flat(state.position), {count, 2}, {{"unit", "d_s"}});
  file.dataset("/state/velocity", flat(state.velocity), {count, 2},
               {{"unit", "d_s/tau_e"}, {"frame", "laboratory"}});
  if (!state.spin.empty()) file.dataset("/state/spin", state.spin, {count}, {{"unit", "1/tau_e"}});
  file.dataset("/state/diameter", state.diameter, {count}, {{"unit", "d_s"}});
  file.attribute("/state", "box_length", state.box_length);
  file.attribute("/state", "offset", state.offset);
  file.attribute("/state", "time", state.time);
  if (state.strain_rate) file.attribute("/state", "strain_rate", *state.strain_rate);
}

State get_state(Hdf5Reader const& file, std::optional<std::size_t> expected_count) {
  auto const shape = file.shape("/state/position");
  hsize_t const count = expected_count.value_or(shape.empty() ? 0 : shape.front());
  State state;
  state.position = file.pairs("/state/position", count);
  state.velocity = file.pairs("/state/velocity", count);
  if (file.has("/state/spin")) state.spin = file.doubles("/state/spin", {count});
  state.diameter = file.doubles("/state/diameter", {count});
  state.box_length = file.number("/state", "box_length");
  state.offset = file.number("/state", "offset");
  state.time = file.number("/state", "time");
  if (file.has_attribute("/state", "strain_rate"))
    state.strain_rate = file.number("/state", "strain_rate");
  return state;
}

State read_state(std::filesystem::path const& path, std::optional<std::size_t> expected_count) {
  std::error_code reason;
  auto const kind = std::filesystem::status(path, reason).type();
  // none: nothing is known, for want of permission; read_file then says so
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::none)
    throw InputError(fmt::format(
        "state file {} {}; check start.file", path.string(),
        kind == std::filesystem::file_type::not_found ? "is not there" : "is not a file"));
  auto state = get_state(Hdf5Reader(path.string(), read_file(path)), expected_count);
  StateCheck{path.string()}(state);
  return state;
}

void write_state(std::filesystem::path const& path, State const& state) {
  Hdf5Writer file;
  put_state(file, state);
  replace_file(path, file.image());
}

}  // namespace bagnold::io
