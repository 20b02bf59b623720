# SPDX-License-Identifier: MIT
"""Compares tuning, fault analyses and recordings of the module with the output of the program."""
import csv
import datetime
import json
import os
import pathlib
import re
import subprocess
import warnings

import grafverif
import pytest

root = pathlib.Path(__file__).parents[2]


def printed(*arguments):
    return subprocess.run([os.environ["GRAFVERIF_PROGRAM"], *map(str, arguments)], capture_output=True, text=True,
                          check=False).stdout


def block_of(page):
    """Returns the first text in the text language on a page of the documentation."""
    return re.search(r"```grafcet\n(.*?)```", (root / "docs/how-to" / page).read_text(), re.DOTALL).group(1)


@pytest.fixture(name="press")
def press_of_the_page(tmp_path):
    file = tmp_path / "press.grafcet"
    file.write_text(block_of("tune.md"))
    return file


@pytest.fixture(name="driveway")
def driveway_of_the_page(tmp_path):
    file = tmp_path / "driveway.grafcet"
    file.write_text(block_of("faults.md"))
    return file


@pytest.fixture(name="pump")
def pump_of_the_page(tmp_path):
    file = tmp_path / "pump.grafcet"
    file.write_text(block_of("check-recordings.md"))
    return file


def test_tuning_is_that_of_the_program(press):
    tuning = grafverif.read(press).loop().tune({"RAM": ("1s", "9s", "2s"), "CLOSING": "1s..9s"})
    arguments = ["tune", press, "--over", "RAM=1s..9s:2s", "--over", "CLOSING=1s..9s"]
    assert tuning.document == json.loads(printed(*arguments, "--format", "json"))
    assert str(tuning) == printed(*arguments) and tuning.points == 45
    prompt = tuning["prompt"]
    for ram in range(1, 10, 2):
        for closing in range(1, 10):
            verdict = grafverif.read(press, constants={"RAM": f"{ram}s", "CLOSING": f"{closing}s"}).loop().check("prompt")
            assert prompt.at(RAM=f"{ram}s", CLOSING=datetime.timedelta(seconds=closing)) == verdict["prompt"].verdict
    assert [(each.constant, each.value, each.verdict) for each in prompt.margins] == [
        ("RAM", "7s", "violated"), ("CLOSING", "6s", "violated")]
    assert sum(each.points for each in prompt.boxes) == 45 and prompt.current == "holds"


def test_points_outside_of_the_grid_and_wrong_ranges_are_rejected(press):
    loop = grafverif.read(press).loop()
    prompt = loop.tune({"RAM": ("1s", "3s")}, "prompt")["prompt"]
    for values in ({"RAM": "4s"}, {}, {"RAM": "1s", "CLOSING": "1s"}):
        with pytest.raises(grafverif.NotFoundError):
            prompt.at(**values)
    coarse = loop.tune({"RAM": ("1s", "5s", "2s")}, "prompt")["prompt"]
    assert coarse.at(RAM="3s") == "holds"
    for between in ("2s", "1500ms", "7s"):
        with pytest.raises(grafverif.NotFoundError, match="not a point of the grid"):
            coarse.at(RAM=between)
    for value, error in ((2000, TypeError), (True, TypeError), (2.0, TypeError), ("2", ValueError), ("s", ValueError),
                         (datetime.timedelta(milliseconds=1500, microseconds=1), ValueError)):
        with pytest.raises(error, match="`RAM` must be"):
            prompt.at(RAM=value)
    assert prompt.at(RAM="3000ms") == prompt.at(RAM=datetime.timedelta(seconds=3)) == prompt.at(RAM="3s")
    with pytest.raises(TypeError, match="no truth value"):
        bool(prompt)
    with pytest.raises(ValueError, match="range"):
        loop.tune({"RAM": ("1s",)})
    with pytest.raises(grafverif.GrafverifError, match="did you mean `RAM`"):
        loop.tune({"RAN": ("1s", "3s")})
    with pytest.raises(ValueError, match="`RAM` is in both over and constants"):
        grafverif.read(press, constants={"RAM": "2s"}).loop().tune({"RAM": ("1s", "3s")})
    with pytest.raises(ValueError, match="over must contain a constant"):
        loop.tune({})
    unfinished = loop.tune({"RAM": ("1s", "9s")}, timeout=0)["prompt"]
    assert {(each.verdict, each.reason) for each in unfinished.boxes} == {("unknown", "time limit reached")}


def test_an_integer_constant_has_only_integers():
    line = grafverif.parse("grafcet c { input A[1]; initial step 0; step 1; transition t: 0 -> 1 when A[1]; }\n"
                           "closed_loop l { constant N = 1; controller c; for i in 1..N { environment E[i] = "
                           "free(OUT = A[i]); } property p: never X0 && X1; }").loop()
    held = line.tune({"N": (1, 1)})["p"]
    assert held.at(N=1) == "holds"
    for value in ("1", "1s", True, 1.0, datetime.timedelta(milliseconds=1)):
        with pytest.raises(TypeError, match="`N` must be an int"):
            held.at(N=value)
    with pytest.raises(ValueError, match="multiple of 1 ms"):
        grafverif.parse("", constants={"T": datetime.timedelta(microseconds=1)})


def test_faults_are_those_of_the_program(driveway):
    analysis = grafverif.read(driveway).loop().faults(order=2)
    assert analysis.document == json.loads(printed("faults", driveway, "--order", "2", "--format", "json"))
    assert str(analysis) == printed("faults", driveway, "--order", "2")
    [pair] = analysis["safe"].combinations
    assert pair.faults == ("First_1", "Second_1") and pair.minimal and pair.trace.steps[-1].outputs["GREEN"]
    assert str(pair.trace) in printed("faults", driveway, "--order", "2", "--verbose")
    assert [(each.faults, each.trace) for each in analysis["used"].combinations] == [
        (("Motor_dead",), None), (("First_0",), None), (("Second_0",), None)]
    assert analysis.faults[0].violates == ("used",) and "WARNING" in analysis.faults[0].newly_true
    with pytest.raises(TypeError, match="no truth value"):
        bool(analysis["safe"])


def test_limits_and_wrong_requests_of_a_fault_analysis(driveway, press):
    loop = grafverif.read(driveway).loop()
    assert loop.faults("safe", timeout=0)["safe"].without_faults == "unknown"
    for order in (9, 0, -1):
        with pytest.raises(ValueError, match=rf"order must be in 1\.\.8; got {order}"):
            loop.faults(order=order)
    with pytest.raises(grafverif.GrafverifError, match="fault"):
        grafverif.read(press).loop().faults()


def added(recording, log):
    """Adds the samples of a CSV log to a recording and returns the result of each call."""
    with open(log, encoding="utf-8") as file:
        return [recording.add(float(row.pop("time")), {name: int(value) for name, value in row.items() if value})
                for row in csv.DictReader(file)]


@pytest.mark.parametrize("log", ["pump_log", "pump_late"])
def test_samples_have_the_verdict_of_replay(pump, log):
    path = root / f"docs/{log}.csv"
    recording = grafverif.read(pump).recording()
    added(recording, path)
    report = recording.finish()
    expected = json.loads(printed("replay", pump, "--log", path, "--format", "json"))
    for key in ("samples", "from", "to", "jitter", "undecided", "stopped", "properties"):
        assert report.document[key] == expected[key], key
    [verdict], [of_program] = report.verdicts, expected["charts"]
    assert verdict.verdict == of_program["verdict"] == {"pump_log": "conforms", "pump_late": "deviates"}[log]
    if of_program["deviation"]:
        assert verdict.time == of_program["deviation"]["time"] and verdict.output == "HORN"
        assert verdict.document["deviation"]["trace"] == of_program["deviation"]["trace"]
        assert str(verdict.trace) in str(report) and len(verdict.trace) == 4
    assert recording.finish() is report


def test_a_deviation_is_reported_while_samples_arrive(pump):
    recording = grafverif.read(pump).recording("pump", jitter=datetime.timedelta(milliseconds=20), stop_early=True)
    assert recording.add(0, START=False, STOP=False, PUMP=False, HORN=False)
    assert recording.add(1, START=True)
    assert recording.add(1.01, PUMP=True)
    answers = [recording.add(1.1 + k / 10) for k in range(40)]
    assert answers[0] and not answers[-1] and answers.index(False) >= 28
    verdict = recording.finish()["pump"]
    assert verdict.verdict == "deviates" and verdict.output == "PUMP"
    assert 3.9 < verdict.time < 4.2


def test_the_offset_of_a_clock_is_found(pump):
    path = root / "docs/pump_clock.csv"
    recording = grafverif.read(pump).recording(skew={("PUMP", "HORN"): 0.5})
    added(recording, path)
    [verdict] = recording.finish()
    expected = json.loads(printed("replay", pump, "--log", path, "--skew", "PUMP,HORN=500ms", "--format", "json"))
    assert verdict.verdict == "conforms" and verdict.offsets == expected["charts"][0]["offsets"]
    [offset] = verdict.offsets
    assert offset["columns"] == ["PUMP", "HORN"] and offset["low"] < 0.3 < offset["high"] < 0.4
    with pytest.raises(ValueError, match="skew"):
        grafverif.read(pump).recording(skew={"PUMP": -1})
    with pytest.raises(grafverif.GrafverifError, match="PUMPE"):
        grafverif.read(pump).recording(skew={"PUMPE": 1}).add(0, START=False, STOP=False, PUMP=False, HORN=False)


def test_each_warning_of_a_recording_is_issued_once():
    text = (root / "tests/diagnostics/forced-differently.grafcet").read_text()
    text = text.replace("input STOP, HOLD;", "input STOP, HOLD; output LAMP, HORN;")
    file = grafverif.parse(text.replace("step 21;", "step 21 { LAMP; HORN; }"))
    with pytest.warns(UserWarning) as at_construction:
        recording = file.recording()
    with pytest.warns(UserWarning) as at_first_sample:
        recording.add(0, STOP=False, HOLD=False, LAMP=False)
    assert [str(each.message)[-20:] for each in at_construction] == ["[forced-differently]"]
    assert ["HORN" in str(each.message) for each in at_first_sample] == [True]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        recording.add(1, HOLD=False)


def test_the_end_of_a_check_ends_the_check_of_properties(pump):
    text = pump.read_text() + ("closed_loop l { controller pump; environment S = free(OUT = START); environment T = "
                               "free(OUT = STOP); property p: never PUMP && HORN; }")
    recording = grafverif.parse(text).recording("pump")
    recording.add(0, START=False, STOP=False, PUMP=False, HORN=False)
    recording.add(1, PUMP=True)
    assert not recording.add(2)
    assert not recording.add(3, HORN=True) and not recording.add(5)
    report = recording.finish()
    assert report["pump"].verdict == "deviates" and not report.properties[0]["violated"] and report.samples == 3
    assert "property p: not violated by these samples" in str(report)


def test_wrong_samples_are_rejected(pump):
    file = grafverif.read(pump)
    with pytest.raises(TypeError, match="START"):
        file.recording().add(0, START="on")
    with pytest.raises(grafverif.GrafverifError, match="STOP"):
        file.recording().add(0, START=True, PUMP=False)
    backwards = file.recording()
    with pytest.warns(UserWarning, match="HORN"):
        backwards.add(1, START=False, STOP=False, PUMP=False)
    with pytest.raises(grafverif.GrafverifError, match="time"):
        backwards.add(0.5, START=True)
    with pytest.raises(KeyError):
        file.recording("pumps")
    with pytest.raises(ValueError, match="jitter"):
        file.recording(jitter=-1)
    mapped = file.recording(map={"%I0": "START"})
    assert mapped.add(0, {"%I0": True, "STOP": 0, "PUMP": False, "HORN": False})


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def test_a_certificate_is_that_of_the_program(driveway, tmp_path):
    loop = grafverif.read(driveway).loop()
    report = loop.check(certificate=tmp_path / "python")
    printed("check", driveway, "--certificate", tmp_path / "program")
    written = contents(tmp_path / "python")
    assert written == contents(tmp_path / "program") and "certificate.txt" in written
    assert report.certificate == {"folder": str(tmp_path / "python"), "omitted": [],
                                  "certified": ["safe", "reported", "used", "alive", "no_timelock"]}
    document = json.loads(printed("check", driveway, "--certificate", tmp_path / "program", "--format", "json"))
    assert document["certificate"] == {**report.certificate, "folder": str(tmp_path / "program")}
    assert loop.check().certificate is None


def test_a_certificate_names_unknown_verdicts(driveway, tmp_path):
    report = grafverif.read(driveway).loop().check("safe", states=10, certificate=tmp_path / "few")
    assert report.certificate["certified"] == []
    assert {"property": "safe", "reason": "the verdict is unknown"} in report.certificate["omitted"]
