#!/usr/bin/env bash
# Simulation data to pictures, from a bare Debian 12, 13 or testing as root or with sudo: installs what is missing, builds the
# plugin into build/, renders Data/'s simulations as ray-traced glyphs into build/pictures. May be called again at any time.
# Usage: demo.sh [--paraview DIR]     DIR: a ParaView made by build_paraview.sh instead of the distribution's
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
. "$here/build_plugin.sh"

paraview=
while [ $# -gt 0 ]; do
  case "$1" in
    --paraview) [ $# -gt 1 ] || { echo "demo.sh: --paraview needs a folder" >&2; exit 2; }; paraview=$2; shift ;;
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    *) echo "demo.sh: unknown option '$1'; see --help" >&2; exit 2 ;;
  esac
  shift
done

echo "== packages"
"$here/install_packages.sh" build gui test
build_targets=(RayTracedGlyphs)
build_plugin "$paraview"

echo "== pictures"
display="$clone/Testing/Regression/display.sh"
on_display=()
if [ "$needs_display" = yes ]; then
  trap '"$display" stop "$build/display"' EXIT
  "$display" start "$build/display"
  on_display=("$display" run "$build/display")
fi
RTGLYPHS_PLUGIN=$plugin "${on_display[@]}" "$pvpython" "$clone/Testing/Pictures/cover.py" "$clone/Data" "$build/pictures" 1120 700
echo "The pictures are in $build/pictures"
