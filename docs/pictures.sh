#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the pictures of the documents: docs/pictures.sh GRAFVERIF (such as build/run/bin/grafverif). GRAFVERIF draws the
# samples and the chart of the tutorial; Chromium makes the pictures of the players in the README and in the tutorial.
set -euo pipefail
grafverif=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in samples/*/*.grafcet; do
    grep -q '^grafcet ' "$file" || continue  # a loop of a PLC program has no chart
    "$grafverif" draw "$file" -o "${file%.grafcet}.svg"
done
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
(cd "$work" && "$grafverif" init press --quiet)
"$grafverif" draw "$work/press/press_controller.grafcet" -o docs/tutorials/press_chart.svg
sed -n '/^```grafcet$/,/^```$/{/^```/d;p}' docs/tutorials/read-a-counterexample.md >"$work/press.grafcet"
export GRAFVERIF_PROGRAM=$grafverif
GRAFVERIF_SCREENSHOTS=$work tests/browser/run edit_test.py Edit.test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader
cp "$work/edit-laptop-light.png" docs/edit.png
tests/browser/run picture.py "$PWD/docs/blinker_pressed.grafcet" answered/10 "$PWD/docs/player.png"
tests/browser/run picture.py "$work/press.grafcet" guarded/4 "$PWD/docs/tutorials/press_player.png"
