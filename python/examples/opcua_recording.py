#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the signals of an OPC UA server against the charts of a file, with asyncua.

    opcua_recording.py pump.grafcet opc.tcp://plc:4840 START="ns=2;s=START" PUMP="ns=2;s=PUMP" ...

Reads all nodes once per period, until the check ends or Ctrl-C. The jitter must be at least the scan time of the PLC plus
the period.
"""

from __future__ import annotations

import argparse
import asyncio
import time
from typing import Mapping

import grafverif


async def record(recording: grafverif.Recording, url: str, nodes: Mapping[str, str], period: float) -> None:
    """Adds the values of the nodes until the check ends. `nodes` maps names of signals to node identifiers."""
    from asyncua import Client

    async with Client(url=url) as client:
        handles = [client.get_node(node) for node in nodes.values()]
        start = time.monotonic()
        is_open = True
        while is_open:
            now = time.monotonic() - start
            values = await client.read_values(handles)
            is_open = recording.add(now, dict(zip(nodes, map(int, values))))
            await asyncio.sleep(period)


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="check the signals of an OPC UA server against charts")
    parser.add_argument("file")
    parser.add_argument("url")
    parser.add_argument("nodes", nargs="+", metavar="SIGNAL=NODE")
    parser.add_argument("--period", type=float, default=0.01, help="seconds between two samples (default: 0.01)")
    parser.add_argument("--jitter", type=float, default=0.05, help="seconds (default: 0.05)")
    given = parser.parse_args(arguments)
    nodes = dict(each.split("=", 1) for each in given.nodes)
    recording = grafverif.read(given.file).recording(jitter=given.jitter, stop_early=True)
    try:
        asyncio.run(record(recording, given.url, nodes, given.period))
    except KeyboardInterrupt:
        pass
    report = recording.finish()
    print(report)
    return 1 if any(each.verdict == "deviates" for each in report) else 0


if __name__ == "__main__":
    raise SystemExit(main())
