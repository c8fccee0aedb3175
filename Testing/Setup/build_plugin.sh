# To be sourced by demo.sh and test.sh, which set `clone`: configures and builds the plugin in clone/build, or
# against a ParaView built from source in clone/build-<its folder's name>.

# Sets build and pvpython. The first argument is the folder of a ParaView installation, or empty.
build_plugin() { # paraview-folder [CMAKE-OPTION...]
  local paraview=$1 options=("${@:2}")
  build=$clone/build
  pvpython=pvpython
  if [ -n "$paraview" ]; then
    [ -x "$paraview/bin/pvpython" ] || { echo "no ParaView in $paraview: bin/pvpython is missing" >&2; return 1; }
    paraview=$(cd "$paraview" && pwd)
    build=$clone/build-$(basename "$paraview")
    pvpython=$paraview/bin/pvpython
    options+=("-DParaView_DIR=$(dirname "$(find "$paraview" -name paraview-config.cmake | head -n 1)")")
    [ -x "$paraview/bin/paraview" ] || options+=(-DRTGLYPHS_USE_QT=OFF)
    # Linked against no X library: an EGL build, which needs no X server.
    if ! ldd "$(find "$paraview" -name 'libvtkRenderingOpenGL2*.so*' | head -n 1)" | grep -q libX11; then
      options+=(-DRTGLYPHS_TEST_XVFB=OFF)
      needs_display=no
    fi
  fi
  echo "== configure ($build)"
  # Debian's python3, for which ParaView and numpy are installed, not another one on the path.
  cmake -S "$clone" --preset release -B "$build" -DPython3_EXECUTABLE=/usr/bin/python3 "${options[@]}" >"$build.configure.log" 2>&1 || {
    tail -n 20 "$build.configure.log" >&2
    return 1
  }
  mv "$build.configure.log" "$build/configure.log"
  echo "== build"
  NINJA_STATUS='[%f/%t %es] ' ninja -C "$build" "${build_targets[@]}" || return 1
  plugin=$(find "$build" -name RayTracedGlyphs.so | head -n 1)
  [ -n "$plugin" ] || { echo "the build made no RayTracedGlyphs.so" >&2; return 1; }
  echo "== plugin ($plugin)"
}
needs_display=yes
build_targets=() # empty: all, the tests too
