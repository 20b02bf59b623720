# SPDX-License-Identifier: MIT
"""Compares the results of the module with the output of the program."""
import datetime
import json
import os
import pathlib
import re
import subprocess
import xml.etree.ElementTree

import grafverif
import pytest

root = pathlib.Path(__file__).parents[2]
samples = root / "samples"
station = samples / "testing_station/faulty.grafcet"
tanks = samples / "tanks/tanks.grafcet"


def printed(*arguments):
    return subprocess.run([os.environ["GRAFVERIF_PROGRAM"], *map(str, arguments)], capture_output=True, text=True,
                          check=False).stdout


def withouttimes(page):
    """Returns the page without measured times."""
    return re.sub(r"\d+\.\d+ s\b|\"seconds\":[\d.e-]+", "", page)


def timeless(text):
    """Returns the JSON document without measured times and sizes."""
    def without(value):
        if isinstance(value, dict):
            return {key: without(each) for key, each in value.items() if key not in ("seconds", "bytes")}
        return [without(each) for each in value] if isinstance(value, list) else value

    return without(json.loads(text) if isinstance(text, str) else text)


@pytest.mark.parametrize("file", sorted(samples.glob("*/*.grafcet")), ids=lambda path: path.stem)
def test_a_file_has_its_charts_and_loops(file):
    read = grafverif.read(file)
    assert read.charts or "\nprogram " in file.read_text()
    assert all(name in repr(read) for name in [*read.charts, *read.loops])
    assert all(loop.properties for loop in read.loops.values())


WITH_CONSTANTS = """grafcet c {
    input B;
    output L;
    internal N: int 0..9;
    initial step 0;
    step 1 { L; }
    transition t0: 0 -> 1 when B && N < 9 do N := N + 1;
    transition t1: 1 -> 0 when 1s/X1 && !B;
}
closed_loop room {
    controller c;
    constant MOST: int 1..8 = 3, SHORT = 1s, STRICT = true;
    environment Button = push_button(OUT = B, GAP = SHORT);
    property few: never N > MOST && STRICT;
}
"""


def test_constants_are_set_as_the_program_sets_them(tmp_path):
    file = tmp_path / "room.grafcet"
    file.write_text(WITH_CONSTANTS)
    report = grafverif.read(file, constants={"STRICT": False, "MOST": 2, "SHORT": "2s"}).loop().check()
    assert report["few"].verdict == "holds"
    assert [each["value"] for each in report.document["constants"]] == [2, "2s", False]
    assert all(each["set"] for each in report.document["constants"])
    arguments = ["check", file, "--set", "STRICT=false", "--set", "MOST=2", "--set", "SHORT=2s", "--format", "json"]
    assert timeless(report.document) == timeless(printed(*arguments))
    assert grafverif.parse(WITH_CONSTANTS, constants={"MOST": 2}).loop().check()["few"].violated


def test_verdicts_are_those_of_the_program():
    report = grafverif.read(station).loop().check()
    assert timeless(report.document) == timeless(printed("check", station, "--format", "json"))
    assert report.as_expected and report["P16"].violated and report["P16"].as_expected and not report["P15"].violated
    assert str(report) == printed("check", station) and "counterexample" in str(report)


def test_verdicts_have_the_position_of_their_property():
    report = grafverif.read(station).loop().check("P16")
    text = station.read_text().splitlines()[report["P16"].line - 1]
    assert report["P16"].file == str(station) and text[report["P16"].column - 1:].startswith(("property", "P16"))
    assert f"{station}:{report['P16'].line}" in str(report)
    assert "property no_timelock" in station.read_text().splitlines()[report["no_timelock"].line - 1]


def test_a_verdict_has_no_truth_value():
    with pytest.raises(TypeError, match="no truth value"):
        bool(grafverif.read(station).loop().check("P15")["P15"])


def test_untimed_verdicts_are_those_of_the_program():
    read = grafverif.read(tanks)
    assert timeless(read.loop().check_untimed(schedule="synchronous").document) == timeless(
        printed("check", tanks, "--untimed", "--schedule", "synchronous", "--format", "json"))
    alone = read.chart().check_untimed()
    assert alone["reachable.X7"].holds and alone["stabilises"].violated


def test_a_trace_is_drawn_and_tabulated():
    trace = grafverif.read(station).loop().check("P16")["P16"].trace
    assert len(trace) > 20 and trace.steps[0].time_ms == 0 and trace[0].situation
    assert [step.time_ms for step in trace] == sorted(step.time_ms for step in trace)
    assert xml.etree.ElementTree.fromstring(trace._repr_svg_()).tag.endswith("svg")
    assert "H_Act" in str(trace)
    pandas = pytest.importorskip("pandas")
    table = trace.to_dataframe()
    assert isinstance(table, pandas.DataFrame) and len(table) == len(trace) and "V_G_OUT" in table.columns
    assert list(grafverif.read(station).loop().check().to_dataframe()["name"])[:2] == ["P15", "P16"]


def test_times_of_an_untimed_trace_are_numbers_of_steps():
    trace = grafverif.read(tanks).loop().check_untimed("back_to_rest")["back_to_rest"].trace
    moments = [moment["time"] for moment in trace.run["moments"]]
    assert len(trace) > 10 and not trace.run["timed"]
    assert [step.time_ms for step in trace] == [step.time for step in trace] == moments[:len(trace)]
    assert "cleared" in trace._repr_html_()


def test_automata_and_tests_are_those_of_the_program():
    chart = grafverif.read(tanks).chart()
    assert chart.automaton().document == json.loads(printed("automaton", tanks, "--format", "json"))
    assert chart.mealy(minimise=True).document == json.loads(printed("mealy", tanks, "--minimise", "--format", "json"))
    test = chart.test_sequence(mode="every-cycle", cover="locations")
    assert test.document == json.loads(
        printed("testgen", tanks, "--mode", "every-cycle", "--cover", "locations", "--format", "json"))
    assert len(test) == len(test.steps) > 1 and test.steps[0].sequence == 1
    assert chart.automaton().drawing and "<svg" in chart.automaton()._repr_svg_()


def test_an_analysis_is_that_of_the_program():
    door = samples / "oven_door/oven_door.grafcet"
    analysis = grafverif.read(door).chart().analyse()
    assert timeless(analysis.document) == timeless(printed("analyse", door, "--format", "json"))
    assert "action-race" in [each.code for each in analysis] and analysis.complete


@pytest.mark.filterwarnings("ignore:property")  # properties that an exported language cannot express
def test_models_and_drawings_are_those_of_the_program():
    read = grafverif.read(tanks)
    assert read.loop().uppaal() == printed("uppaal", tanks, "-o", "-")
    assert read.loop().nusmv(plant="automata") == printed("nusmv", tanks, "--plant", "automata", "-o", "-")
    assert read.chart().draw().svg == printed("draw", tanks, "-o", "-")
    assert read.chart().structured_text() == printed("st", tanks, "--format", "text")


def test_a_simulation_executes_and_undoes_commands():
    moved = grafverif.read(samples / "blinker/blinker.grafcet").chart().simulate()
    assert moved.now.situation == ("0",)
    moved.set(BUTTON=True)
    assert moved.now.situation == ("1",) and moved.now.outputs == {"LAMP": True}
    moved.wait(2)
    assert moved.now.situation == ("2",) and moved.now.time_ms == 2000
    moved.do("back")
    assert moved.now.situation == ("1",) and not moved.is_trial
    moved.do("force 0 on")
    assert moved.is_trial
    with pytest.raises(grafverif.SimulationError, match="NOTHING"):
        moved.set(NOTHING=True)


def test_a_script_gives_a_run():
    loop = grafverif.read(samples / "blinker/blinker.grafcet").loop()
    trace = loop.run("wait 1s\nBUTTON = true\nwait 2s\n")
    assert {"1"} <= {step for row in trace for step in row.situation} and trace.steps[-1].time_ms == 3000
    assert loop.simulate().wait(1).choices[0].command


def test_durations_have_one_unit():
    second = datetime.timedelta(seconds=1)
    simulation = grafverif.read(samples / "blinker/blinker.grafcet").loop().simulate().wait(second)
    assert simulation.set(BUTTON=True).wait(0.5 * 4).now.time == 3.0 and simulation.now.time_ms == 3000
    assert repr(simulation).startswith("<Simulation after 3 s:")
    constants = {"SHORT": 2 * second}
    report = grafverif.parse(WITH_CONSTANTS, constants=constants).loop().check("few", timeout=30 * second)
    assert [each["value"] for each in report.document["constants"]][1] == "2s" and not report["few"].unknown
    steps = grafverif.read(tanks).chart().test_sequence().steps
    assert all(step.wait == step.wait_ms / 1000 for step in steps)


def test_the_page_of_a_report_is_that_of_the_program(tmp_path):
    file = samples / "blinker/blinker.grafcet"
    report = grafverif.read(file).loop().check()
    report.save(tmp_path / "page.html", date="today")
    page = (tmp_path / "page.html").read_text()
    assert page.startswith("<!DOCTYPE html>") and page == report.to_html(date="today")
    of_program = printed("report", file, "--date", "today", "-o", "-")
    assert len(page) > 50000 and withouttimes(page) == withouttimes(of_program)
    alone = grafverif.read(file).chart().check_untimed().to_html()
    assert "blinker" in alone and "<svg" in alone
    bounded = report.to_html(date="today", timeout=0)
    assert "the chart analysis is incomplete (see Findings)" in bounded and "analysis is incomplete" not in page


def test_notebooks_show_tables_of_results():
    report = grafverif.read(station).loop().check()
    shown = report._repr_html_()
    assert "<td" in shown and "P16" in shown and "violated" in shown and "as expected" in shown
    assert "<svg" in report["P16"].trace._repr_html_()
    text = grafverif.parse("grafcet g { initial step 0; transition t: 0 -> 0 when true; }\n").chart().analyse()._repr_html_()
    assert "<table>" in text and "<script" not in text


def test_the_version_is_that_of_the_program():
    assert grafverif.__version__ in printed("--version")
