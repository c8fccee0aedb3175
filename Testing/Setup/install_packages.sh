#!/usr/bin/env bash
# Installs, with apt, what building, testing or benchmarking RayTracedGlyphs needs and is missing.
# Usage: install_packages.sh [--names] [build] [test] [gui] [deb] [benchmark] [simulate]
#                            [source-build] [source-build-qt] [source-build-mpi]     (default: build test gui)
# --names: only prints the packages' names
# Works on Debian 12, 13 and testing, as root or through sudo; does nothing when all is there.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian_mirror.sh"

. /etc/os-release
codename=${VERSION_CODENAME:-unknown}
case "$codename" in
  bookworm | trixie | forky | sid) ;;
  *) echo "install_packages.sh: '$codename' is untested; continuing as on forky." \
       "Tested: bookworm (12), trixie (13), forky (testing)." >&2 ;;
esac
names=no
[ "${1:-}" != --names ] || { names=yes; shift; }
groups=("$@")
[ ${#groups[@]} -gt 0 ] || groups=(build test gui)

spirv=(spirv-tools)
case "$codename" in
  bookworm | trixie) ;; # The tools' package has the library, too.
  *) spirv+=(spirv-tools-dev) ;;
esac
build=(cmake ninja-build g++ ccache pkg-config
  libvulkan-dev glslang-tools "${spirv[@]}" libglm-dev
  paraview paraview-dev python3-paraview
  libopenmpi-dev libglew-dev libgl-dev python3-dev libfreetype-dev
  libvulkan1 mesa-vulkan-drivers libgl1-mesa-dri xvfb python3-numpy)
qt=(qtbase5-dev libqt5svg5-dev libqt5opengl5-dev qttools5-dev)
[ "$codename" = bookworm ] || qt=(qt6-base-dev qt6-svg-dev qt6-svg-plugins qt6-5compat-dev qt6-tools-dev qt6-tools-dev-tools)
case "$codename" in
  bookworm | trixie) ;; # ParaView contains its own VTK.
  *)
    build+=(libvtk9-dev)
    qt+=(libvtk9-qt-dev) ;;
esac
gui=("${qt[@]}" python3-mpi4py libgdal-dev libboost-dev
  libutfcpp-dev liblz4-dev libdouble-conversion-dev libtheora-dev libgl2ps-dev
  libavcodec-dev libavformat-dev libavutil-dev libswscale-dev)
test=(libgtest-dev libquadmath0 vulkan-validationlayers openmpi-bin)
# The version that formats this project; later releases have later ones only.
[ "$codename" != bookworm ] || test+=(clang-format-14)
deb=(build-essential dpkg-dev debhelper lintian git)
benchmark=(libembree-dev python3-matplotlib)
simulate=(lammps)
# What Testing/Setup/build_paraview.sh compiles ParaView with.
source_build=(cmake ninja-build g++ ccache xz-utils ca-certificates
  libgl-dev libegl-dev libxt-dev libxcursor-dev libpython3-dev python3-numpy
  libvulkan-dev glslang-tools "${spirv[@]}" libglm-dev libvulkan1 mesa-vulkan-drivers libgl1-mesa-dri xvfb)
source_build_qt=(qtbase5-dev libqt5svg5-dev libqt5opengl5-dev qttools5-dev qttools5-dev-tools
  libqt5x11extras5-dev qtxmlpatterns5-dev-tools libqt5xmlpatterns5-dev)
source_build_mpi=(libopenmpi-dev openmpi-bin)

wanted=()
for group in "${groups[@]}"; do
  case "$group" in
    build) wanted+=("${build[@]}") ;;
    gui) wanted+=("${gui[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    deb) wanted+=("${deb[@]}") ;;
    benchmark) wanted+=("${benchmark[@]}") ;;
    simulate) wanted+=("${simulate[@]}") ;;
    source-build) wanted+=("${source_build[@]}") ;;
    source-build-qt) wanted+=("${source_build_qt[@]}") ;;
    source-build-mpi) wanted+=("${source_build_mpi[@]}") ;;
    *) echo "install_packages.sh: unknown group '$group'; known: build gui test deb benchmark simulate" \
         "source-build source-build-qt source-build-mpi" >&2; exit 2 ;;
  esac
done
[ "$names" = no ] || { printf '%s\n' "${wanted[@]}"; exit 0; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo --preserve-env=DEBIAN_FRONTEND "$@"
  else echo "install_packages.sh: needs root; run as root or install sudo. Wanted: $*" >&2; exit 1
  fi
}
export DEBIAN_FRONTEND=noninteractive

installed() { [ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null)" = "ii " ]; }
# Mesa before 24 has no ray tracing in lavapipe; Debian 12 itself ships 22.3.
mesa_too_old() {
  local version
  version=$(dpkg-query -W -f='${Version}' mesa-vulkan-drivers 2>/dev/null || true)
  [ -z "$version" ] || dpkg --compare-versions "$version" lt 24.1
}

missing=()
for package in "${wanted[@]}"; do installed "$package" || missing+=("$package"); done
if [ ${#missing[@]} = 0 ] && ! mesa_too_old; then
  echo "packages: all ${#wanted[@]} present"
  exit 0
fi
echo "packages: installing ${missing[*]:-newer Mesa}"

add_backports() {
  apt-cache policy | grep -q "n=$codename-backports" && return
  if ! find_debian_mirror "$codename"; then
    echo "install_packages.sh: no apt source for '$codename' found; add one to /etc/apt/sources.list" >&2
    exit 1
  fi
  debian_source_entry deb "$codename-backports" |
    as_root tee /etc/apt/sources.list.d/raytracedglyphs-backports.sources >/dev/null
  as_root apt-get -q update
}

as_root apt-get -q update
if [ "$codename" = bookworm ]; then
  add_backports
  # PACKAGE/SUITE takes from backports these packages and only those dependencies that they cannot do without; -t would
  # also take newer libraries that packages of the release then conflict with (libelf1 against libdw1).
  as_root apt-get -qy install --no-install-recommends {mesa-vulkan-drivers,libgl1-mesa-dri,libegl-mesa0,libglx-mesa0}/bookworm-backports
fi
as_root apt-get -qy install --no-install-recommends "${missing[@]}"
echo "packages: done"
