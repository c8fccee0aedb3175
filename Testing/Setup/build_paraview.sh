#!/usr/bin/env bash
# Builds ParaView 5.13.2 from source on Debian 12 or 13 and installs it into a folder of your choice.
# Usage: build_paraview.sh [--prefix DIR] [--build-dir DIR] [--jobs N]
#                          [--qt | --no-qt] [--mpi | --no-mpi] [--x11 | --egl] [--configure-only]
#   --prefix DIR      where it is installed              (default: $HOME/paraview-5.13)
#   --build-dir DIR   source and objects; may be deleted afterwards (default: PREFIX-build)
#   --jobs N          compile so many files at a time    (default: all cores)
#   --qt              with the ParaView window           (default: --no-qt: pvpython, pvbatch, pvserver)
#   --mpi             with MPI                           (default: --no-mpi)
#   --egl             renders without any X server       (default: --x11). One of the two: in this version an EGL
#                     build loads OpenGL through EGL only, so that its X11 windows would not start
#   --configure-only  stop before compiling
# Stopped in the middle, the same command goes on where it was. Changed switches rebuild what they must.
# The source is Debian's own signed source package, fetched by apt with a private configuration: nothing in
# /etc/apt changes, and no package of another release can ever be installed through it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/debian_mirror.sh"

paraview_version=5.13.2
source_suite=trixie
prefix=$HOME/paraview-5.13
build_dir=
jobs=$(nproc)
qt=OFF mpi=OFF window=x11 configure_only=no

fail() { echo "build_paraview.sh: $*" >&2; exit 1; }
while [ $# -gt 0 ]; do
  case "$1" in
    --prefix | --build-dir | --jobs) [ $# -gt 1 ] || fail "$1 needs a value" ;;&
    --prefix) prefix=$2; shift ;;
    --build-dir) build_dir=$2; shift ;;
    --jobs) jobs=$2; shift ;;
    --qt) qt=ON ;;
    --no-qt) qt=OFF ;;
    --mpi) mpi=ON ;;
    --no-mpi) mpi=OFF ;;
    --x11) window=x11 ;;
    --egl) window=egl ;;
    --configure-only) configure_only=yes ;;
    -h | --help) sed -n '2,/^set /s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) fail "unknown option '$1'; see --help" ;;
  esac
  shift
done
[ "$qt$window" != ONegl ] || fail "--qt needs an X server: take --x11 with it, or --no-qt with --egl"
prefix=$(realpath -m "$prefix")
build_dir=$(realpath -m "${build_dir:-$prefix-build}")
mkdir -p "$build_dir"
source_dir=$build_dir/source
# X11, EGL and MPI share the objects, so that changing one rebuilds only what depends on it. The editions with and
# without Qt differ in too many cached defaults; they share what they can through ccache.
objects=$build_dir/objects
[ "$qt" = OFF ] || objects+=-qt
export CCACHE_DIR=${CCACHE_DIR:-$build_dir/ccache} CCACHE_MAXSIZE=${CCACHE_MAXSIZE:-3G}
export CCACHE_BASEDIR=$build_dir CCACHE_NOHASHDIR=1

announce() {
  # Measured: 16,232 steps took 95 minutes on 2 busy cores without Qt; the GUI adds about a third.
  local core_minutes=190 free_gb
  [ "$qt" = OFF ] || core_minutes=260
  free_gb=$(df -BG --output=avail "$build_dir" | tail -n 1 | tr -dc 0-9)
  cat <<END
ParaView $paraview_version from source: Qt $qt, MPI $mpi, window system $window
  source and objects  $build_dir
  install             $prefix
  time                about $((core_minutes / jobs + 1)) minutes with $jobs jobs, when nothing is built yet and the cores are free
  disk                about 5 GB in all (source 0.6, objects and ccache 3.5, install 0.5); $free_gb GB are free
END
  [ "$free_gb" -ge 6 ] || echo "build_paraview.sh: warning: less than 6 GB are free in $build_dir" >&2
}

install_packages() {
  local groups=(source-build)
  [ "$qt" = OFF ] || groups+=(source-build-qt)
  [ "$mpi" = OFF ] || groups+=(source-build-mpi)
  "$here/install_packages.sh" "${groups[@]}"
}

# Downloads and unpacks the source package. apt checks the archive's signature on the index of the
# release, and the index's hash on the tarball.
fetch_source() {
  if [ -e "$source_dir/.complete" ]; then
    echo "source: $(cat "$source_dir/.complete"), already there"
    return
  fi
  . /etc/os-release
  find_debian_mirror "${VERSION_CODENAME:-}" ||
    fail "apt knows no Debian mirror: no entry for '${VERSION_CODENAME:-?}' in its sources. Add one and run 'apt-get update'."

  local apt=$build_dir/apt version tarball
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$apt/parts"
  debian_source_entry deb-src "$source_suite" >"$apt/parts/source.sources"
  local options=(-q -o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$apt/parts" -o "Dir::State::lists=$apt/lists"
    -o "Dir::Cache=$apt/cache" -o "APT::Sandbox::User=$(id -un)" -o "Acquire::Languages=none" -o "Acquire::Retries=3")
  echo "source: asking $source_suite's index of source packages"
  apt-get "${options[@]}" --error-on=any update >"$apt/update.log" 2>&1 ||
    fail "cannot fetch $source_suite's index of source packages. No network, or the machine's mirror carries no sources.
$(grep -E '^(E|W|Err)' "$apt/update.log" | head -n 5)"
  version=$(apt-cache "${options[@]}" showsrc --only-source paraview 2>/dev/null |
    sed -n "s/^Version: \(${paraview_version}[+-].*\)/\1/p" | head -n 1)
  [ -n "$version" ] || fail "$source_suite's sources have no ParaView $paraview_version"
  echo "source: paraview $version"
  (cd "$build_dir" && apt-get "${options[@]}" source --download-only --tar-only "paraview=$version") ||
    fail "the download of paraview $version failed; run the same command again to go on"
  tarball=$(find "$build_dir" -maxdepth 1 -name "paraview_$paraview_version*.orig.tar.*" ! -name '*.asc' | head -n 1)
  rm -rf "$source_dir"
  mkdir -p "$source_dir"
  # Debian's patches are left out: they are about Debian's own file layout and shared libraries.
  tar -xf "$tarball" -C "$source_dir"
  # The tarball may or may not have one top folder.
  if [ ! -e "$source_dir/CMakeLists.txt" ]; then
    local top
    top=$(dirname "$(find "$source_dir" -mindepth 2 -maxdepth 2 -name CMakeLists.txt | head -n 1)")
    mv "$top" "$source_dir.top"
    rmdir "$source_dir"
    mv "$source_dir.top" "$source_dir"
  fi
  echo "paraview $version" >"$source_dir/.complete"
  rm -rf "$apt" "$tarball"
}

configure() {
  local x=ON egl=OFF
  [ "$window" = x11 ] || { x=OFF; egl=ON; }
  # RENDERING is the smallest edition with pvpython, views and plugins; only the GUI wants the canonical one.
  local edition=RENDERING
  # It reads XML files only and plays nothing; legacy VTK, STL, PLY and image files and animations are added.
  local additions=(-DVTK_MODULE_ENABLE_VTK_IOParallel=YES -DVTK_MODULE_ENABLE_VTK_IOGeometry=YES
    -DVTK_MODULE_ENABLE_VTK_IOPLY=YES -DVTK_MODULE_ENABLE_ParaView_VTKExtensionsIOImage=YES
    -DVTK_MODULE_ENABLE_ParaView_RemotingAnimation=YES)
  [ "$qt" = OFF ] || { edition=CANONICAL; additions=(); }
  cmake -S "$source_dir" -B "$objects" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    -DPARAVIEW_BUILD_EDITION=$edition -DPARAVIEW_USE_QT=$qt -DPARAVIEW_USE_MPI=$mpi \
    -DPARAVIEW_USE_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DPARAVIEW_USE_FORTRAN=OFF -DPARAVIEW_PLUGINS_DEFAULT=OFF \
    -DVTK_USE_X=$x -DVTK_OPENGL_HAS_EGL=$egl "${additions[@]}" \
    >"$build_dir/configure.log" 2>&1 || fail "cmake failed; the end of $build_dir/configure.log:
$(tail -n 15 "$build_dir/configure.log")"
  echo "configure: done, see $build_dir/configure.log"
}

announce
install_packages
fetch_source
configure
[ "$configure_only" = no ] || exit 0
export NINJA_STATUS='[%f/%t %p %es] '
ninja -C "$objects" -j "$jobs" || fail "the build stopped; run the same command again to go on where it was"
ninja -C "$objects" install >"$build_dir/install.log" 2>&1 || fail "the install failed; see $build_dir/install.log"

cmake_dir=$(find "$prefix" -name paraview-config.cmake -printf '%h\n' | head -n 1)
cat <<END
ParaView $paraview_version is in $prefix ($(du -sh "$prefix" | cut -f 1)); $build_dir ($(du -sh "$build_dir" | cut -f 1)) may be deleted.
Configure the plugin against it:
  cmake -S . -B build-paraview-$paraview_version -G Ninja -DCMAKE_BUILD_TYPE=Release -DParaView_DIR=$cmake_dir
END
