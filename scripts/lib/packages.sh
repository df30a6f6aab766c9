# SPDX-License-Identifier: BSD-3-Clause
# The Debian packages that Bagnold needs, and how they are installed.

build_packages=(
  g++ cmake ninja-build pkg-config ca-certificates
  libeigen3-dev libhdf5-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  librandom123-dev libxxhash-dev
)
picture_packages=(python3 python3-h5py python3-matplotlib)
bench_packages=(libbenchmark-dev python3 python3-h5py)
package_packages=(dpkg-dev file help2man) # what cpack asks to make Debian packages
wheel_packages=(git python3-venv rsync)
cross_packages=(gcc-12-aarch64-linux-gnu g++-12-aarch64-linux-gnu qemu-user-static)
test_packages=(
  libgtest-dev clang-format-14 python3-numpy python3-yaml zsh
  "${bench_packages[@]}" "${package_packages[@]}"
  # Other programs that read what is written here; not MDAnalysis, whose 2.4 opens observables of particles in no H5MD.
  mypy python3-ase python3-gsd python3-pandas python3-xarray python3-h5netcdf python3-jsonschema
  munge slurm-wlm # a cluster of our own
  make snakemake # workflows
  python3-nbclient python3-ipykernel # notebooks
  chromium ffmpeg # reports in a browser, films: half a minute of a processor
  python3-venv # the site, with Sphinx of PyPI
)
fuzz_packages=(clang libclang-rt-14-dev python3-venv)

print_requirements() {
  cat >&2 <<'END'

This is not Debian 12, so nothing was installed. Bagnold needs, from your system or built by you:

  a C++20 compiler (GCC 12 or newer), CMake 3.25 or newer, Ninja or Make
  Kokkos 3.4 to 5.x, with Serial and, for more than one thread, OpenMP
  Eigen 3.4, HDF5 1.10 (the C library), toml++ 3.3, CLI11 2.1, fmt 9, nlohmann-json 3.11,
  Random123 1.14, xxHash 0.8
  for the pictures, which are optional: Python 3 with h5py and matplotlib
  for the tests: GoogleTest 1.12, Google Benchmark 1.7, Python 3 with h5py, numpy and PyYAML

Point CMake at an installed Kokkos, then build:

  cmake --preset openmp -DKokkos_ROOT=PREFIX
  cmake --build --preset openmp --parallel

or let CMake download and build Kokkos: -DBAGNOLD_FETCH_KOKKOS=ON instead of -DKokkos_ROOT=PREFIX.
END
}

# missing_packages NAME... prints those that are not installed.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || echo "$name"
  done
}

# install_packages NAME... installs what is missing; without anything missing it needs no network.
install_packages() {
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [ "${#missing[@]}" = 0 ]; then
    say "Debian packages: all installed"
    return 0
  fi
  local command=(apt-get install --no-install-recommends "${missing[@]}")
  if ! can_be_root; then
    printf '%s\n' "error: packages are missing, and only root may install them (sudo is absent or refuses)." \
      "Let root run this, then try again:" "" "  ${command[*]}" "" >&2
    return 1
  fi
  say "Debian packages: installing ${missing[*]} (a minute or so)"
  # One apt source that is out of reach need not matter: the installation tells.
  quietly as_root apt-get -q -o Acquire::Retries=3 update || warn "apt-get update had problems; going on"
  if ! quietly as_root env DEBIAN_FRONTEND=noninteractive "${command[0]}" -q -y \
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "${command[@]:1}"; then
    printf '%s\n' "error: the packages could not be installed (see above). Try this as root:" "" \
      "  ${command[*]}" "" >&2
    return 1
  fi
}
