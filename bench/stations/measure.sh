#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Times `check` on the stations of this folder: bench/stations/measure.sh [PROGRAM [SECONDS [OPTION...]]].
# For each station, checks all properties in one run with default options, and then each property in a separate run.
# PROGRAM is build/release/bin/grafverif; each run may use SECONDS (60) and 2 GiB; options are passed to `check`. Each
# output line contains the elapsed seconds and the summary of a run.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${1:-build/release/bin/grafverif} limit=${2:-60}
shift $(($# < 2 ? $# : 2))
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run NAME OPTIONS...: prints one line about one run
run() {
    local name=$1 begin end
    shift
    begin=$(date +%s%N)
    "$program" check "$@" --timeout "${limit}s" --max-memory 2G >"$folder/out" 2>"$folder/err" || true
    end=$(date +%s%N)
    printf '%-40s %6s s  %s\n' "$name" "$(bc <<<"scale=1; $((end - begin)) / 1000000000")" "$(grep -E '^[^ ]+: .*(holds?|violated|unknown|no properties)' "$folder/out" | tail -1)"
}

for station in bench/stations/*.grafcet; do
    run "$(basename "$station")" "$station" "$@"
    "$program" check "$station" --list | cut -f3 | while read -r property; do
        run "    $property" "$station" --property "$property" "$@"
    done
done
