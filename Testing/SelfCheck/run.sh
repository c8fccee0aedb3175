#!/bin/sh
# Tests, measures and shows ray-traced glyphs on this machine's Vulkan device. Needs a Vulkan driver
# and nothing else. Everything goes to the folder `results`; the last line is the verdict.
# Usage: run.sh [--short] [--structure tree|boxes]
#   --short      the most telling tests and a small benchmark: some minutes on a computer without a GPU
#   --structure  how rays find glyphs: by the kernels' own tree or by the driver's boxes; without: what the device does
#                best with
# Environment: RTGLYPHS_DEVICE, a number or a part of the name, chooses among devices.
cd "$(dirname "$0")" || exit 2
short=no
while [ $# -gt 0 ]; do
  case "$1" in
    --short) short=yes ;;
    --structure) [ $# -gt 1 ] || { echo "run.sh: --structure needs tree or boxes" >&2; exit 2; }
      RTGLYPHS_STRUCTURE=$2; export RTGLYPHS_STRUCTURE; shift ;;
    *) sed -n '2,9s/^# \{0,1\}//p' "$0"; exit 2 ;;
  esac
  shift
done

# The machine's own Vulkan loader where there is one, else the one that comes along.
device=$(bin/SelfCheck device 2>/dev/null) || {
  LD_LIBRARY_PATH=$PWD/lib/loader${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
  export LD_LIBRARY_PATH
  device=$(bin/SelfCheck device) || { echo "VERDICT: FAILED. There is no device that can trace rays."; exit 1; }
}
results=results
mkdir -p "$results/pictures"
{
  echo "device     $device"
  echo "structure  ${RTGLYPHS_STRUCTURE:-what the device does best with}"
  echo "processor  $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc 2>/dev/null) cores"
  echo "kernel     $(uname -sr)"
  echo "version    $(cat version)"
} | tee "$results/machine.txt"

failed=
passed=0
# check NAME COMMAND...: runs it with its output in a file; one line says how it went
check() {
  name=$1
  shift
  began=$(date +%s)
  if "$@" >"$results/$name.log" 2>&1; then
    how=passed
    passed=$((passed + 1))
  else
    how=FAILED
    failed="$failed $name"
  fi
  printf '%-24s %-7s %5d s\n' "$name" "$how" $(($(date +%s) - began))
}

echo
echo "== tests"
if [ "$short" = yes ]; then
  check ParallelTest bin/ParallelTest
  check GlyphBoxesTest bin/GlyphBoxesTest
  check GlyphTreeTest bin/GlyphTreeTest
  check TracerTest bin/TracerTest
  check TranslucencyTest bin/TranslucencyTest
  check MeshTest bin/MeshTest
  check PositionsTest bin/PositionsTest
  check PipelineNumericsTest bin/PipelineNumericsTest '--gtest_filter=-Nested/*'
else
  for test in bin/*Test; do
    # Third-party data do not come along.
    check "$(basename "$test")" "$test" '--gtest_filter=-*.TeemsTable'
  done
fi

echo
echo "== benchmark (one sample a pixel; higher is better but for the last two columns)"
effort=full
[ "$short" = no ] || effort=short
# The exit status of a pipe is that of its end.
{ bin/SelfCheck benchmark $effort "$results/benchmark.csv" 2>&1 || echo "FAILED"; } | tee "$results/benchmark.txt"
if grep -q FAILED "$results/benchmark.txt"; then
  failed="$failed benchmark"
fi

echo
echo "== pictures"
size= # the program's own width and samples
[ "$short" = no ] || size="300 4"
# shellcheck disable=SC2086
check demonstration bin/SelfCheck demonstration "$results/pictures" $size
cat "$results/demonstration.log"

echo
echo "== SHA-256 of images, the same wherever rounding is"
mkdir -p "$results/images"
check images bin/SelfCheckImages "$results/images"
(cd "$results/images" && sha256sum ./*.raw) >"$results/images.sha256"
others=$(sort images.sha256 "$results/images.sha256" | uniq -u | sed 's/.*\///; s/\.raw$//' | sort -u | tr '\n' ' ')
echo "of $(wc -l <images.sha256) images these differ from images.sha256: ${others:-none}"

echo
for log in $failed; do
  [ ! -f "$results/$log.log" ] || { echo "== $results/$log.log"; tail -n 20 "$results/$log.log"; }
done
if [ -z "$failed" ]; then
  echo "VERDICT: passed. $passed checks and the benchmark on $device."
else
  echo "VERDICT: FAILED on $device:$failed. Please send the folder $results."
  exit 1
fi
