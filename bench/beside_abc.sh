#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares the engines for state properties with each other and with ABC, one property at a time.
# Models: transfer lines of 4, 16, 32 and 50 cells, and properties of samples.
# Usage: bench/beside_abc.sh [BUILD [SECONDS]]. BUILD (build/release) contains bench_engine and bench_states;
# berkeley-abc must be on the PATH; each run is stopped after SECONDS (60) of real time.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release} most=${2:-60}
command -v berkeley-abc >/dev/null || { echo "berkeley-abc is not on the PATH" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# rows NAME FILE PROPERTY...: prints table rows for the properties of FILE
rows() {
    local name=$1 file=$2
    shift 2
    "$build/bench/bench_states" "$file" "$most" "$@" | sed "s/^/| $name /"
}

echo '| model | property | pdr | abc | bmc | symbolic | auto |'
echo '| --- | --- | --- | --- | --- | --- | --- |'
for cells in 4 16 32 50; do
    "$build/bench/bench_engine" line $cells text >"$folder/line.grafcet"
    rows "$cells cells" "$folder/line.grafcet" released_1 held_1 released_$((cells / 2)) no_out_of_range
done
rows 'testing station' samples/testing_station/testing_station.grafcet P15
rows 'pick and place' samples/pick_and_place/pick_and_place.grafcet P5_P11_P17 P5_P11_P18 all_steps.X17
