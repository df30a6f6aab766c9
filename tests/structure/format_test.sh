#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# format_test.sh ROOT CLANG_FORMAT: does clang-format 14 leave every source file of ROOT as it is? Names
# those that it would change; 77 where it is not to be had.
set -euo pipefail
cd "$1"
format="$2"
"$format" --version 2>/dev/null | grep -q 'version 14[.]' || {
  echo "clang-format 14 is missing: apt-get install clang-format-14"
  exit 77
}
changed=0
while IFS= read -r -d '' file; do
  "$format" --dry-run -Werror "$file" 2>/dev/null || { echo "clang-format -i $file"; changed=1; }
done < <(find kernels src tests bench -type f \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z)
exit "$changed"
