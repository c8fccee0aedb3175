#!/usr/bin/env bash
# Formats all C++ and GLSL as .clang-format says, or with --check lists what is not so formatted. Versions of clang-format
# differ in details: this takes version 14, which Debian 12 has. Without it, --check is skipped with exit status 77.
# Usage: format.sh [--check]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
check=no
case "${1:-}" in
  '') ;;
  --check) check=yes ;;
  *) sed -n '2,4s/^# //p' "Testing/Setup/format.sh" >&2; exit 2 ;;
esac
program=$(command -v clang-format-14) || {
  echo "SKIPPED: no clang-format-14; on Debian 12: apt-get install clang-format-14"
  [ "$check" = yes ] && exit 77 || exit 1
}

mapfile -d '' files < <(find Kernels Plugin Representation Testing \
  \( -name '*.cxx' -o -name '*.h' -o -name '*.glsl' -o -name '*.comp' \) -type f -print0)
count=${#files[@]}
# Files of names that clang-format does not know are C++ to it, and so is GLSL.
status=0
said=$("$program" --dry-run --Werror "${files[@]}" 2>&1) || status=$?
mapfile -t wrong < <(sed -nE 's/^([^: ]+):[0-9]+:[0-9]+: error: code should be clang-formatted.*/\1/p' <<<"$said" | sort -u)
[ "$status" = 0 ] || [ "${#wrong[@]}" -gt 0 ] || { echo "FAILED: $said"; exit 1; }
[ "$check" = yes ] || [ "${#wrong[@]}" = 0 ] || "$program" -i "${wrong[@]}"

echo "$count files, ${#wrong[@]} $([ "$check" = yes ] && echo 'not formatted' || echo 'formatted anew')"
[ "$count" -gt 200 ] || { echo "FAILED: too few files found"; exit 1; }
[ ${#wrong[@]} = 0 ] || printf '  %s\n' "${wrong[@]}"
[ "$check" = no ] || [ ${#wrong[@]} = 0 ] || { echo "FAILED: Testing/Setup/format.sh formats them"; exit 1; }
