#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares the symbolic engine with NuSMV with dynamic reordering: the processor seconds of one run of each program for
# all properties of a model.
# Usage: bench/beside_nusmv.sh [BUILD [SECONDS]]. BUILD (build/release) contains bench_symbolic; NuSMV must be on the
# PATH; each run is stopped after SECONDS (60) of processor time.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release} most=${2:-60}
command -v NuSMV >/dev/null || { echo "NuSMV is not on the PATH" >&2; exit 2; }
bench=$build/bench/bench_symbolic
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# seconds OUTPUT COMMAND...: prints the processor seconds of COMMAND, or `>` and the limit if COMMAND reached it
seconds() {
    local out=$1
    shift
    TIMEFORMAT='%U %S'
    { time OUT=$out bash -c 'ulimit -t "$0" && exec "$@" >"$OUT" 2>&1' "$most" "$@"; } 2>"$folder/time" || true
    tail -1 "$folder/time" |
        awk -v most="$most" '{ if ($1 + $2 >= most - 1) print ">" most; else printf "%.2f\n", $1 + $2 }'
}

# row WORDS...: prints a table row for these arguments of bench_symbolic
row() {
    local theirs ours states
    "$bench" "$@" nusmv >"$folder/model.smv"
    theirs=$(seconds "$folder/theirs" NuSMV -dynamic "$folder/model.smv")
    ours=$(seconds "$folder/ours" "$bench" "$@")
    states=$(sed -n 's/.*inputs: \([0-9]*\) states.*/\1/p' "$folder/ours")
    echo "| \`$*\` | $states | $ours | $theirs |"
}

echo '| model | states | ours | NuSMV |'
echo '| --- | --- | --- | --- |'
{
    for sample in blinker/blinker oven_door/oven_door tanks/tanks assembly_station/assembly_station \
        testing_station/testing_station testing_station/faulty pick_and_place/pick_and_place; do
        for schedule in interleaved synchronous sequenced; do row $sample.grafcet automata $schedule; done
    done
    row testing_station/testing_station.grafcet automata discrete
    row two automata discrete
    for count in 1 2 3 4; do row cylinders $count automata interleaved; done
    for count in 2 3; do row cylinders $count automata discrete; done
    for count in 1 2 3 4; do row line $count automata atomic; done
    for count in 2 8 16; do row stations $count; done
} | tee "$folder/rows"
awk -F'|' '{ gsub(/ /, "", $4); gsub(/ /, "", $5) }
    $4 !~ />/ { theirs = $5; sub(/>/, "", theirs); ratio += log(($4 < 0.01 ? 0.01 : $4) / (theirs < 0.01 ? 0.01 : theirs)); ++rows }
    END { printf "ours to NuSMV, geometric mean of %d models: %.2f\n", rows, exp(ratio / rows) }' "$folder/rows"
