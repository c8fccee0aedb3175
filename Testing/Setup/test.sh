#!/usr/bin/env bash
# The default suite of tests, from a bare Debian 12, 13 or testing as root or with sudo: installs what is missing, builds the plugin into build/
# and runs ctest, whose summary comes last. Failed pictures lie in build/Testing/Regression.
# Usage: test.sh [--paraview DIR] [--strict] [--long] [CTEST-OPTION...]     DIR: a ParaView made by build_paraview.sh
# --strict: warnings of the compiler are errors.
# --long: also the tests labeled "long": leaks over thousands of steps, more rays, and the kernels as on a GPU.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
. "$here/build_plugin.sh"

paraview= build_options=() selection=(-LE long) ctest_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --paraview) [ $# -gt 1 ] || { echo "test.sh: --paraview needs a folder" >&2; exit 2; }; paraview=$2; shift ;;
    --strict) build_options+=(-DRTGLYPHS_WARNINGS_AS_ERRORS=ON) ;;
    --long) selection=() ;;
    -h | --help) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    *) ctest_options+=("$1") ;;
  esac
  shift
done

echo "== packages"
"$here/install_packages.sh" build gui test
build_plugin "$paraview" "${build_options[@]}"
echo "== tests"
cd "$build"
ctest --output-on-failure -j "$(nproc)" "${selection[@]}" "${ctest_options[@]}"
