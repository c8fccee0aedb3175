#!/usr/bin/env bash
# Packs a self-check of the kernels that runs on any x86-64 Linux with a Vulkan driver and nothing else installed, as old
# as the C library here: tests, a benchmark and pictures, without ParaView (Testing/SelfCheck).
# Usage: pack_self_check.sh [FILE.tar.xz]      default: build-self-check/rtglyphs-self-check.tar.xz
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
build=$clone/build-self-check
[[ $# -le 1 && "${1:-}" != -* ]] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
archive=$(realpath -m "${1:-$build/rtglyphs-self-check.tar.xz}")

cmake -S "$clone" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRTGLYPHS_KERNELS_ONLY=ON \
  "-DCMAKE_EXE_LINKER_FLAGS=-static-libstdc++ -static-libgcc" '-DCMAKE_BUILD_RPATH=$ORIGIN/../lib' >"$build.log" || {
  tail -n 20 "$build.log" >&2
  exit 1
}
mv "$build.log" "$build/configure.log"
ninja -C "$build"

folder=$build/rtglyphs-self-check
rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/lib/loader"
cp "$clone/Testing/SelfCheck/run.sh" "$clone/Testing/SelfCheck/images.sha256" "$folder"
git -C "$clone" describe --always --dirty >"$folder/version" 2>/dev/null || echo unknown >"$folder/version"
# FaultTest and LackingDeviceTest need a Vulkan layer of their own.
for program in "$build"/bin/*Test "$build"/bin/SelfCheck*; do
  case "$(basename "$program")" in
    FaultTest | LackingDeviceTest) ;;
    *) strip -o "$folder/bin/$(basename "$program")" "$program" ;;
  esac
done
# What is not in every Linux comes along; the Vulkan loader only for machines without one.
libraries=$(ldd "$folder"/bin/* | awk '/=> \// { print $3 }' | sort -u)
for library in $libraries; do
  case "$(basename "$library")" in
    libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | ld-linux*) ;;
    libquadmath.so.*) cp -L "$library" "$folder/lib" ;;
    *) echo "FAILED: the programs need $library" >&2; exit 1 ;;
  esac
done
loader=$(ldconfig -p | awk '/libvulkan\.so\.1 .*x86-64/ && !found++ { print $NF }')
[ -n "$loader" ] || { echo "FAILED: no libvulkan.so.1 here (Debian: libvulkan1)" >&2; exit 1; }
cp -L "$loader" "$folder/lib/loader/libvulkan.so.1"

# Programs embed the same shaders: a dictionary larger than two of them finds that.
tar -C "$build" -c rtglyphs-self-check | xz -T1 -6e --lzma2=preset=6e,dict=64MiB >"$archive"
bytes=$(stat -c %s "$archive")
echo "$archive: $((bytes / 1000000)) MB"
[ "$bytes" -lt 60000000 ] || { echo "FAILED: more than 60 MB" >&2; exit 1; }
