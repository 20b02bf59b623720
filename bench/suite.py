#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks all tasks of a folder in the layout of the public IEC 61131-3 verification suite.

    bench/suite.py FOLDER [--program build/run/bin/grafverif] [--timeout 60] [--markdown]

One line per task, with columns separated by tabs: file, expected verdict, verdict, violated properties, proof, seconds of processor
time, agreement, reason of a missing verdict. A proof is `unbounded` (it covers any number of scans) or a trace, with its number of
scans. `--markdown` prints a table that also contains the verdicts recorded by the authors of the suite. The tasks are those of
FOLDER/MANIFEST.tsv if it exists, otherwise the variants of every benchmark.yml (which needs python3-yaml). Exit code 1: a verdict
disagrees with the expected one.
"""
import argparse
import collections
import csv
import dataclasses
import json
import pathlib
import resource
import subprocess
import sys
from typing import Iterator


@dataclasses.dataclass(frozen=True)
class Task:
    path: pathlib.Path
    properties: pathlib.Path
    expected: str
    language: str
    variant: str
    violated: frozenset[str]
    """Names of the violated properties; empty if the suite does not name them."""
    recorded: tuple[str, str] = ("", "")
    """Verdicts recorded in the suite: by ESBMC on the ladder diagram, and by the route through MATIEC and C."""


@dataclasses.dataclass(frozen=True)
class Result:
    verdict: str
    proof: str
    seconds: float
    violated: frozenset[str] = frozenset()
    reason: str = ""

    def agreement(self, task: Task) -> str:
        if self.verdict in ("REJECTED", "UNKNOWN"):
            return "-"
        if self.verdict != task.expected:
            return "DISAGREES"
        return "agrees" if not task.violated or task.violated == self.violated else "other properties"


def manifest_tasks(folder: pathlib.Path) -> Iterator[Task]:
    with open(folder / "MANIFEST.tsv", encoding="utf-8") as table:
        for row in csv.DictReader(table, delimiter="\t"):
            path = folder / row["path"]
            words = row["props_file"].split("(=")
            properties = words[1].rstrip(")") if len(words) > 1 else words[0]
            yield Task(path, (path.parent / properties.strip()).resolve(), row["expected"], row["language"], row["variant"],
                       frozenset(row["violated_properties"].split()), (row["recorded_ld"], row["recorded_viac"]))


def descriptor_tasks(folder: pathlib.Path) -> Iterator[Task]:
    import yaml

    for descriptor in sorted(folder.glob("**/benchmark.yml")):
        task = yaml.safe_load(descriptor.read_text(encoding="utf-8"))
        for variant in task["variants"]:
            properties = variant.get("properties_file", task.get("properties_file", "props.yaml"))
            path = descriptor.parent / variant["file"]
            yield Task(path, descriptor.parent / properties, "SAFE" if variant["expected_verdict"] else "VIOLATION",
                       task["language"], path.stem, frozenset(variant.get("violated_properties", [])))


def decide(program: pathlib.Path, task: Task, timeout: int) -> Result:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "check", task.path, "--properties", task.properties, "--format", "json",
                          "--timeout", f"{timeout}s"], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if run.returncode == 2 or not run.stdout.startswith("{"):
        errors = [line for line in run.stderr.splitlines() if " error: " in line]
        reason = errors[0].split(" error: ", 1)[1] if errors else f"exit code {run.returncode}"
        return Result("REJECTED", "-", seconds, reason=reason)
    properties = json.loads(run.stdout)["properties"]
    violated = [one for one in properties if one["verdict"] == "violated"]
    if violated:
        traces = [one["trace"]["run"]["moments"] for one in violated if one["trace"]]
        proof = "unbounded"
        if traces:
            scans = min(len(trace) - 1 for trace in traces)
            proof = f"trace of {scans} scan{'s' if scans > 1 else ''}"
        return Result("VIOLATION", proof, seconds, frozenset(one["name"] for one in violated))
    if all(one["verdict"] == "holds" for one in properties) and run.returncode == 0:
        return Result("SAFE", "unbounded", seconds)
    reasons = [one["reason"] or "" for one in properties if one["verdict"] == "unknown"]
    return Result("UNKNOWN", "-", seconds, reason=reasons[0] if reasons else f"exit code {run.returncode}")


def line(folder: pathlib.Path, task: Task, result: Result) -> str:
    return "\t".join([str(task.path.relative_to(folder)), task.expected, result.verdict, " ".join(sorted(result.violated)),
                      result.proof, f"{result.seconds:.2f}", result.agreement(task), result.reason])


def markdown(task: Task, result: Result) -> str:
    cells = [task.path.parent.name, task.variant, task.language, task.expected, result.verdict, result.proof,
             f"{result.seconds:.2f}", *task.recorded]
    return "| " + " | ".join(cells) + " |"


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path,
                        default=pathlib.Path(__file__).parent.parent / "build/run/bin/grafverif")
    parser.add_argument("--timeout", type=int, default=60)
    parser.add_argument("--markdown", action="store_true")
    options = parser.parse_args()
    tasks = manifest_tasks if (options.folder / "MANIFEST.tsv").exists() else descriptor_tasks
    count: collections.Counter[str] = collections.Counter()
    reasons: collections.Counter[str] = collections.Counter()
    total = 0.0
    if options.markdown:
        print("| Task | Variant | Language | Expected | grafverif | Proof | s | LD route | Route through C |")
        print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for task in tasks(options.folder):
        result = decide(options.program, task, options.timeout)
        agreement = result.agreement(task)
        count[agreement if agreement != "-" else result.verdict.lower()] += 1
        if result.reason:
            reasons[f"{task.language}: {result.reason}"] += 1
        total += result.seconds
        print(markdown(task, result) if options.markdown else line(options.folder, task, result), flush=True)
    summary = sys.stderr if options.markdown else sys.stdout
    print(", ".join(f"{number} {what}" for what, number in sorted(count.items())) + f", {total:.1f} s", file=summary)
    for reason, number in reasons.most_common():
        print(f"{number} without verdict: {reason}", file=summary)
    return 1 if count["DISAGREES"] else 0


if __name__ == "__main__":
    sys.exit(main())
