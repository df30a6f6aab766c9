// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/state_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/run_apart.hpp"
#include "src/io/seal.hpp"

namespace bagnold::io {
namespace {

/// Refuses values that no state can have.
class StateCheck {
 public:
  explicit StateCheck(std::string file) : file_(std::move(file)) {}

  void operator()(State const& state) const {
    one("/state@box_length", state.box_length, above_zero);
    one("/state@box_aspect", state.box_aspect, positive);
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
  static constexpr std::string_view positive = "finite and above 0";
  static constexpr std::string_view above_zero = "finite and above 0, in units of d_s";

  static bool good(double value, std::string_view rule) {
    return std::isfinite(value) && (rule == finite || value > 0.0);
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

namespace {

/// One field of all states, end to end, taken out of them.
template <class Row>
std::vector<Row> taken(std::span<State> states, std::vector<Row> State::*field) {
  if (states.size() == 1) return std::exchange(states.front().*field, {});
  std::vector<Row> all;
  all.reserve(states.size() * (states.front().*field).size());
  for (State& state : states) {
    auto const of_state = std::exchange(state.*field, {});
    all.insert(all.end(), of_state.begin(), of_state.end());
  }
  return all;
}

/// The inverse. A single state takes the values as they are, without a copy.
template <class Row>
void deal_out(std::vector<Row> values, std::span<State> states, std::vector<Row> State::*field) {
  if (states.size() == 1) {
    states.front().*field = std::move(values);
    return;
  }
  auto begin = values.begin();
  for (State& state : states) {
    auto const end = begin + static_cast<std::ptrdiff_t>(values.size() / states.size());
    (state.*field).assign(begin, end);
    begin = end;
  }
}

/// True if two states agree in what states in one file share.
bool are_alike(State const& a, State const& b) {
  return a.box_aspect == b.box_aspect && a.time == b.time &&
         a.strain_rate.has_value() == b.strain_rate.has_value() && a.count() == b.count() &&
         a.spin.size() == b.spin.size();
}

/// Box and strain of states that a controller leads apart; a state's own.
struct OwnNumber {
  char const* name;
  double (*get)(State const&);
  void (*put)(State&, double);
};
constexpr OwnNumber own_numbers[] = {
    {"box_length", [](State const& s) { return s.box_length; },
     [](State& s, double value) { s.box_length = value; }},
    {"offset", [](State const& s) { return s.offset; },
     [](State& s, double value) { s.offset = value; }},
    {"strain_rate", [](State const& s) { return s.strain_rate.value_or(0); },
     [](State& s, double value) { s.strain_rate = value; }}};

/// Writes a row of R where they differ. The attributes of the group are those of the first state.
void put_own_numbers(Hdf5Writer& file, std::span<State const> states, std::string const& group) {
  for (auto const& [name, get, put] : own_numbers) {
    std::vector<double> row;
    for (State const& state : states) row.push_back(get(state));
    if (std::ranges::count(row, row.front()) == std::ssize(row)) continue;
    file.dataset(group + "/" + name, row, {row.size()});
  }
}

}  // namespace

void put_states(Hdf5Writer& file, std::vector<State> states, std::string const& at) {
  for (State const& state : std::span(states).subspan(1))
    if (!are_alike(state, states.front()))
      throw std::logic_error("states of one file must have aspect, time and spins in common");
  Shape shape{states.front().count()};  // [N], or [R][N]
  if (states.size() > 1) shape.insert(shape.begin(), states.size());
  auto rows = shape;
  rows.push_back(2);
  auto const group = at + "/state";
  file.group(group);
  put_own_numbers(file, states, group);
  bool const spins = !states.front().spin.empty();
  file.dataset(group + "/position", flat(taken(states, &State::position)), rows, {{"unit", "d_s"}});
  file.dataset(group + "/velocity", flat(taken(states, &State::velocity)), rows,
               {{"unit", "d_s/tau_e"}, {"frame", "laboratory"}});
  if (spins)
    file.dataset(group + "/spin", taken(states, &State::spin), shape, {{"unit", "1/tau_e"}});
  file.dataset(group + "/diameter", taken(states, &State::diameter), shape, {{"unit", "d_s"}});
  State const& state = states.front();
  file.attribute(group, "box_length", state.box_length);
  if (state.box_aspect != 1) file.attribute(group, "box_aspect", state.box_aspect);
  file.attribute(group, "offset", state.offset);
  file.attribute(group, "time", state.time);
  if (state.strain_rate) file.attribute(group, "strain_rate", *state.strain_rate);
}

std::vector<State> get_states(Hdf5Reader const& file, std::string const& at,
                              std::optional<std::size_t> expected_count) {
  auto const group = at + "/state";
  auto shape = file.shape(group + "/position");
  if (shape.size() == 3)
    shape.pop_back();
  else
    shape = {shape.empty() ? 0 : shape.front()};
  if (expected_count) shape.back() = *expected_count;
  auto position = file.pairs(group + "/position", shape);
  if (shape.back() < 2)  // before anything is done R times
    throw InputError(fmt::format(
        "{}: number of disks = {} (must be at least 2); correct the file or make it again",
        file.name(), shape.back()));
  State common;
  common.box_length = file.number(group, "box_length");
  if (file.has_attribute(group, "box_aspect")) common.box_aspect = file.number(group, "box_aspect");
  common.offset = file.number(group, "offset");
  common.time = file.number(group, "time");
  if (file.has_attribute(group, "strain_rate"))
    common.strain_rate = file.number(group, "strain_rate");
  std::vector<State> states(position.size() / shape.back(), common);
  for (auto const& own : own_numbers)
    if (auto const place = group + "/" + own.name; file.has(place)) {
      auto const row = file.doubles(place, {states.size()});
      for (std::size_t r = 0; r < states.size(); ++r) own.put(states[r], row[r]);
    }
  deal_out(std::move(position), states, &State::position);
  deal_out(file.pairs(group + "/velocity", shape), states, &State::velocity);
  if (file.has(group + "/spin"))
    deal_out(file.doubles(group + "/spin", shape), states, &State::spin);
  deal_out(file.doubles(group + "/diameter", shape), states, &State::diameter);
  return states;
}

namespace {

/// At least one.
std::vector<State> states_in(std::string const& name, std::vector<std::byte> image,
                             std::optional<std::size_t> expected_count) {
  auto states = get_states(Hdf5Reader(name, std::move(image)), "", expected_count);
  if (states.empty())
    throw InputError(
        fmt::format("{}: /state/position holds no state (must hold at least one); make "
                    "the file again",
                    name));
  return states;
}

std::vector<State> sealed_states(std::string const& name, std::vector<std::byte>& image,
                                 std::optional<std::size_t> expected_count) {
  if (auto const reason = remove_seal(image); !reason.empty())
    throw InputError(fmt::format("{} {}; make it again", name, reason));
  return states_in(name, std::move(image), expected_count);
}

/// First word of a child's answer: states follow, written anew, or a refusal.
enum class Answer : std::uint8_t { states, refusal };

std::vector<std::byte> answer(Answer kind, std::span<std::byte const> content) {
  std::vector<std::byte> all(1 + content.size(), static_cast<std::byte>(kind));
  std::ranges::copy(content, all.begin() + 1);
  return all;
}

constexpr unsigned patience = 600;  ///< with a file that keeps HDF5 busy, [s]

/// A file that we did not write, or that was changed since.
std::vector<State> foreign_states(std::string const& name, std::vector<std::byte>& image,
                                  std::optional<std::size_t> expected_count) {
  auto answered = run_apart([&] {
    ::alarm(patience);
    try {
      Hdf5Writer anew;
      put_states(anew, states_in(name, std::move(image), expected_count));
      return answer(Answer::states, anew.content());
    } catch (InputError const& error) {
      return answer(Answer::refusal, std::as_bytes(std::span(std::string_view(error.what()))));
    }
  });
  if (!answered || answered->empty())
    throw InputError(
        fmt::format("{}: HDF5 crashes on it: the file is damaged; make it again", name));
  auto const kind = static_cast<Answer>(answered->front());
  answered->erase(answered->begin());
  if (kind == Answer::refusal)
    throw InputError(
        std::string(reinterpret_cast<char const*>(answered->data()), answered->size()));
  return states_in(name, *std::move(answered), expected_count);
}

}  // namespace

std::vector<State> read_states(std::filesystem::path const& path,
                               std::optional<std::size_t> expected_count) {
  std::error_code reason;
  auto const kind = std::filesystem::status(path, reason).type();
  // none: nothing is known, for want of permission; read_file then says so
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::none)
    throw InputError(fmt::format(
        "state file {} {}; check start.file", path.string(),
        kind == std::filesystem::file_type::not_found ? "is not there" : "is not a file"));
  auto image = read_file(path);
  auto const states = has_seal(image) ? sealed_states(path.string(), image, expected_count)
                                      : foreign_states(path.string(), image, expected_count);
  for (State const& state : states) StateCheck{path.string()}(state);
  return states;
}

void write_states(std::filesystem::path const& path, std::vector<State> states) {
  Hdf5Writer file;
  put_states(file, std::move(states));
  replace_sealed(path, file.content());
}

}  // namespace bagnold::io
