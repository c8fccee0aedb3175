#!/usr/bin/env bash
# Builds and runs the kernels' tests and the self-check, without ParaView, with another compiler or for another system.
# What is missing is installed with apt, as root or with sudo.
# Usage: build_kernels.sh COMPILER [TEST...]     the named programs only, in build-COMPILER
#   g++-10, g++-11, ...           g++-10 comes from Debian 11
#   clang++-19                    with its libc++; needs SPIRV-Tools built with it, in a folder that CMAKE_PREFIX_PATH names
#   x86_64-w64-mingw32-g++-posix  for Windows; programs run under wine, which hands Vulkan to this system's driver. Needs
#                                 SPIRV-Tools in the same way
#   aarch64-linux-gnu-g++         for aarch64; programs run under qemu with the driver, and are linked with the SPIRV-Tools,
#                                 of a chroot of this system's release (README.md)
# Example: build_kernels.sh g++-10 TracerTest SelfCheck
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
. "$here/debian_mirror.sh"
. /etc/os-release
[[ $# -ge 1 && "$1" != -* ]] || { sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2; exit 2; }
compiler=$1
shift
build=$clone/build-$compiler
prefix=$build/prefix

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo --preserve-env=DEBIAN_FRONTEND "$@"; fi
}
export DEBIAN_FRONTEND=noninteractive

packages=(cmake ninja-build g++ libvulkan-dev glslang-tools spirv-tools libglm-dev googletest mesa-vulkan-drivers vulkan-validationlayers)
options=()
suite=
case "$compiler" in
  g++-*)
    packages+=("$compiler")
    [ "$compiler" != g++-10 ] || suite=bullseye ;;
  clang++-*)
    version=${compiler#clang++-}
    packages+=("clang-$version" "libc++-$version-dev" "libc++abi-$version-dev")
    # <quadmath.h> is GCC's.
    options=("-DCMAKE_CXX_FLAGS=-stdlib=libc++ -idirafter $(g++ -print-file-name=include)") ;;
  x86_64-w64-mingw32-*)
    packages+=(g++-mingw-w64-x86-64-posix wine64 wine xvfb xauth)
    options=(-DCMAKE_SYSTEM_NAME=Windows -DCMAKE_EXE_LINKER_FLAGS=-static
      "-DCMAKE_CROSSCOMPILING_EMULATOR=env;WINEPREFIX=$build/wine;WINEDEBUG=-all;xvfb-run;-a;wine") ;;
  aarch64-linux-gnu-*)
    packages+=(g++-aarch64-linux-gnu qemu-user-static)
    chroot=$clone/build-chroot-$VERSION_CODENAME-arm64
    spirv=$chroot/usr/lib/aarch64-linux-gnu/cmake/SPIRV-Tools
    # The compiler's own libraries go into the programs.
    options=("-DCMAKE_EXE_LINKER_FLAGS=-static-libstdc++ -static-libgcc" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
      "-DSPIRV-Tools_DIR=$spirv" "-DSPIRV-Tools-opt_DIR=$spirv-opt"
      "-DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64-static;-L;$chroot;-E;VK_ICD_FILENAMES=$(cd "$chroot" && printf /%s usr/share/vulkan/icd.d/lvp_icd*)") ;;
  *) echo "build_kernels.sh: unknown compiler '$compiler'; see the head of this file" >&2; exit 2 ;;
esac

installed() { [ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null)" = "ii " ]; }
missing=()
for package in "${packages[@]}"; do installed "$package" || missing+=("$package"); done
if [ ${#missing[@]} -gt 0 ]; then
  entry=/etc/apt/sources.list.d/raytracedglyphs-older.sources
  if [ -n "$suite" ]; then
    trap 'as_root rm -f "$entry"' EXIT
    find_debian_mirror "${VERSION_CODENAME:-}"
    debian_source_entry deb "$suite" | as_root tee "$entry" >/dev/null
  fi
  as_root apt-get -q update
  as_root apt-get -qy install --no-install-recommends "${missing[@]}"
fi

# Headers without the others of /usr/include, and GoogleTest of the same compiler.
mkdir -p "$prefix/include" "$prefix/share/cmake"
cp -a /usr/include/{glm,vulkan,vk_video} "$prefix/include"
cp -a /usr/share/cmake/glm "$prefix/share/cmake"
c_compiler=${compiler/clang++/clang}
common=(-G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=$compiler" "-DCMAKE_C_COMPILER=${c_compiler/g++/gcc}"
  "-DCMAKE_PREFIX_PATH=$prefix" "-DCMAKE_FIND_ROOT_PATH=$prefix" "${options[@]}")
cmake -S /usr/src/googletest -B "$build/googletest" "${common[@]}" "-DCMAKE_INSTALL_PREFIX=$prefix" -DBUILD_GMOCK=OFF
ninja -C "$build/googletest" install
# Vulkan_LIBRARY: nothing links it, but CMake looks for it.
cmake -S "$clone" -B "$build" "${common[@]}" -DRTGLYPHS_KERNELS_ONLY=ON -DRTGLYPHS_WARNINGS_AS_ERRORS=ON \
  -DCMAKE_UNITY_BUILD=ON "-DVulkan_INCLUDE_DIR=$prefix/include" -DVulkan_LIBRARY=unused
ninja -C "$build" "$@"
if [ $# = 0 ]; then
  ctest --test-dir "$build" --output-on-failure -L kernels -LE long
else
  ctest --test-dir "$build" --output-on-failure -R "^($(IFS='|'; echo "$*"))\$"
fi
