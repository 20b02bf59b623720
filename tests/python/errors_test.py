# SPDX-License-Identifier: MIT
"""Tests that invalid charts and invalid calls raise exceptions, and that long calls let other threads run and stop at
Ctrl-C."""
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import grafverif
import pytest

root = pathlib.Path(__file__).parents[2]
blinker = root / "samples/blinker/blinker.grafcet"
line = root / "samples/transfer_line/transfer_line.grafcet"


def test_a_mistake_has_its_place():
    with pytest.raises(grafverif.GrafverifError) as caught:
        grafverif.parse("grafcet g {\n    initial step 0;\n    transition t: 0 -> 7 when true;\n}\n", "mine")
    first = caught.value.diagnostics[0]
    assert (first.severity, first.file, first.line) == ("error", "mine", 3)
    assert first.code and "7" in first.message and "mine:3:" in str(caught.value)


def test_a_missing_file_is_named():
    with pytest.raises(grafverif.GrafverifError, match="no_such_file"):
        grafverif.read("no_such_file.grafcet")


@pytest.mark.parametrize("text", ["grafcet", "\0\0\0", "}" * 1000, "\ud7ff" * 10, "grafcet g { step"])
def test_damaged_text_is_refused(text):
    with pytest.raises(grafverif.GrafverifError):
        grafverif.parse(text).chart()._file.draw("g", "iec")


@pytest.mark.parametrize("name", ["", "/", "a" * 5000, "no/such/folder/x"])
def test_a_text_needs_no_file_for_its_name(name):
    text = "grafcet g { input i; initial step 0; transition t: 0 -> 0 when i; }"
    assert grafverif.parse(text, name).chart().name == "g"
    with pytest.raises(grafverif.GrafverifError, match="cannot-include"):
        grafverif.parse('include "no_such.grafcet";', name)


def test_constants_that_cannot_be_set_are_refused():
    text = "grafcet g { input i; initial step 0; transition t: 0 -> 0 when i; }\n"
    text += "closed_loop l { controller g; constant COUNT: int 1..8 = 2; environment E = push_button(OUT = i); }\n"
    for constants, said in (({"COUNTS": 3}, "did you mean `COUNT`"), ({"COUNT": 9}, "1..8"), ({"COUNT": "3s"}, "COUNT"),
                            ({"COUNT": True}, "COUNT")):
        with pytest.raises(grafverif.GrafverifError, match=said):
            grafverif.parse(text, constants=constants)
    for value in (1.5, None, [1]):
        with pytest.raises(TypeError, match="COUNT"):
            grafverif.parse(text, constants={"COUNT": value})
    with pytest.raises(grafverif.GrafverifError, match="no closed-loop constant"):
        grafverif.read(blinker, constants={"COUNT": 3})


@pytest.mark.parametrize("name", ["File", "Report", "Simulator", "_How", "_Bounds"])
def test_objects_of_the_core_cannot_be_made_without_a_value(name):
    made = getattr(grafverif._core, name)
    for make in (made, lambda: made.__new__(made), lambda: object.__new__(made), lambda: type("Sub", (made,), {})()):
        with pytest.raises(TypeError):
            make()


def test_nonsense_is_refused_by_name():
    read = grafverif.read(blinker)
    with pytest.raises(ValueError, match="every-cycle"):
        read.loop().check(mode="sometimes")
    with pytest.raises(ValueError, match="timeout"):
        read.loop().check(timeout=-1)
    with pytest.raises(ValueError, match="timeout"):
        read.loop().check(timeout=float("nan"))
    with pytest.raises(ValueError, match="schedule"):
        read.loop().check_untimed(schedule="never")
    with pytest.raises(grafverif.GrafverifError, match="P99"):
        read.loop().check("P99")
    with pytest.raises(KeyError, match="blinker"):
        read.chart("other")
    with pytest.raises(KeyError):
        read.loop().check()["P99"]
    for wrong in (None, 7, ["a"], {}):
        with pytest.raises(TypeError):
            grafverif.parse(wrong)
    with pytest.raises(grafverif.GrafverifError, match="UTF-8"):
        grafverif.parse(b"\xff")
    with pytest.raises(TypeError):
        read.loop().check(memory="much")
    with pytest.raises(TypeError):
        grafverif._core.File()


def test_every_error_of_grafverif_has_one_base():
    assert issubclass(grafverif.SimulationError, grafverif.GrafverifError)
    assert issubclass(grafverif.NotFoundError, grafverif.GrafverifError)
    read = grafverif.read(blinker)
    report = read.loop().check()
    for find in (lambda: read.chart("other"), lambda: read.loop("other"), lambda: report["P99"]):
        with pytest.raises(grafverif.NotFoundError, match="^unknown ") as caught:
            find()
        assert str(caught.value).startswith("unknown ") and caught.value.diagnostics == []
        assert isinstance(caught.value, KeyError)
    with pytest.raises(grafverif.GrafverifError, match="NOTHING"):
        read.loop().simulate().set(NOTHING=True)


def test_a_bound_makes_verdicts_unknown():
    report = grafverif.read(blinker).loop().check(states=10)
    assert all(each.unknown and each.reason for each in report) and not report.as_expected


def test_objects_outlive_their_file():
    report = grafverif.read(blinker).loop().check()
    chart = grafverif.read(blinker).chart()
    moved = grafverif.read(blinker).loop().simulate()
    assert len(report) > 1 and "<svg" in chart.draw().svg and moved.wait(1).now.time_ms == 1000


def test_other_threads_run_while_it_proves():
    done = threading.Event()

    def prove():
        grafverif.read(line).loop().check(whole=True, timeout=1.0)
        done.set()

    prover = threading.Thread(target=prove)
    prover.start()
    turns = 0
    while not done.is_set():
        turns += 1
        time.sleep(0.01)
    prover.join()
    assert turns > 5


def test_threads_prove_the_same_at_once():
    loop = grafverif.read(blinker).loop()
    found = []
    threads = [threading.Thread(target=lambda: found.append([each.verdict for each in loop.check()])) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4 and all(each == found[0] for each in found)


def test_ctrl_c_ends_it():
    code = (f"import grafverif\nloop = grafverif.read({str(line)!r}).loop()\nprint('begun', flush=True)\n"
            "try:\n    loop.check(whole=True)\nexcept KeyboardInterrupt:\n    print('interrupted', flush=True)\n"
            "print(len(grafverif.__all__) > 3)")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "begun\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=60)
    assert out == "interrupted\nTrue\n" and child.returncode == 0, os.strerror(abs(child.returncode))
