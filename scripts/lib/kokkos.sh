# SPDX-License-Identifier: BSD-3-Clause
# Kokkos: what CMake finds is used as it is; otherwise Debian's source package is built, with the Serial
# and OpenMP backends, into $BAGNOLD_CACHE. Debian's own binary has no OpenMP.

kokkos_version=3.4.01
kokkos_recipe=1 # count up when the flags below change

# kokkos_prefix [MACHINE]: where it is kept, for this kind of machine if none is named.
kokkos_prefix() {
  local compiler # in the name, so that a new compiler gets a new build
  compiler="$(${CXX:-c++} -dumpfullversion 2>/dev/null || ${CXX:-c++} -dumpversion)"
  echo "$BAGNOLD_CACHE/kokkos-$kokkos_version-${1:-$(uname -m)}-$compiler-r$kokkos_recipe"
}

# Does CMake find a Kokkos that will do? Asked of the same file that the real build includes.
kokkos_is_found() {
  make_scratch
  rm -rf "$scratch/probe"
  mkdir "$scratch/probe"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(probe CXX)' \
    "include([[$root/cmake/kokkos.cmake]])" >"$scratch/probe/CMakeLists.txt"
  "$cmake" -S "$scratch/probe" -B "$scratch/probe/build" "${generator[@]}" \
    >"$scratch/probe/log" 2>&1 </dev/null || return 1
  sed -n 's/^-- Kokkos /== Kokkos: found /p' "$scratch/probe/log"
}

# The machine's apt sources, asking for sources instead of binaries, as $1/sources.list.d. Both forms
# (.list and .sources) keep all else: mirrors, suites, keys. Installation disks are left out.
write_source_lists() {
  local list parts file number=0 to="$1/sources.list.d"
  mkdir -p "$to"
  eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
  for file in "$list" "${parts%/}"/*.list; do
    [ -f "$file" ] || continue
    number=$((number + 1))
    sed -n -e '/cdrom:/d' -e 's/^[[:space:]]*deb\(-src\)\{0,1\}[[:space:]]/deb-src /p' "$file" |
      awk '!seen[$0]++' >"$to/$number.list"
  done
  for file in "${parts%/}"/*.sources; do
    [ -f "$file" ] || continue
    number=$((number + 1))
    sed -e 's/^types:.*/Types: deb-src/I' "$file" >"$to/$number.sources"
  done
}

# apt-get with these lists, in folders of its own: the machine's apt state stays as it is.
private_apt_get() {
  local here="$scratch/apt"
  mkdir -p "$here/lists/partial" "$here/cache/archives/partial"
  apt-get -q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$here/sources.list.d" \
    -o Dir::State::lists="$here/lists" -o Dir::Cache="$here/cache" -o Acquire::Languages=none \
    -o Acquire::Retries=3 "$@"
}

# Debian's source package is trilinos; apt checks the signatures and sums. Leaves $scratch/kokkos.
fetch_kokkos() {
  make_scratch
  write_source_lists "$scratch/apt"
  quietly private_apt_get update || warn "not every apt source could be read; going on"
  (
    cd "$scratch/apt"
    # From the release named here, where newer ones are configured beside it.
    quietly private_apt_get source --download-only trilinos/bookworm
  ) || die "Debian's source package trilinos could not be downloaded (see above). An installed Kokkos does as
       well: set Kokkos_ROOT to its prefix."
  mkdir "$scratch/kokkos"
  tar -xf "$scratch"/apt/trilinos_*.orig.tar.gz -C "$scratch/kokkos" --strip-components=3 \
    --wildcards '*/packages/kokkos'
  rm "$scratch"/apt/trilinos_*
}

# build_kokkos PREFIX ARGUMENT...: into PREFIX, configured with these too.
build_kokkos() {
  local prefix="$1"
  shift
  say "Kokkos: building it with Serial and OpenMP (half a minute or so)"
  # Installed to one side, then renamed: what stands at $prefix is always whole.
  stage="$(mktemp -d "$BAGNOLD_CACHE/.stage.XXXXXX")"
  quietly "$cmake" -S "$scratch/kokkos" -B "$scratch/kokkos-build" "${generator[@]}" -Wno-dev \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_STANDARD=17 -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib \
    -DKokkos_ENABLE_SERIAL=ON -DKokkos_ENABLE_OPENMP=ON -DKokkos_ENABLE_TESTS=OFF "$@" \
    || die "Kokkos could not be configured (see above)"
  quietly "$cmake" --build "$scratch/kokkos-build" --parallel "$(jobs_for_this_machine)" \
    || die "Kokkos could not be built (see above)"
  DESTDIR="$stage" quietly "$cmake" --install "$scratch/kokkos-build" \
    || die "Kokkos could not be installed to $prefix (see above)"
  # Another script may have been faster: then its result stands.
  mv -T "$stage$prefix" "$prefix" 2>/dev/null || [ -d "$prefix/lib/cmake/Kokkos" ] ||
    die "Kokkos could not be moved to $prefix"
  rm -rf "$stage"
  say "Kokkos: $kokkos_version is in $prefix"
}

# Leaves in kokkos_arguments what the configure step needs beyond what CMake finds by itself.
provide_kokkos() {
  kokkos_arguments=()
  # One that the user names counts, not the one that an earlier build found.
  if [ -n "${Kokkos_ROOT:-}" ]; then
    [ -n "$(find -L "$Kokkos_ROOT" -maxdepth 6 -name KokkosConfig.cmake -print -quit 2>/dev/null)" ] ||
      die "there is no Kokkos in Kokkos_ROOT=$Kokkos_ROOT (no KokkosConfig.cmake)"
    kokkos_arguments=(-UKokkos_DIR)
  fi
  set_cache
  kokkos_is_found && return 0
  if [ -n "${Kokkos_ROOT:-}" ]; then
    sed -n '/^CMake Error/,/^Call Stack/{/^Call Stack/!p}' "$scratch/probe/log" >&2
    die "the Kokkos in Kokkos_ROOT=$Kokkos_ROOT will not do"
  fi
  is_debian_12 || return 0 # the configure step will say what is missing
  local prefix
  prefix="$(kokkos_prefix)"
  if [ ! -d "$prefix" ]; then
    say "Kokkos: CMake finds none; fetching Debian's source package (166 MB)"
    fetch_kokkos
    build_kokkos "$prefix"
  fi
  kokkos_arguments=(-DKokkos_ROOT="$prefix")
}
