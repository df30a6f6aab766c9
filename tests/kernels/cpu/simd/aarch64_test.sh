#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# aarch64_test.sh ROOT FOLDER INCLUDE...: packs for 64-bit ARM, pack_test.cpp of ROOT by a cross compiler, in
# FOLDER, with the folders of Kokkos' headers, run by qemu-user; 77 where one of them is not to be had.
set -euo pipefail
root="$1" folder="$2"
shift 2
compiler="$(command -v aarch64-linux-gnu-g++-12 || command -v aarch64-linux-gnu-g++ || true)"
qemu="$(command -v qemu-aarch64-static || command -v qemu-aarch64 || true)"
googletest=/usr/src/googletest/googletest
if [ -z "$compiler" ] || [ -z "$qemu" ] || [ ! -d "$googletest" ]; then
  echo "a part is missing: apt-get install g++-12-aarch64-linux-gnu qemu-user-static libgtest-dev"
  exit 77
fi
options=(-std=c++20 -fopenmp -I"$root" -I"$googletest" -I"$googletest/include")
for include in "$@"; do options+=(-isystem "$include"); done
mkdir -p "$folder"
"$compiler" "${options[@]}" -c "$googletest/src/gtest-all.cc" -o "$folder/googletest.o"
"$compiler" "${options[@]}" -O3 -ffp-contract=off -Wall -Wextra -Wno-psabi -static \
  "$root/tests/kernels/cpu/simd/pack_test.cpp" "$googletest/src/gtest_main.cc" "$folder/googletest.o" \
  -o "$folder/packs_aarch64_test"
"$qemu" "$folder/packs_aarch64_test"
