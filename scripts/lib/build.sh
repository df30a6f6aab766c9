# SPDX-License-Identifier: BSD-3-Clause
# Configure and build one preset. Needs common.sh, packages.sh and kokkos.sh.

# The first cmake that is new enough: the one in PATH, or the system's behind it.
find_cmake() {
  local candidate version
  for candidate in "$(command -v cmake || true)" /usr/bin/cmake; do
    [ -x "$candidate" ] || continue
    version="$("$candidate" --version | sed -n '1s/[^0-9]*//p')"
    if [ "$(printf '%s\n' 3.25 "$version" | sort -V | head -n 1)" = 3.25 ]; then
      cmake="$candidate"
      ctest="$(dirname "$candidate")/ctest"
      return 0
    fi
  done
  is_debian_12 || print_requirements
  die "CMake 3.25 or newer was not found"
}

# prepare PACKAGE... makes sure of the tools, the libraries and Kokkos.
prepare() {
  if is_debian_12; then
    install_packages "$@" || exit 1
  else
    say "Not Debian 12: building with what is installed"
    # shellcheck disable=SC2086 # CXX may be several words, such as "ccache g++"
    if ! have ${CXX:-c++}; then
      print_requirements
      die "no C++ compiler was found"
    fi
  fi
  find_cmake
  generator=()
  ! have ninja || generator=(-G Ninja)
  provide_kokkos
}

# A build folder made for another tree (a copy, a move), or by tools that are gone, is made anew.
drop_stale_build() {
  local folder="$1" cache="$1/CMakeCache.txt" home tool
  [ -f "$cache" ] || return 0
  home="$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")"
  if [ ! "$home" -ef "$root" ]; then
    say "${folder#"$root"/} was made for ${home:-an unknown tree}: making it anew"
    rm -rf "$folder"
    return 0
  fi
  while read -r tool; do
    [ -x "$tool" ] && continue
    say "${folder#"$root"/} was made with $tool, which is gone: making it anew"
    rm -rf "$folder"
    return 0
  done < <(sed -n 's/^CMAKE_\(MAKE_PROGRAM\|CXX_COMPILER\|COMMAND\):[A-Z]*=//p' "$cache")
}

# choose_generator FOLDER leaves in `fresh` what names the generator of a build folder: only of a new one may it
# be chosen.
choose_generator() {
  fresh=()
  [ -f "$1/CMakeCache.txt" ] || fresh=("${generator[@]}")
}

# configure PRESET ARGUMENT...
configure() {
  local preset="$1" folder="$root/build/$1"
  shift
  drop_stale_build "$folder"
  choose_generator "$folder"
  say "Configuring build/$preset"
  if ! (cd "$root" && "$cmake" --preset "$preset" "${fresh[@]}" "${kokkos_arguments[@]}" "$@" </dev/null); then
    is_debian_12 || print_requirements
    die "build/$preset could not be configured (see above)"
  fi
}

# configure_without_tests PRESET ARGUMENT...: the first time; tests need more packages than the program, and
# scripts/check turns them on.
configure_without_tests() {
  local first_time=()
  [ -f "$root/build/$1/CMakeCache.txt" ] || first_time=(-DBAGNOLD_TESTS=OFF -DBAGNOLD_BENCH=OFF)
  configure "$1" "${first_time[@]}" "${@:2}"
}

# build PRESET ARGUMENT...
build() {
  local preset="$1"
  shift
  say "Building build/$preset"
  (cd "$root" && "$cmake" --build --preset "$preset" --parallel "$(jobs_for_this_machine)" "$@" </dev/null) ||
    die "build/$preset could not be built (see above)"
}
