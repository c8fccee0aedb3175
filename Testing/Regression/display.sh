#!/usr/bin/env bash
# The tests' own X server. Usage: display.sh start FOLDER | stop FOLDER | run FOLDER COMMAND...
# start: an Xvfb on a free display, its number and process in FOLDER. run: COMMAND with DISPLAY set to it.
# -noreset: without it the server resets when its last client leaves, and the next one sometimes fails to connect.
set -euo pipefail
action=$1 folder=$2
shift 2
stop() {
  local process=none
  [ ! -s "$folder/xvfb.pid" ] || process=$(cat "$folder/xvfb.pid")
  # After a restart of the machine or in another chroot the number is another process's, maybe another folder's Xvfb.
  [ "$(readlink "/proc/$process/fd/1")" != "$(realpath -m "$folder/xvfb.log")" ] || kill "$process"
  rm -f "$folder/xvfb.pid" "$folder/xvfb.display"
}
case "$action" in
  start)
    mkdir -p "$folder"
    stop
    command -v Xvfb >/dev/null || { echo "display.sh: no Xvfb; apt-get install xvfb" >&2; exit 1; }
    setsid Xvfb -displayfd 3 -screen 0 1600x1200x24 -noreset -nolisten tcp \
      3>"$folder/xvfb.display" >"$folder/xvfb.log" 2>&1 </dev/null &
    echo $! >"$folder/xvfb.pid"
    for _ in $(seq 100); do
      [ ! -s "$folder/xvfb.display" ] || { echo "display :$(cat "$folder/xvfb.display")"; exit 0; }
      sleep 0.1
    done
    echo "display.sh: Xvfb did not start; see $folder/xvfb.log" >&2
    stop
    exit 1 ;;
  stop) stop ;;
  run)
    [ -s "$folder/xvfb.display" ] || { echo "display.sh: no X server; run 'display.sh start $folder' first" >&2; exit 1; }
    DISPLAY=:$(cat "$folder/xvfb.display") exec "$@" ;;
  *) echo "display.sh: unknown action '$action'" >&2; exit 2 ;;
esac
