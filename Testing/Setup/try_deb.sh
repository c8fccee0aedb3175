#!/usr/bin/env bash
# Installs a package that build_deb.sh has made, draws with it, purges it and looks whether anything of it is left, as root.
# Packages that it needs stay: meant for a bare chroot, which `chroot.sh RELEASE deb FILE.deb` makes.
# Usage: try_deb.sh FILE.deb
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[ $# = 1 ] && [ -r "$1" ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
file=$(realpath "$1")
name=$(dpkg-deb --field "$file" Package)
! dpkg-query --status "$name" >/dev/null 2>&1 || { echo "try_deb.sh: $name is installed already; apt-get purge $name" >&2; exit 1; }
export DEBIAN_FRONTEND=noninteractive

echo "== install"
apt-get -q update
# The package's own recommendation, without those of all others.
recommended=$(dpkg-deb --field "$file" Recommends)
apt-get -qy install --no-install-recommends "$file" ${recommended//,/ } python3-paraview python3-numpy libgl1-mesa-dri xvfb
mapfile -t paths < <(dpkg --listfiles "$name" | grep -v '^/\.$') # without the root folder

echo "== draw"
(cd "$here/../.." && Testing/Setup/debian/tests/draw)

echo "== purge"
apt-get -qy purge "$name"
left=()
for path in "${paths[@]}"; do
  [ ! -e "$path" ] && [ ! -L "$path" ] || dpkg --search "$path" >/dev/null 2>&1 || left+=("$path")
done
[ ${#left[@]} = 0 ] || { echo "FAILED: left are ${left[*]}" >&2; exit 1; }
echo "$name: all ${#paths[@]} files and folders are gone, or are those of other packages"
