#!/usr/bin/env bash
# Runs demo.sh or test.sh in a bare Debian of another release, in a chroot of its own, as root or with sudo. The chroot
# holds the clone's last commit and is used again by the next run.
# Usage: chroot.sh RELEASE [--dir DIR] [--arch ARCH] [--mirror URI] [--ccache DIR] [--fresh] demo|test [ARGUMENT...]
#        chroot.sh RELEASE [...] deb FILE.deb                   try_deb.sh: the package is installed, used and purged
#        chroot.sh RELEASE [...] run COMMAND [ARGUMENT...]      any other command, in the chroot's copy of the clone
#   RELEASE        bookworm, trixie, testing: a suite of the mirror
#   --dir DIR      the chroot                   (default: build-chroot-RELEASE[-ARCH] in the clone)
#   --arch ARCH    Debian's name of another kind of processor, such as arm64, which qemu-user-static plays
#   --mirror URI   where packages come from     (default: the mirror that this machine's apt uses)
#   --ccache DIR   compile through ccache, with this cache from outside of the chroot
#   --fresh        delete the chroot and make it anew
# Example: chroot.sh testing test -R Window
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
. "$here/debian_mirror.sh"

fail() { echo "chroot.sh: $*" >&2; exit 1; }
usage() { sed -n '2,/^set /s/^# \{0,1\}//p' "$0"; }

release= dir= arch= mirror= cache= fresh=no
arguments=("$@")
while [ $# -gt 0 ]; do
  case "$1" in
    --dir | --arch | --mirror | --ccache) [ $# -gt 1 ] || fail "$1 needs a value" ;;&
    --dir) dir=$2; shift ;;
    --arch) arch=$2; shift ;;
    --mirror) mirror=$2; shift ;;
    --ccache) cache=$(realpath -m "$2"); shift ;;
    --fresh) fresh=yes ;;
    -h | --help) usage; exit 0 ;;
    demo | test | deb | run) break ;;
    -*) fail "unknown option '$1'; see --help" ;;
    *) [ -z "$release" ] || fail "unknown command '$1'; known: demo, test, deb, run"; release=$1 ;;
  esac
  shift
done
[ -n "$release" ] && [ $# -gt 0 ] || { usage >&2; exit 2; }
[ "$1" != deb ] || { [ $# = 2 ] && [ -r "$2" ]; } || fail "deb needs the file of one package, which '${*:2}' is not"
dir=$(realpath -m "${dir:-$clone/build-chroot-$release${arch:+-$arch}}")
complete=$dir/etc/raytracedglyphs-chroot # written when debootstrap has ended well

if [ "$(id -u)" != 0 ]; then
  command -v sudo >/dev/null || fail "needs root; run as root or install sudo"
  exec sudo --preserve-env=http_proxy,https_proxy,no_proxy,CI "$0" "${arguments[@]}"
fi

# Lets the kernel start programs of the other kind of processor by an emulator that it keeps open, in chroots, too.
register_emulator() {
  local processor formats=/proc/sys/fs/binfmt_misc
  case "$arch" in
    arm64) processor=aarch64 ;;
    amd64) processor=x86_64 ;;
    *) processor=$arch ;;
  esac
  [ "$processor" != "$(uname -m)" ] || return 0
  [ -e "$formats/register" ] || mount -t binfmt_misc binfmt_misc "$formats" || fail "the kernel has no binfmt_misc"
  [ -e "$formats/qemu-$processor" ] || cat "/usr/lib/binfmt.d/qemu-$processor.conf" >"$formats/register" ||
    fail "qemu-user-static has no emulator of '$arch'"
}

# All that follows runs in namespaces of its own: mounts that no other process sees, and processes that the kernel ends together
# with the first of them. However this script ends, no process and no mount remains.
if [ -z "${RTGLYPHS_IN_NAMESPACE:-}" ]; then
  packages=(debootstrap)
  [ -z "$arch" ] || packages+=(qemu-user-static)
  dpkg-query -W "${packages[@]}" >/dev/null 2>&1 ||
    DEBIAN_FRONTEND=noninteractive apt-get -qy install --no-install-recommends "${packages[@]}" ||
    fail "could not install; apt-get install ${packages[*]}"
  if [ -n "$arch" ]; then
    register_emulator
  fi
  mkdir -p "$(dirname "$dir")"
  exec 9>"$dir.lock"
  flock --nonblock 9 || fail "$dir is in use by another run"
  RTGLYPHS_IN_NAMESPACE=1 setpriv --pdeathsig KILL \
    unshare --mount --ipc --pid --fork --kill-child --mount-proc "$0" "${arguments[@]}" <&0 &
  inside=$!
  trap 'kill -KILL "$inside"; echo "chroot.sh: interrupted" >&2; exit 130' INT TERM HUP
  status=0
  wait "$inside" || status=$?
  exit $status
fi

find_mirror() {
  if [ -z "$mirror" ]; then
    . /etc/os-release
    find_debian_mirror "${VERSION_CODENAME:-}" ||
      fail "apt knows no Debian mirror: no entry for '${VERSION_CODENAME:-?}' in its sources; give one with --mirror"
    mirror=$mirror_uri
    [ -z "$mirror_signed_by" ] || keyring=(--keyring "$mirror_signed_by")
  fi
}

make_chroot() {
  if [ -e "$complete" ] && [ "$fresh" = no ]; then
    echo "chroot: $dir, made $(cat "$complete")"
    return
  fi
  if [ -e "$dir" ]; then
    [ -e "$complete" ] || [ -e "$dir/debootstrap" ] || [ -z "$(ls -A "$dir")" ] || fail "$dir is there, but no chroot of this script"
    rm -rf --one-file-system "$dir"
  fi
  local keyring=() script=()
  find_mirror
  # debootstrap downloads by itself, and knows only the proxy of the environment.
  [ -n "${http_proxy:-}" ] || eval "$(apt-config shell http_proxy Acquire::http::Proxy)"
  export http_proxy
  [ -e "/usr/share/debootstrap/scripts/$release" ] || script=(/usr/share/debootstrap/scripts/sid)
  echo "chroot: making $dir"
  mkdir -p "$dir"
  debootstrap --variant=minbase ${arch:+"--arch=$arch"} "${keyring[@]}" "$release" "$dir" "$mirror" "${script[@]}" >"$dir.log" 2>&1 ||
    fail "debootstrap failed; the end of $dir.log:
$(tail -n 5 "$dir.log")"
  # How this machine's apt reaches its mirror: proxies, checks of dates.
  apt-config dump | grep -E '^Acquire::(https?|Check-[A-Za-z-]*|Retries)(::[^ ]*)? ' >"$dir/etc/apt/apt.conf.d/90raytracedglyphs" || true
  date -u '+%Y-%m-%d %H:%M UTC' >"$complete"
  mv "$dir.log" "$dir/var/log/debootstrap-output.log"
}

mount_system() {
  mount -t proc proc "$dir/proc"
  mount --rbind /sys "$dir/sys"
  mount --rbind /dev "$dir/dev"
  # MPI names its shared memory after process numbers, which are the same in every chroot.
  mount -t tmpfs -o mode=1777 shm "$dir/dev/shm"
  cp --dereference /etc/resolv.conf "$dir/etc/resolv.conf"
  if [ -n "$cache" ]; then
    mkdir -p "$cache" "$dir/var/cache/ccache"
    mount --bind "$cache" "$dir/var/cache/ccache"
  fi
}

# The clone's last commit, with the build folders of earlier runs left where they are.
copy_clone() {
  local copy=$dir/root/RayTracedGlyphs commit
  commit=$(git -C "$clone" rev-parse HEAD) || fail "$clone is no git clone, or not this user's"
  [ -z "$(git -C "$clone" status --porcelain --untracked-files=no)" ] ||
    echo "chroot.sh: warning: $clone has changes that are not committed; they are not copied" >&2
  [ -e "$copy/.git" ] || git clone --quiet --no-checkout "file://$clone" "$copy"
  git -C "$copy" fetch --quiet "file://$clone" HEAD
  git -C "$copy" checkout --quiet --force --detach "$commit"
  echo "chroot: commit $(git -C "$copy" log -1 --format='%h %s')"
}

in_chroot() {
  local environment=(PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 "TERM=${TERM:-dumb}")
  local name
  for name in http_proxy https_proxy no_proxy CI; do
    [ -z "${!name:-}" ] || environment+=("$name=${!name}")
  done
  [ -z "$cache" ] || environment+=(CCACHE_DIR=/var/cache/ccache CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache)
  chroot "$dir" env -i "${environment[@]}" sh -c 'cd /root/RayTracedGlyphs && exec "$@"' sh "$@"
}

make_chroot
mount_system
copy_clone
# A run that was interrupted in the middle of an installation.
in_chroot dpkg --configure -a
case "$1" in
  demo | test) command=("Testing/Setup/$1.sh" "${@:2}") ;;
  deb)
    copy=$dir/root/RayTracedGlyphs/build-deb
    mkdir -p "$copy"
    [ "$2" -ef "$copy/$(basename "$2")" ] || cp "$2" "$copy"
    command=(Testing/Setup/try_deb.sh "build-deb/$(basename "$2")") ;;
  run) command=("${@:2}") ;;
esac
echo "chroot: $release ($(. "$dir/etc/os-release"; echo "${PRETTY_NAME:-?}")): ${command[*]}"
status=0
in_chroot "${command[@]}" || status=$?
echo "chroot: ended with $status; its copy of the clone is $dir/root/RayTracedGlyphs"
exit $status
