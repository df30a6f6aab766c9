# SPDX-License-Identifier: BSD-3-Clause
# Debian's packages for 64-bit ARM on another machine, and a system of them. Needs common.sh.

# apt-get as of a bare machine of ARM, in folders of its own: this machine's apt state stays as it is.
arm_apt_get() {
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::status="$scratch/arm/status" \
    -o Dir::State::lists="$scratch/arm/lists" -o Dir::Cache="$scratch/arm/cache" \
    -o Acquire::Languages=none -o Acquire::Retries=3 "$@"
}

# make_arm_root FOLDER PACKAGE...: these and all that they need, unpacked, not configured.
make_arm_root() {
  local archive link to="$1"
  shift
  make_scratch
  rm -rf "$scratch/arm"
  mkdir -p "$scratch"/arm/{lists,cache/archives}/partial
  : >"$scratch/arm/status"
  quietly arm_apt_get update || warn "not every apt source could be read; going on"
  quietly arm_apt_get install -y --no-install-recommends --download-only "$@" ||
    die "Debian's packages for ARM could not be downloaded (see above)"
  stage="$(mktemp -d "$BAGNOLD_CACHE/.stage.XXXXXX")"
  mkdir -p "$stage"/usr/{bin,sbin,lib}
  ln -s usr/bin usr/sbin usr/lib "$stage"
  for archive in "$scratch"/arm/cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$archive" | tar -x --keep-directory-symlink -C "$stage"
  done
  find "$stage" -type l -lname '/*' | while read -r link; do
    ln -sfnr "$stage$(readlink "$link")" "$link" # an absolute link would lead out of the folder
  done
  chmod 755 "$stage"
  mv -T "$stage" "$to" 2>/dev/null || [ -d "$to" ] || die "packages for ARM could not be moved to $to"
  rm -rf "$stage"
}

# in_arm FOLDER COMMAND...: in the system of make_arm_root, its programs run by qemu-user, this tree at /bagnold.
# Linux 6.7 gives a user namespace a list of interpreters of its own; before, it is the machine's (binfmt-support).
in_arm() {
  local variables=(LC_ALL=C.UTF-8)
  add_variables_of_a_root
  # shellcheck disable=SC2016
  unshare --user --map-root-user --mount --pid --fork --kill-child bash -euc '
    to="$1" tree="$2"
    list=/proc/sys/fs/binfmt_misc
    mount -t proc proc /proc
    if [ ! -e "$list/qemu-aarch64" ]; then
      mount -t binfmt_misc binfmt_misc "$list"
      zeros="\x00\x00\x00\x00\x00\x00\x00\x00" ones="\xff\xff\xff\xff\xff\xff\xff\xff"
      printf %s ":qemu-aarch64:M::\x7fELF\x02\x01\x01\x00$zeros\x02\x00\xb7\x00:\xff\xff\xff\xff\xff\xff\xff\x00$ones\xfe\xff\xff\xff:$(command -v qemu-aarch64-static):FP" >"$list/register"
    fi
    mount --bind "$to" "$to"
    mkdir -p "$to"/{proc,dev,sys,tmp,root,bagnold}
    mount --rbind /proc "$to/proc"
    mount --rbind /dev "$to/dev"
    mount -t tmpfs tmpfs "$to/tmp"
    mount --bind "$tree" "$to/bagnold"
    for name in /etc/resolv.conf /etc/hosts /etc/pip.conf /etc/ssl/certs/ca-certificates.crt; do
      [ -f "$name" ] || continue
      mkdir -p "$to$(dirname "$name")"
      cp -L "$name" "$to$name"
    done
    exec chroot "$to" /usr/bin/env -i "${@:3}"
  ' bash "$1" "$root" "${variables[@]}" "${@:2}" </dev/null
}
