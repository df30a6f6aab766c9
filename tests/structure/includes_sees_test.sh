#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# includes_sees_test.sh FOLDER: does includes_test.sh see what it should? One small tree for each fault.
set -euo pipefail
test="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)/includes_test.sh"
failed=0

# expect STATUS FILE LINE...
expect() {
  local status="$1" file="$2" found=0
  rm -rf "$folder"
  mkdir -p "$folder/kernels/physics" "$folder/src/config" "$folder/$(dirname "$file")"
  printf '%s\n' '#pragma once' | tee "$folder/kernels/physics/a.hpp" >"$folder/src/config/own.hpp"
  case "$file" in
    *.hpp) printf '%s\n' '#pragma once' "${@:3}" >"$folder/$file" ;;
    *) printf '%s\n' "${@:3}" >"$folder/$file" ;;
  esac
  bash "$test" "$folder" >/dev/null || found=$?
  [ "$found" = "$status" ] && return 0
  echo "expected status $status, found $found, for $file: ${*:3}"
  failed=1
}

folder="$1"
expect 0 kernels/device/b.hpp '#include "kernels/physics/a.hpp"' '#include <Kokkos_Core.hpp>'
expect 0 kernels/device/neighbors/b.hpp 'parallel_for("neighbors::Search", n, f);'
expect 1 kernels/physics/b.hpp '#include "kernels/device/a.hpp"'
expect 0 kernels/physics/b.hpp '#include <Kokkos_Macros.hpp>'
expect 1 kernels/physics/b.hpp '#include <Kokkos_Core.hpp>'
expect 1 kernels/device/b.hpp '#include "kernels/cpu/a.hpp"'
expect 0 kernels/cpu/b.hpp '#include "kernels/device/a.hpp"'
expect 1 kernels/device/b.hpp '#include "b2.hpp"'
expect 1 kernels/device/b.hpp '#include <H5Cpp.h>'
expect 1 kernels/device/neighbors/b.hpp 'parallel_for("device::Search", n, f);'
expect 0 src/start/b.cpp 'Kokkos::parallel_for(' '    "start::Relax", n, f);'
expect 1 src/start/b.cpp 'Kokkos::parallel_for(n, f);'
expect 1 src/config/b.cpp '#include <Kokkos_Core.hpp>'
expect 1 src/io/b.cpp '#include "src/cli/a.hpp"'
expect 1 src/run/b.cpp '#include "src/cli/a.hpp"'
expect 1 src/run/b.cpp '#include <CLI/CLI.hpp>'
expect 1 src/engine/b.cpp '#include "src/config/scene.hpp"'
expect 0 src/engine/make_simulation.cpp '#include "src/config/scene.hpp"'
expect 1 src/unheard/b.cpp '#include <vector>'
expect 0 src/config/own.cpp '#include "src/config/own.hpp"' '#include <vector>'
expect 1 src/config/own.cpp '#include <vector>' '#include "src/config/own.hpp"'
expect 1 src/config/own.cpp '#include <vector>'
rm -rf "$folder"
mkdir -p "$folder/kernels" "$folder/src/config"
printf '%s\n' '#include <vector>' >"$folder/src/config/twice.hpp"
if bash "$test" "$folder" >/dev/null; then
  echo "a header without #pragma once was not seen"
  failed=1
fi
exit "$failed"
