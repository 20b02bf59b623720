#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of bench/suite.py: verdicts, proofs, agreement and exit code for both layouts of a suite."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
HEAD = ("path\ttask\tlanguage\tvariant\texpected\tviolated_properties\tprops_file\tproperty_kinds\trecorded_ld\t"
        "recorded_viac\n")
PROGRAM = ("PROGRAM p\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q, r : BOOL; END_VAR\nVAR n : INT; END_VAR\n"
           "IF a AND n < 3 THEN n := n + 1; END_IF;\nq := n = 3;\nr := FALSE;\nEND_PROGRAM\n")
PROPERTIES = ("properties:\n  - {id: P1, kind: invariant, expression: \"n <= 3\"}\n"
              "  - {id: P2, kind: reachability, expression: \"%s\"}\n")


class Suite(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("t/p.st", PROGRAM)
        self.write("t/bad.st", "PROGRAM p\nx := ;\nEND_PROGRAM\n")
        self.write("t/safe.yaml", PROPERTIES % "r")
        self.write("t/unsafe.yaml", PROPERTIES % "q")
        self.write("t/unreachable.yaml", "properties:\n  - {id: P1, kind: reachable, expression: r}\n")

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def run_suite(self, *options):
        """Returns the exit code and the lines of the output, without the times."""
        run = subprocess.run([sys.executable, ROOT / "bench/suite.py", self.folder, "--program",
                              os.environ["GRAFVERIF_PROGRAM"], *options], capture_output=True, text=True, check=False)
        self.assertEqual(run.stderr if "--markdown" not in options else "", "")
        lines = [line.split("\t") for line in run.stdout.splitlines()]
        return run.returncode, [line[:5] + line[6:] for line in lines if len(line) > 1], run.stdout

    def test_manifest(self):
        self.write("MANIFEST.tsv", HEAD + "".join(
            f"t/{file}\tt\tST\tx\t{expected}\t{violated}\t{properties}\t\tSAFE\ttimeout\n"
            for file, expected, violated, properties in [
                ("p.st", "SAFE", "", "safe.yaml"), ("p.st", "VIOLATION", "P2", "props.yaml (=unsafe.yaml)"),
                ("p.st", "VIOLATION", "P1", "unsafe.yaml"), ("p.st", "SAFE", "", "unreachable.yaml"),
                ("bad.st", "SAFE", "", "safe.yaml")]))
        code, lines, out = self.run_suite()
        self.assertEqual(code, 1)
        self.assertEqual(lines[:4], [
            ["t/p.st", "SAFE", "SAFE", "", "unbounded", "agrees", ""],
            ["t/p.st", "VIOLATION", "VIOLATION", "P2", "trace of 3 scans", "agrees", ""],
            ["t/p.st", "VIOLATION", "VIOLATION", "P2", "trace of 3 scans", "other properties", ""],
            ["t/p.st", "SAFE", "VIOLATION", "P1", "unbounded", "DISAGREES", ""]])
        self.assertEqual(lines[4][:6], ["t/bad.st", "SAFE", "REJECTED", "", "-", "-"])
        self.assertIn("1 DISAGREES, 2 agrees, 1 other properties, 1 rejected, ", out)
        self.assertIn("1 without verdict: ST: ", out)
        code, _, table = self.run_suite("--markdown")
        self.assertEqual(code, 1)
        self.assertIn("| t | x | ST | VIOLATION | VIOLATION | trace of 3 scans | ", table)
        self.assertTrue(all(row.endswith(" | SAFE | timeout |") for row in table.splitlines()[2:]), table)

    def test_descriptors(self):
        try:
            import yaml  # noqa: F401
        except ImportError:
            self.skipTest("python3-yaml is not installed")
        self.write("t/benchmark.yml", "language: ST\nproperties_file: safe.yaml\nvariants:\n"
                   "  - {file: p.st, expected_verdict: true}\n"
                   "  - {file: p.st, expected_verdict: false, properties_file: unsafe.yaml, violated_properties: [P2]}\n")
        code, lines, _ = self.run_suite()
        self.assertEqual(code, 0)
        self.assertEqual([line[5] for line in lines], ["agrees", "agrees"])


if __name__ == "__main__":
    unittest.main()
