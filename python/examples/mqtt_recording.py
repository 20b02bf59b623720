#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks signals that a gateway publishes by MQTT against the charts of a file, with paho-mqtt.

    mqtt_recording.py pump.grafcet broker START=plant/START STOP=plant/STOP PUMP=plant/PUMP HORN=plant/HORN

A payload is `0`, `1`, `true`, `false` or an integer. The check begins when each topic has a value; retained messages
provide the initial values. The time of a message is the time of its arrival. Therefore, the jitter must be at least the
scan time of the PLC plus the greatest delay of a message.
"""

from __future__ import annotations

import argparse
import queue
import time
from typing import Any, Mapping

import grafverif

TRUTH = {b"true": 1, b"false": 0}


def value_of(payload: bytes) -> int:
    return TRUTH[payload] if payload in TRUTH else int(payload)


def record(recording: grafverif.Recording, host: str, port: int, topics: Mapping[str, str], period: float) -> None:
    """Adds the messages until the check ends. `topics` maps names of signals to topics. Without a message, a sample
    without changes is added once per period, so that missing changes are detected."""
    import paho.mqtt.client as mqtt

    names = {topic: name for name, topic in topics.items()}
    messages: queue.Queue[tuple[float, str, bytes]] = queue.Queue()

    def on_connect(client: Any, userdata: Any, flags: Any, reason: Any, properties: Any) -> None:
        for topic in names:
            client.subscribe(topic)

    def on_message(client: Any, userdata: Any, message: Any) -> None:
        messages.put((time.monotonic(), message.topic, message.payload))

    client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
    client.on_connect = on_connect
    client.on_message = on_message
    client.connect(host, port)
    client.loop_start()
    try:
        first: dict[str, int] = {}
        start: float | None = None
        is_open = True
        while is_open:
            try:
                at, topic, payload = messages.get(timeout=period)
            except queue.Empty:
                # A message that arrives now is later than this sample.
                if start is not None and messages.empty():
                    is_open = recording.add(time.monotonic() - start - period)
                continue
            change = {names[topic]: value_of(payload)}
            if start is not None:
                is_open = recording.add(at - start, change)
                continue
            first |= change
            if len(first) == len(names):
                start = at
                is_open = recording.add(0, first)
    finally:
        client.loop_stop()
        client.disconnect()


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="check signals that are published by MQTT against charts")
    parser.add_argument("file")
    parser.add_argument("host")
    parser.add_argument("topics", nargs="+", metavar="SIGNAL=TOPIC")
    parser.add_argument("--port", type=int, default=1883)
    parser.add_argument("--period", type=float, default=0.1, help="seconds between samples without a message")
    parser.add_argument("--jitter", type=float, default=0.05, help="seconds (default: 0.05)")
    given = parser.parse_args(arguments)
    topics = dict(each.split("=", 1) for each in given.topics)
    recording = grafverif.read(given.file).recording(jitter=given.jitter, stop_early=True)
    try:
        record(recording, given.host, given.port, topics, given.period)
    except KeyboardInterrupt:
        pass
    report = recording.finish()
    print(report)
    return 1 if any(each.verdict == "deviates" for each in report) else 0


if __name__ == "__main__":
    raise SystemExit(main())
