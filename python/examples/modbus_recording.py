#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the inputs and coils of a Modbus TCP server against the charts of a file, with pymodbus.

    modbus_recording.py pump.grafcet plc START=di0 STOP=di1 PUMP=co0 HORN=co1

`di3` is discrete input 3, and `co3` is coil 3. Reads all signals once per period, until the check ends or Ctrl-C. The
jitter must be at least the scan time of the PLC plus the period.
"""

from __future__ import annotations

import argparse
import time
from typing import Any, Callable, Mapping

import grafverif


def read_bits(read: Callable[..., Any], addresses: Mapping[str, int]) -> dict[str, int]:
    """Reads the bits of `addresses` in one request."""
    if not addresses:
        return {}
    first, last = min(addresses.values()), max(addresses.values())
    answer = read(first, count=last - first + 1)
    if answer.isError():
        raise OSError(f"the server rejects the request: {answer}")
    return {name: int(answer.bits[address - first]) for name, address in addresses.items()}


def record(recording: grafverif.Recording, host: str, port: int, signals: Mapping[str, str], period: float) -> None:
    """Adds the values of the signals until the check ends. `signals` maps names of signals to `di` or `co` addresses."""
    from pymodbus.client import ModbusTcpClient

    inputs = {name: int(at[2:]) for name, at in signals.items() if at.startswith("di")}
    coils = {name: int(at[2:]) for name, at in signals.items() if at.startswith("co")}
    if len(inputs) + len(coils) != len(signals):
        raise ValueError("the address of a signal is `diN` or `coN`")
    client = ModbusTcpClient(host, port=port)
    if not client.connect():
        raise OSError(f"no connection to {host}:{port}")
    try:
        start = time.monotonic()
        is_open = True
        while is_open:
            now = time.monotonic() - start
            values = read_bits(client.read_discrete_inputs, inputs) | read_bits(client.read_coils, coils)
            is_open = recording.add(now, values)
            time.sleep(period)
    finally:
        client.close()


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="check the signals of a Modbus TCP server against charts")
    parser.add_argument("file")
    parser.add_argument("host")
    parser.add_argument("signals", nargs="+", metavar="SIGNAL=diN|coN")
    parser.add_argument("--port", type=int, default=502)
    parser.add_argument("--period", type=float, default=0.01, help="seconds between two samples (default: 0.01)")
    parser.add_argument("--jitter", type=float, default=0.05, help="seconds (default: 0.05)")
    given = parser.parse_args(arguments)
    signals = dict(each.split("=", 1) for each in given.signals)
    recording = grafverif.read(given.file).recording(jitter=given.jitter, stop_early=True)
    try:
        record(recording, given.host, given.port, signals, given.period)
    except KeyboardInterrupt:
        pass
    report = recording.finish()
    print(report)
    return 1 if any(each.verdict == "deviates" for each in report) else 0


if __name__ == "__main__":
    raise SystemExit(main())
