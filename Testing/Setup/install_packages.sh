#!/usr/bin/env bash
# Installs, with apt, what building, testing or benchmarking RayTracedGlyphs needs and is missing.
# Usage: install_packages.sh [build] [test] [gui] [benchmark] [source-build]   (default: build test gui)
# Works on Debian 12 and 13, as root or through sudo; does nothing when all is there.
set -euo pipefail

groups=("$@")
[ ${#groups[@]} -gt 0 ] || groups=(build test gui)

build=(cmake ninja-build g++ ccache pkg-config
  libvulkan-dev glslang-tools libglm-dev
  paraview paraview-dev python3-paraview
  libopenmpi-dev libglew-dev libgl-dev python3-dev libfreetype-dev
  libvulkan1 mesa-vulkan-drivers libgl1-mesa-dri xvfb python3-numpy)
gui=(python3-mpi4py qtbase5-dev libqt5svg5-dev libqt5opengl5-dev qttools5-dev libgdal-dev libboost-dev
  libutfcpp-dev liblz4-dev libdouble-conversion-dev libtheora-dev libgl2ps-dev
  libavcodec-dev libavformat-dev libavutil-dev libswscale-dev)
test=(libgtest-dev libquadmath0 vulkan-validationlayers openmpi-bin)
benchmark=(libembree-dev python3-matplotlib)
simulate=(lammps)

wanted=()
for group in "${groups[@]}"; do
  case "$group" in
    build) wanted+=("${build[@]}") ;;
    gui) wanted+=("${gui[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    benchmark) wanted+=("${benchmark[@]}") ;;
    simulate) wanted+=("${simulate[@]}") ;;
    *) echo "install_packages.sh: unknown group '$group'; known: build gui test benchmark simulate" >&2; exit 2 ;;
  esac
done

. /etc/os-release
codename=${VERSION_CODENAME:-unknown}
case "$codename" in
  bookworm | trixie) ;;
  *) echo "install_packages.sh: '$codename' is untested; continuing as on trixie. Tested: bookworm (12), trixie (13)." ;;
esac
# Debian 13 renamed the validation layers; take whichever name this release has.
pick_existing() { # name alternative
  if apt-cache show "$1" >/dev/null 2>&1; then echo "$1"; else echo "$2"; fi
}

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
  # The mirror is whatever this machine already uses for the release itself.
  local entry uri source_file signed_by
  entry=$(apt-get indextargets --format '$(CODENAME) $(REPO_URI) $(SOURCESENTRY)' 'Created-By: Packages' |
    awk -v c="$codename" '$1 == c { print; exit }')
  uri=$(echo "$entry" | awk '{ print $2 }')
  source_file=$(echo "$entry" | awk '{ sub(/:[0-9]+$/, "", $3); print $3 }')
  # The key that signs the release signs its backports; both source formats can name it.
  signed_by=$(sed -nE 's/^Signed-By: *(\/.*)/\1/p; s/.*\[.*signed-by=([^] ]+).*/\1/p' "$source_file" | head -n 1)
  if [ -z "$uri" ]; then
    echo "install_packages.sh: no apt source for '$codename' found; add one to /etc/apt/sources.list" >&2
    exit 1
  fi
  {
    echo "Types: deb"
    echo "URIs: $uri"
    echo "Suites: $codename-backports"
    echo "Components: main"
    if [ -n "$signed_by" ]; then echo "Signed-By: $signed_by"; fi
  } | as_root tee /etc/apt/sources.list.d/raytracedglyphs-backports.sources >/dev/null
  as_root apt-get -q update
}

as_root apt-get -q update
if [ "$codename" = bookworm ]; then
  add_backports
  # Backports have priority 100, so only these packages come from there.
  as_root apt-get -qy install --no-install-recommends -t bookworm-backports \
    mesa-vulkan-drivers libgl1-mesa-dri libgl1 libegl-mesa0 libglx-mesa0
fi
as_root apt-get -qy install --no-install-recommends "${missing[@]}"
echo "packages: done"
