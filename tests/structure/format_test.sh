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
changed="$(find kernels src tests bench -type f \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
  xargs -0 -n 100 "$format" --dry-run 2>&1 | sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: .*code should be clang-formatted.*/\1/p' |
  sort -u)"
[ -z "$changed" ] && exit 0
printf 'clang-format -i %s\n' $changed
exit 1
