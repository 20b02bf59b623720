#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the pictures of the documents: docs/pictures.sh GRAFVERIF (such as build/run/bin/grafverif). GRAFVERIF draws the
# samples and the chart of the tutorial; Chromium makes the pictures of pages in the README, the tutorial and the guides.
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
block() { sed -n '/^```grafcet$/,/^```$/{/^```/d;p}' "docs/$1" >"$work/$2.grafcet"; }
block tutorials/read-a-counterexample.md press
block how-to/tune.md clamp
block how-to/faults.md driveway
block how-to/check-recordings.md pump
export GRAFVERIF_PROGRAM=$grafverif
GRAFVERIF_SCREENSHOTS=$work tests/browser/run edit_test.py Edit.test_it_can_be_read_at_every_size_in_both_schemes_and_by_a_screen_reader
cp "$work/edit-laptop-light.png" docs/edit.png
picture() { tests/browser/run picture.py "$PWD/docs/$1.png" "${@:2}"; }
picture player answered/10 report "$PWD/docs/blinker_pressed.grafcet" -o
picture tutorials/press_player guarded/4 report "$work/press.grafcet" -o
picture tune_report tuning tune "$work/clamp.grafcet" --over RAM=1s..9s --over CLOSING=1s..9s --report
picture faults_report faults faults "$work/driveway.grafcet" --order 2 --report
picture recording_report pump/3 replay "$work/pump.grafcet" --log docs/pump_late.csv --report
picture certificate_report verdicts check "$PWD/samples/testing_station/testing_station.grafcet" \
    --certificate "$work/certificate" --report
