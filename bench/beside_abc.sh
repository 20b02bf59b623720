#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engines for properties about states beside each other and beside ABC, a property at a time: transfer lines of 4, 16, 32
# and 50 cells, and long threads of the samples. bench/beside_abc.sh [BUILD [SECONDS]]. BUILD (build/release) has
# bench_engine and bench_states; berkeley-abc is on the PATH; what takes more than SECONDS (60) of the clock is ended.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release} most=${2:-60}
command -v berkeley-abc >/dev/null || { echo "berkeley-abc is not on the PATH" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# rows NAME FILE PROPERTY...
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
