#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks all tasks of a folder in the layout of the public IEC 61131-3 verification suite.

    bench/suite.py FOLDER [--program build/run/bin/grafverif] [--timeout 60]

One line per task: file, expected and found verdict, proof (unbounded, trace), seconds of processor time, agreement. The tasks are
those of FOLDER/MANIFEST.tsv if it exists, otherwise the variants of every benchmark.yml (which needs python3-yaml).
"""
import argparse
import collections
import csv
import json
import pathlib
import resource
import subprocess


def manifest_tasks(folder):
    with open(folder / "MANIFEST.tsv", encoding="utf-8") as table:
        for row in csv.DictReader(table, delimiter="\t"):
            path = folder / row["path"]
            words = row["props_file"].split("(=")
            properties = words[1].rstrip(")") if len(words) > 1 else words[0]
            yield path, (path.parent / properties.strip()).resolve(), row["expected"], row["language"]


def descriptor_tasks(folder):
    import yaml

    for descriptor in sorted(folder.glob("**/benchmark.yml")):
        task = yaml.safe_load(descriptor.read_text(encoding="utf-8"))
        for variant in task["variants"]:
            properties = variant.get("properties_file", task.get("properties_file", "props.yaml"))
            expected = "SAFE" if variant["expected_verdict"] else "VIOLATION"
            yield descriptor.parent / variant["file"], descriptor.parent / properties, expected, task["language"]


def decide(program, path, properties, timeout):
    """Returns the verdict, proof and reason of one task, and its processor time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "check", path, "--properties", properties, "--format", "json", "--timeout", f"{timeout}s"],
                         capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if run.returncode == 2 or not run.stdout.startswith("{"):
        errors = [line for line in run.stderr.splitlines() if " error: " in line]
        return "REJECTED", "-", errors[0].split(" error: ", 1)[1] if errors else f"exit code {run.returncode}", seconds
    verdicts = [one["verdict"] for one in json.loads(run.stdout)["properties"]]
    if "violated" in verdicts:
        return "VIOLATION", "trace", "", seconds
    if all(one == "holds" for one in verdicts) and run.returncode == 0:
        return "SAFE", "unbounded", "", seconds
    return "UNKNOWN", "-", "", seconds


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", default=pathlib.Path(__file__).parent.parent / "build/run/bin/grafverif")
    parser.add_argument("--timeout", type=int, default=60)
    options = parser.parse_args()
    tasks = manifest_tasks if (options.folder / "MANIFEST.tsv").exists() else descriptor_tasks
    count, reasons = collections.Counter(), collections.Counter()
    for path, properties, expected, language in tasks(options.folder):
        verdict, proof, reason, seconds = decide(options.program, path, properties, options.timeout)
        agreement = "-" if verdict in ("REJECTED", "UNKNOWN") else "agrees" if verdict == expected else "DISAGREES"
        count[agreement if agreement != "-" else verdict.lower()] += 1
        if reason:
            reasons[f"{language}: {reason}"] += 1
        print(path.relative_to(options.folder), expected, verdict, proof, f"{seconds:.2f}", agreement, reason, sep="\t", flush=True)
    print(", ".join(f"{number} {what}" for what, number in sorted(count.items())))
    for reason, number in reasons.most_common():
        print(f"{number} rejected: {reason}")


if __name__ == "__main__":
    main()
