# SPDX-License-Identifier: BSD-3-Clause
# Kokkos for CUDA, of the sources that kokkos.sh fetches. Needs common.sh, packages.sh, kokkos.sh and build.sh.

cuda_recipe=1 # count up when what is below changes

# For CUDA 13 the sources need two calls as that has them; Kokkos 4.7.01 has this change.
adapt_kokkos_to_cuda_13() {
  local file="$scratch/kokkos/core/src/Cuda/Kokkos_Cuda_Instance.hpp"
  sed -i -e 's/cudaGraphAddDependencies(graph, from, to, numDependencies)/cudaGraphAddDependencies(graph, from, to, nullptr, numDependencies)/' \
    -e 's/cudaMemPrefetchAsync(devPtr, count, dstDevice, m_stream)/cudaMemPrefetchAsync(devPtr, count, cudaMemLocation{cudaMemLocationTypeDevice, dstDevice}, 0, m_stream)/' \
    "$file"
  [ "$(grep -c 'to, nullptr, numDependencies\|cudaMemLocationTypeDevice, dstDevice' "$file")" = 2 ] ||
    die "Kokkos' calls of CUDA 12 are not where they were, in $file"
}

# Leaves in kokkos_arguments what the configure step needs. Legacy Views: cmake/kokkos_runs.cmake.
provide_cuda_kokkos() {
  local nvcc version arch="${BAGNOLD_CUDA_ARCH:-HOPPER90}" prefix
  nvcc="$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)"
  [ -x "$nvcc" ] || die "there is no nvcc in PATH, nor /usr/local/cuda/bin/nvcc: install the CUDA toolkit (12 or newer)"
  PATH="$(dirname "$nvcc"):$PATH" # where Kokkos' nvcc_wrapper looks
  version="$(nvcc --version | sed -n 's/.*release \([0-9]*\).*/\1/p')"
  set_cache
  # Not where scripts/quickstart looks.
  prefix="${Kokkos_ROOT:-$BAGNOLD_CACHE/cuda/kokkos-$kokkos_newest-cuda$version-$arch-r$cuda_recipe}"
  if [ -z "${Kokkos_ROOT:-}" ] && [ ! -d "$prefix" ]; then
    mkdir -p "$BAGNOLD_CACHE/cuda"
    fetch_kokkos "$kokkos_newest" || die "the sources of Kokkos $kokkos_newest could not be had (see above)"
    # nvcc_wrapper's own choice is of a device that CUDA 13 does not know any more.
    sed -i "s/^default_arch=.*/default_arch=\"sm_${arch//[^0-9]/}\"/" "$scratch/kokkos/bin/nvcc_wrapper"
    [ "$version" -lt 13 ] || adapt_kokkos_to_cuda_13
    build_kokkos "$prefix" -DCMAKE_CXX_COMPILER="$scratch/kokkos/bin/nvcc_wrapper" -DCMAKE_CXX_STANDARD=20 \
      -DKokkos_ENABLE_OPENMP=OFF -DKokkos_ENABLE_CUDA=ON -DKokkos_ARCH_"$arch"=ON \
      -DKokkos_ENABLE_IMPL_VIEW_LEGACY=ON
  fi
  [ -x "$prefix/bin/nvcc_wrapper" ] || die "there is no nvcc_wrapper in Kokkos_ROOT=$prefix"
  kokkos_arguments=(-UKokkos_DIR -DKokkos_ROOT="$prefix" -DCMAKE_CXX_COMPILER="$prefix/bin/nvcc_wrapper")
  # CMake forgets all options of a build folder whose compiler changes.
  grep -qsx "CMAKE_CXX_COMPILER:[A-Z]*=$prefix/bin/nvcc_wrapper" "$root/build/cuda/CMakeCache.txt" ||
    rm -rf "$root/build/cuda"
}
