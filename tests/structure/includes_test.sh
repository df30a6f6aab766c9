#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# includes_test.sh ROOT: do includes in ROOT/kernels and ROOT/src point one way, are they written from
# the root, does a source include its own header first (which so is seen to compile alone), has every
# header its #pragma once, and do kernel labels carry their module? Prints what does not; exits 1 if
# anything does not.
set -euo pipefail
cd "$1"
export LC_ALL=C

# A folder, and the folders of this repository that it may include. Itself goes without saying.
allowed="
kernels/physics
kernels/device       kernels/physics
kernels/cpu          kernels/physics kernels/device
src/config           kernels/physics
src/statistics
src/state            src/config kernels/physics
src/engine           src/config src/state src/statistics kernels
src/measure          src/config src/state src/statistics src/engine src/io kernels
src/io               src/config src/state src/statistics
src/start            src/config src/state src/statistics src/engine src/io kernels
src/run              src/config src/state src/statistics src/engine src/start src/measure src/io kernels
src/sweep            src/config src/state src/start src/io src/run
src/analysis         src/config src/state src/statistics src/engine src/io src/run src/sweep
src/cli              src kernels
"
# A folder, and the libraries that it must not know. Kernels know Kokkos and the standard
# library, formulas only its macros.
forbidden="
kernels              hdf5|H5|toml|CLI|fmt/|nlohmann|Eigen|xxhash
kernels/physics      Kokkos_C|hdf5|H5|toml|CLI|fmt/|nlohmann|Eigen|xxhash
src/config           Kokkos|hdf5|H5
src/state            hdf5|H5|toml|CLI|nlohmann
src/statistics       Kokkos|hdf5|H5|toml|CLI|nlohmann
src/run              hdf5|H5|toml|CLI
src/cli              Kokkos|hdf5|H5|toml|Eigen
src/io               Kokkos
src/sweep            Kokkos
"
# The files of src/engine that see a scene. The others take an EngineInput, and a new key compiles none of
# them anew.
sees_scene="src/engine/engine_input.cpp src/engine/make_simulation.cpp src/engine/register_law.hpp"

mapfile -t files < <(find kernels src -type f \( -name '*.hpp' -o -name '*.cpp' \) | sort)

# shellcheck disable=SC2016 # the $ are awk's
awk -v allowed="$allowed" -v forbidden="$forbidden" -v sees_scene=" $sees_scene " '
  function complain(text) { print FILENAME ":" FNR ": " text; wrong = 1 }
  function inside(path, folder) { return index(path, folder "/") == 1 }
  BEGIN {
    rules = split(allowed, rule, "\n")
    bans = split(forbidden, ban, "\n")
    for (k = 1; k < ARGC; ++k) is_file[ARGV[k]] = 1
  }
  FNR == 1 {
    own = FILENAME; first_include = sub(/\.cpp$/, ".hpp", own) && own in is_file
    if (FILENAME ~ /\.hpp$/) headers[FILENAME] = 1
    match(FILENAME, /^[a-z]+\/[a-z_]+/)
    here = substr(FILENAME, RSTART, RLENGTH)
    module = FILENAME; sub(/\/[^\/]*$/, "", module); sub(/.*\//, "", module)
    friends = ""; known = 0
    for (r = 1; r <= rules; ++r) {
      split(rule[r], word, " ")
      if (word[1] == here) { friends = rule[r]; known = 1 }
    }
    if (!known) complain("folder " here " has no row in tests/structure/includes_test.sh")
    banned = ""
    for (b = 1; b <= bans; ++b) {
      split(ban[b], word, " ")
      if (word[1] != "" && inside(FILENAME, word[1])) banned = word[2]
    }
  }
  /^#pragma once$/ { once[FILENAME] = 1 }
  first_include && /^[ \t]*#[ \t]*include/ {
    if ($0 != "#include \"" own "\"") complain("does not include " own " first")
    first_include = 0
  }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, part, "\""); path = part[2]
    includes[FILENAME] = includes[FILENAME] " " path
    if (path ~ /^(git_version|[a-z_]+_script)\.hpp$/) next  # made by the build
    if (!(inside(path, "kernels") || inside(path, "src"))) {
      complain("\"" path "\" is not written from the root"); next
    }
    friend = 0
    count = split(friends, word, " ")
    for (w = 1; w <= count; ++w) if (inside(path, word[w])) friend = 1
    if (!friend) complain(here " must not include " path)
  }
  banned != "" && /^[ \t]*#[ \t]*include[ \t]*</ && $0 ~ ("<(" banned ")") {
    complain(here " must not use " $0)
  }
  here ~ /^kernels/ && /"[a-z_]+::[A-Za-z_: ]*"/ && index($0, "\"" module "::") == 0 {
    complain("the label does not start with its module, " module "::")
  }
  launch || /parallel_(for|reduce|scan)\(/ {  # the label is on this line or the next
    first = $0
    if (!launch) sub(/.*parallel_(for|reduce|scan)\(/, "", first)
    launch = first ~ /^[ \t]*$/
    if (!launch && first !~ /^[ \t]*("[a-z_]+::|label,|std::string const& label,|Kokkos::TeamThreadRange\()/) complain("a kernel needs a label, \"module::What\"")
  }
  # True if a file includes a scene, itself or through others.
  function reaches_scene(file,   list, n, k) {
    if (file in reaches) return reaches[file]
    reaches[file] = 0
    n = split(includes[file], list, " ")
    for (k = 1; k <= n && !reaches[file]; ++k)
      reaches[file] = list[k] == "src/config/scene.hpp" || reaches_scene(list[k])
    return reaches[file]
  }
  END {
    for (file in includes)
      if (inside(file, "src/engine") && !index(sees_scene, " " file " ") && reaches_scene(file)) {
        print file ": must not include src/config/scene.hpp, not through others either; take an EngineInput"
        wrong = 1
      }
    for (header in headers) if (!(header in once)) { print header ": no #pragma once"; wrong = 1 }
    exit wrong
  }' "${files[@]}"
