# SPDX-License-Identifier: BSD-3-Clause
# What every script needs. Sourced, not run; `root` is the root of the source tree.

say() { printf '== %s\n' "$*"; }
warn() { printf 'warning: %s\n' "$*" >&2; }
die() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

have() { command -v "$1" >/dev/null 2>&1; }

is_debian_12() {
  [ -r /etc/os-release ] && (
    . /etc/os-release
    [ "${ID:-}" = debian ] && [ "${VERSION_ID:-}" = 12 ]
  )
}

# With a terminal, sudo may ask for a password; without one it must not wait for it.
as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif [ -t 2 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

can_be_root() { [ "$(id -u)" = 0 ] || { have sudo && as_root true; }; }

# Where Kokkos is kept between builds; cmake/kokkos.cmake looks in the same place.
set_cache() {
  if [ -z "${BAGNOLD_CACHE:-}" ]; then
    : "${HOME:=$(getent passwd "$(id -u)" | cut -d: -f6)}"
    BAGNOLD_CACHE="${XDG_CACHE_HOME:-$HOME/.cache}/bagnold"
  fi
  if ! mkdir -p "$BAGNOLD_CACHE" 2>/dev/null || ! [ -w "$BAGNOLD_CACHE" ]; then
    die "cannot write to $BAGNOLD_CACHE, where Kokkos is kept; set BAGNOLD_CACHE to a folder that you own"
  fi
  BAGNOLD_CACHE="$(cd "$BAGNOLD_CACHE" && pwd -P)"
  export BAGNOLD_CACHE
}

# A temporary folder, removed when the script ends, and with it what is half installed ($stage). apt's
# downloader, another user, may enter it.
scratch=""
stage=""
make_scratch() {
  [ -z "$scratch" ] || return 0
  scratch="$(mktemp -d)"
  chmod 755 "$scratch"
  trap 'rm -rf "$scratch" ${stage:+"$stage"}' EXIT
}

# Run a command quietly; where it fails, show the end of what it printed.
quietly() {
  make_scratch
  if ! "$@" >"$scratch/log" 2>&1 </dev/null; then
    tail -n 40 "$scratch/log" >&2
    return 1
  fi
}

# Compilers at work at once: one a processor, but 1.5 GB of memory for each.
jobs_for_this_machine() {
  local processors memory
  processors="$(nproc)"
  memory="$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)"
  [ "${memory:-1}" -ge 1 ] || memory=1
  echo $((processors < memory ? processors : memory))
}

# add_variables_of_a_root [NAME...]: appends to the array variables what commands in another root are given: HOME and
# PATH, and of those that are set here proxies, pip's, and NAMEs.
add_variables_of_a_root() {
  local name
  variables+=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy ${!PIP_*} "$@"; do
    [ -z "${!name:-}" ] || variables+=("$name=${!name}")
  done
}

# changed_headers: those that the last twenty commits of headers or the working tree changed, as CMake's list
# BAGNOLD_HEADERS; "all" where git does not tell.
changed_headers() {
  local first names
  if first="$(git -C "$root" log -n 20 --format=%H -- '*.hpp' 2>/dev/null | tail -n 1)" && [ -n "$first" ] &&
    names="$(git -C "$root" diff --name-only "$first~1" -- '*.hpp' 2>/dev/null | paste -sd ';')"; then
    printf %s "${names:-none}"
  else
    printf all
  fi
}
