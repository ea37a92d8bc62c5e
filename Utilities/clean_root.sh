#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs setup.sh in a Debian system with nothing installed:
#
#   Utilities/clean_root.sh [OPTION]... bookworm|trixie|forky [demo|test|package|use|ci]...
#
# Makes a root of Debian 12 (bookworm), 13 (trixie) or testing (forky) with debootstrap, clones the commit
# checked out here into /gatun of it and runs `Utilities/setup.sh demo` and `test` there, or the commands
# given (ci: `.ci/run`; use: autopkgtest with the packages). Needs root and the package debootstrap. Options:
#
#   --root FOLDER    where the root goes             (/var/tmp/gatun-<release>)
#   --again          use the root that is there already, with a fresh clone
#   --keep-build     with --again: keep the build of the last run
#   --ccache FOLDER  compile with ccache, which keeps its results in FOLDER
#   --packages FOLDER
#                    packages made, or to use        (<root>-packages)
#   --mirror URL     mirror of Debian                (the host's)
#
# The mirror, its further suites (updates, security) and proxies are those of the host's apt.
# GATUN_JOBS is passed on. GATUN_DATA_DIR and GATUN_CELLS_DIR are, too, and their folders appear
# in the root, read-only. Mounts are private to the run, nothing of the host is visible otherwise,
# and the root can be deleted afterwards.

set -euo pipefail

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() {
  printf '== %s\n' "$*"
}

die() {
  printf 'clean_root.sh: %s\n' "$*" >&2
  exit 1
}

usage() {
  sed -n '/^# Runs/,/^$/p' "${BASH_SOURCE[0]}" | sed 's/^# \{0,1\}//'
}

# Prints a line "<uri> <suite> <component>" for each of the host's sources of Debian packages.
host_sources() {
  local codename
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  apt-get indextargets --no-release-info --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' |
    awk -v codename="$codename" -v release="$release" '
      $2 == codename || index($2, codename "-") == 1 {
        sub("^" codename, release, $2)
        if (!seen[$0]++) print
      }'
}

make_root() {
  local sources
  sources=$(host_sources)
  if [ -z "$mirror" ]; then
    mirror=$(awk -v release="$release" '$2 == release { print $1; exit }' <<<"$sources")
    [ -n "$mirror" ] || die "no mirror among the sources of this host; give one with --mirror"
  else
    sources="$mirror $release main"
  fi
  say "Making $root"
  mkdir -p "$root"
  # An older debootstrap does not know the newest release; the script of sid fits them all.
  debootstrap --variant=minbase --include=ca-certificates "$release" "$root" "$mirror" sid \
    >"$root.log" 2>&1 || die "debootstrap failed; see $root.log"
  sed 's/^/deb /' <<<"$sources" >"$root/etc/apt/sources.list"
  apt-config dump | grep -E '^Acquire::((https?|ftp)::Proxy|Check-(Valid-Until|Date)) ' \
    >"$root/etc/apt/apt.conf.d/99host" || true
  # A root that is lost in a crash is made again.
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/gatun"
  touch "$root/.gatun-clean-root"
}

# Runs in a mount namespace of its own, so that all mounts end with it.
run_inside() {
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  local settings=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
    LANG=C.UTF-8 "TERM=${TERM:-dumb}")
  local name folder status=0 start
  for name in GATUN_DATA_DIR GATUN_CELLS_DIR; do
    folder=${!name:-}
    if [ -n "$folder" ]; then
      mkdir -p "$root/mnt/$name"
      mount --bind "$folder" "$root/mnt/$name"
      mount -o remount,bind,ro "$root/mnt/$name"
      settings+=("$name=/mnt/$name")
    fi
  done
  if [ -n "${GATUN_JOBS:-}" ]; then
    settings+=("GATUN_JOBS=$GATUN_JOBS")
  fi
  if [ -n "$ccache" ]; then
    mkdir -p "$ccache" "$root/mnt/ccache"
    mount --bind "$ccache" "$root/mnt/ccache"
    settings+=(CCACHE_DIR=/mnt/ccache CMAKE_C_COMPILER_LAUNCHER=ccache
      CMAKE_CXX_COMPILER_LAUNCHER=ccache)
    chroot "$root" env -i "${settings[@]}" DEBIAN_FRONTEND=noninteractive sh -c \
      'command -v ccache >/dev/null || { apt-get -qq update &&
       apt-get -qq -y install --no-install-recommends ccache; }' >>"$root.log" 2>&1
  fi

  mkdir -p "$packages" "$root/packages"
  mount --bind "$packages" "$root/packages"

  for name in "${commands[@]}"; do
    local command=("Utilities/setup.sh" "$name")
    case $name in
      ci) command=(.ci/run) ;;
      use) command=(sh -c 'apt-get -qq update && apt-get -qq -y install --no-install-recommends autopkgtest \
        >/dev/null && exec autopkgtest --no-built-binaries /packages/*.deb . -- null') ;;
    esac
    say "Debian $(cat "$root/etc/debian_version"): ${command[*]}"
    start=$SECONDS
    chroot "$root" env -i "${settings[@]}" sh -c 'cd /gatun && exec "$@"' sh "${command[@]}" \
      </dev/null || status=$?
    say "${command[*]}: exit code $status after $((SECONDS - start)) s"
    [ "$status" -eq 0 ] || return "$status"
    if [ "$name" = package ]; then
      rm -f "$packages"/*.deb
      cp "$root"/gatun/build/packages/*.deb "$packages"
    fi
  done
}

again=
keep_build=
ccache=
mirror=
packages=
root=
release=
commands=()
arguments=("$@")
while [ $# -gt 0 ]; do
  case $1 in
    --root | --ccache | --mirror | --packages)
      [ $# -gt 1 ] || die "$1 needs an argument"
      declare "${1#--}=$2"
      shift
      ;;
    --again) again=1 ;;
    --keep-build) keep_build=1 ;;
    -h | --help)
      usage
      exit 0
      ;;
    bookworm | trixie | forky) release=$1 ;;
    demo | test | package | use | ci) commands+=("$1") ;;
    *)
      usage >&2
      exit 2
      ;;
  esac
  shift
done
if [ -z "$release" ]; then
  usage >&2
  exit 2
fi
[ ${#commands[@]} -gt 0 ] || commands=(demo test)
root=$(realpath -m "${root:-/var/tmp/gatun-$release}")
packages=$(realpath -m "${packages:-$root-packages}")
case $root/ in
  "$source"/*) die "$root is in the source tree" ;;
esac

if [ -n "${GATUN_CLEAN_ROOT_MOUNTED:-}" ]; then
  run_inside
  exit
fi

[ "$(id -u)" -eq 0 ] || die "this needs to be run by root"
command -v debootstrap >/dev/null || die "this needs the package debootstrap"
if [ -n "$again" ]; then
  [ -f "$root/.gatun-clean-root" ] || die "$root is no root that this script made"
elif [ -n "$(ls -A "$root" 2>/dev/null)" ]; then
  die "$root is there already; delete it, or use it with --again"
else
  make_root
fi

commit=$(git -C "$source" rev-parse HEAD)
if [ -n "$keep_build" ] && [ -d "$root/gatun/build" ]; then
  rm -rf "$root/gatun-build"
  mv "$root/gatun/build" "$root/gatun-build"
fi
rm -rf "$root/gatun"
git clone -q --no-local "$source" "$root/gatun"
git -C "$root/gatun" checkout -q --detach "$commit"
if [ -d "$root/gatun-build" ]; then
  mv "$root/gatun-build" "$root/gatun/build"
fi
say "Clone of $commit in $root/gatun"

GATUN_CLEAN_ROOT_MOUNTED=1 exec unshare --mount --propagation private \
  "${BASH_SOURCE[0]}" "${arguments[@]}"
