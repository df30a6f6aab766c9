// SPDX-License-Identifier: BSD-3-Clause
//
// Damaged files, many a second: `damage checkpoint|state SECONDS SEED`. Each trial damages the
// bytes of a good file somehow and reads them: they must be refused in words, or hold what they
// held before. Prints the number of trials; what went wrong is told, and the exit code is 1. A
// crash is one.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "src/config/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/checkpoint.hpp"
#include "src/io/seal.hpp"
#include "src/io/state_file.hpp"
#include "tests/io/equal.hpp"
#include "tests/io/states.hpp"

namespace bagnold::io {

namespace {

using Bytes = std::vector<std::byte>;

/// One kind of damage at one place, of up to `most` bytes: disks and copies fail so.
class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string apply(Bytes& bytes) {
    static constexpr std::array<char const*, 8> names{"flips a bit",  "changes bytes", "zeros",
                                                      "ones",         "cut short",     "bytes lost",
                                                      "bytes put in", "a block moved"};
    auto const kind = below(names.size());
    auto const at = below(bytes.size()), many = 1 + below(1 << below(13));
    auto const begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    auto const end = begin + static_cast<std::ptrdiff_t>(std::min(many, bytes.size() - at));
    if (kind == 0) *begin ^= std::byte(1u << below(8));
    if (kind == 1) std::generate(begin, end, [&] { return std::byte(below(256)); });
    if (kind == 2) std::fill(begin, end, std::byte{0});
    if (kind == 3) std::fill(begin, end, std::byte{0xff});
    if (kind == 4) bytes.resize(at);
    if (kind == 5) bytes.erase(begin, end);
    if (kind == 6) bytes.insert(begin, many, std::byte(below(256)));
    if (kind == 7) std::rotate(bytes.begin(), begin, end);
    return std::string(names[kind]) + " at " + std::to_string(at) + ", " + std::to_string(many);
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  std::mt19937_64 random_;
};

/// A good file's bytes, and whether other bytes are read as the same or refused.
struct Subject {
  Bytes good;
  std::function<bool(Bytes)> same;
};

Subject checkpoint() {
  auto const original = some_checkpoint(16, 7);
  return {checkpoint_image(original), [original](Bytes bytes) {
            return same(parse_checkpoint("damaged", std::move(bytes)), original);
          }};
}

Subject state(std::filesystem::path const& folder) {
  auto const original = some_state(16);
  auto const file = folder / "state.h5";
  write_states(file, {original});
  return {read_file(file), [original, file](Bytes const& bytes) {
            std::ofstream(file, std::ios::binary)
                .write(reinterpret_cast<char const*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
            auto const states = read_states(file);
            return states.size() == 1 && same(states.front(), original);
          }};
}

int attack(Subject const& subject, double seconds, unsigned seed) {
  Damage damage(seed);
  auto const end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  long trials = 0, wrong = 0;
  for (; std::chrono::steady_clock::now() < end; ++trials) {
    Bytes bytes = subject.good;
    auto const what = damage.apply(bytes);
    if (!has_seal(bytes)) continue;  // as one made by hand, of which nothing but the form is known
    try {
      if (subject.same(std::move(bytes))) continue;
      std::printf("believed: %s\n", what.c_str());
      ++wrong;
    } catch (InputError const&) {
    } catch (FileError const&) {
    } catch (std::exception const& error) {
      std::printf("%s: %s\n", what.c_str(), error.what());
      ++wrong;
    }
  }
  std::printf("trials %ld\n", trials);
  return wrong == 0 ? 0 : 1;
}

}  // namespace

}  // namespace bagnold::io

int main(int count, char** words) {
  if (count != 4) return 2;
  std::string folder = (std::filesystem::current_path() / "damage-XXXXXX").string();
  if (!::mkdtemp(folder.data())) return 2;
  auto const subject =
      std::string(words[1]) == "state" ? bagnold::io::state(folder) : bagnold::io::checkpoint();
  int const code =
      bagnold::io::attack(subject, std::atof(words[2]), static_cast<unsigned>(std::atol(words[3])));
  std::filesystem::remove_all(folder);
  return code;
}
