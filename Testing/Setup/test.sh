#!/usr/bin/env bash
# All tests, from a bare Debian 12, 13 or testing as root or with sudo: installs what is missing, builds the plugin into build/
# and runs ctest, whose summary comes last. Failed pictures lie in build/Testing/Regression.
# Usage: test.sh [--paraview DIR] [CTEST-OPTION...]     DIR: a ParaView made by build_paraview.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
. "$here/build_plugin.sh"

paraview= ctest_options=()
while [ $# -gt 0 ]; do
  case "$1" in
    --paraview) [ $# -gt 1 ] || { echo "test.sh: --paraview needs a folder" >&2; exit 2; }; paraview=$2; shift ;;
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    *) ctest_options+=("$1") ;;
  esac
  shift
done

echo "== packages"
"$here/install_packages.sh" build gui test
build_plugin "$paraview"
echo "== tests"
cd "$build"
ctest --output-on-failure -j "$(nproc)" "${ctest_options[@]}"
