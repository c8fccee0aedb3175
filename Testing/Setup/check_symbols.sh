#!/usr/bin/env bash
# Prints which versions of the C and C++ libraries files ask for. Fails where one asks for a newer one than a limit, or
# for another library than those allowed: a plugin that is to be loaded elsewhere must not.
# Usage: check_symbols.sh [--limit NAME=VERSION]... [--only LIBRARY]... FILE...
#   --limit   GLIBC, GLIBCXX or CXXABI, the newest version that the system of the ParaView has
#   --only    a library that it has, such as 'libQt6*', beside those of C and C++; run paths then begin with $ORIGIN
# Example: the images of paraview.org's ParaView 6.0 to 6.2, which are Enterprise Linux 8
#   check_symbols.sh --limit GLIBC=2.28 --limit GLIBCXX=3.4.25 --limit CXXABI=1.3.11 --only 'libvtk*' --only 'libQt6*' *.so
set -euo pipefail
declare -A limit=([GLIBC]='' [GLIBCXX]='' [CXXABI]='')
only=()
while [ $# -gt 0 ]; do
  case "$1" in
    --limit | --only) [ $# -gt 1 ] || { echo "check_symbols.sh: $1 needs a value" >&2; exit 2; } ;;&
    --limit)
      [[ "$2" =~ ^(GLIBC|GLIBCXX|CXXABI)=[0-9.]+$ ]] || { echo "check_symbols.sh: '$2' is no limit; see the head of this file" >&2; exit 2; }
      limit[${2%%=*}]=${2#*=}; shift 2 ;;
    --only) only+=("$2"); shift 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] && [[ "$1" != -* ]] || { sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2; exit 2; }

failures=()
for file in "$@"; do
  table=$(objdump --private-headers "$file") # also tells that it is an ELF file
  for name in GLIBC GLIBCXX CXXABI; do
    newest=$(sed -nE "s/^.* ${name}_([0-9.]+)\$/\1/p" <<<"$table" | sort -V | tail -n 1)
    echo "$(basename "$file"): $name ${newest:-none}"
    if [ -n "${limit[$name]}" ] && [ "$(printf '%s\n' "$newest" "${limit[$name]}" | sort -V | tail -n 1)" != "${limit[$name]}" ]; then
      symbols=$(objdump --dynamic-syms "$file" | sed -nE "s/^.*\*UND\*.*${name}_$newest\)? +(.*)/\1/p" | head -n 3 | paste -s -d ' ')
      failures+=("$(basename "$file") asks for ${name}_$newest ($symbols ...), and the limit is ${limit[$name]}")
    fi
  done
  for library in $(sed -nE 's/^ *NEEDED +(.*)/\1/p' <<<"$table"); do
    known=no
    # shellcheck disable=SC2053
    for pattern in 'libc.so.*' 'libm.so.*' 'libdl.so.*' 'libpthread.so.*' 'librt.so.*' 'ld-linux*' 'libgcc_s.so.*' 'libstdc++.so.*' "${only[@]}"; do
      [[ "$library" != $pattern ]] || known=yes
    done
    [ "$known" = yes ] || [ ${#only[@]} = 0 ] || failures+=("$(basename "$file") needs $library")
  done
  path=$(sed -nE 's/^ *(RPATH|RUNPATH) +(.*)/\2/p' <<<"$table")
  echo "$(basename "$file"): run path ${path:-none}"
  for folder in ${path//:/ }; do
    [[ "$folder" = '$ORIGIN'* ]] || [ ${#only[@]} = 0 ] || failures+=("$(basename "$file") looks for libraries in $folder of the machine that built it")
  done
done
[ ${#failures[@]} = 0 ] || { printf 'FAILED: %s\n' "${failures[@]}" >&2; exit 1; }
