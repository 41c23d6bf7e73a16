#!/bin/sh
# compare_cost.sh KERNEL WITH WITHOUT: runs both programs under callgrind, the one with the statements that make events
# and the one without, and requires that both execute the same number of instructions in the kernel.
set -eu
if ! command -v valgrind >/dev/null; then
  echo "valgrind is missing, without which nobody knows what observers cost. Install the Debian package valgrind." >&2
  exit 1
fi

# Instructions executed inside the functions named measured_...
instructions() {
  counts=$(mktemp)
  valgrind --tool=callgrind --callgrind-out-file="$counts" --toggle-collect="measured_$2*" "$1" "$2" \
    >/dev/null 2>"$counts.log" || { cat "$counts.log" >&2; exit 1; }
  sed -n 's/^totals: //p' "$counts"
  rm -f "$counts" "$counts.log"
}

with=$(instructions "$2" "$1")
without=$(instructions "$3" "$1")
echo "$1: $with instructions with observers in the sources, $without without"
[ "${with:-0}" -gt 0 ] && [ "$with" -eq "$without" ]
