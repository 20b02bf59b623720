# SPDX-License-Identifier: MIT
"""Executes the adapters in python/examples with small replacements of asyncua, pymodbus and paho-mqtt, which have the
same interface as the functions that the adapters call. A simulated PLC and a simulated clock replace the real ones."""
import importlib.util
import pathlib
import re
import sys
import types

import pytest

root = pathlib.Path(__file__).parents[2]


class Plc:
    """Simulates the PLC of the pump in check-recordings.md: START at 1 s, PUMP at 1.01 s, HORN when the pump has run
    for `duration`."""

    def __init__(self, duration):
        self.now = 100.0
        self.end = 110.0
        self.duration = duration

    def values(self):
        time = self.now - 100
        horn = 1.01 + self.duration
        return {"START": 1 <= time < 1.5, "STOP": 7 <= time < 7.5, "PUMP": 1.01 <= time < horn,
                "HORN": horn <= time < 7.01}

    def monotonic(self):
        return self.now

    def sleep(self, seconds):
        self.now += seconds
        if self.now >= self.end:
            raise KeyboardInterrupt


@pytest.fixture(name="pump")
def pump_of_the_page(tmp_path):
    file = tmp_path / "pump.grafcet"
    page = (root / "docs/how-to/check-recordings.md").read_text()
    file.write_text(re.search(r"```grafcet\n(.*?)```", page, re.DOTALL).group(1))
    return str(file)


def adapter(name, plc, monkeypatch, **modules):
    for module, content in modules.items():
        monkeypatch.setitem(sys.modules, module.replace("__", "."), content)
    spec = importlib.util.spec_from_file_location(name, root / "python/examples" / f"{name}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    monkeypatch.setattr(loaded, "time", types.SimpleNamespace(monotonic=plc.monotonic, sleep=plc.sleep))
    return loaded


def asyncua_of(plc):
    class Client:
        def __init__(self, url):
            assert url == "opc.tcp://plc:4840"

        async def __aenter__(self):
            return self

        async def __aexit__(self, *failure):
            return None

        def get_node(self, node):
            assert node.startswith("ns=2;s=")
            return node[7:]

        async def read_values(self, nodes):
            return [plc.values()[node] for node in nodes]

    return types.SimpleNamespace(Client=Client)


def pymodbus_of(plc, error=False):
    class Client:
        def __init__(self, host, port):
            assert (host, port) == ("plc", 502)
            self.open = False

        def connect(self):
            self.open = True
            return True

        def close(self):
            self.open = False

        def bits(self, names, address, count):
            assert self.open and address == 0 and count == 2
            values = plc.values()
            return types.SimpleNamespace(isError=lambda: error, bits=[values[name] for name in names] + 6 * [False])

        def read_discrete_inputs(self, address, *, count):
            return self.bits(["START", "STOP"], address, count)

        def read_coils(self, address, *, count):
            return self.bits(["PUMP", "HORN"], address, count)

    return types.SimpleNamespace(ModbusTcpClient=Client)


def paho_of(plc):
    """A broker with retained messages. Each attempt of the adapter to get a message advances the time."""

    class Client:
        def __init__(self, version):
            assert version == 2
            self.topics = []
            self.known = {}

        def connect(self, host, port):
            assert (host, port) == ("broker", 1883)

        def subscribe(self, topic):
            self.topics.append(topic)

        def loop_start(self):
            self.on_connect(self, None, {}, 0, None)
            self.publish()
            Client.running = self

        def loop_stop(self):
            Client.running = None

        def disconnect(self):
            pass

        def publish(self):
            for name, value in plc.values().items():
                topic = f"plant/{name}"
                if topic in self.topics and self.known.get(topic) != value:
                    self.known[topic] = value
                    payload = b"true" if value else b"0"
                    self.on_message(self, None, types.SimpleNamespace(topic=topic, payload=payload))

    return types.SimpleNamespace(Client=Client, CallbackAPIVersion=types.SimpleNamespace(VERSION2=2))


def queue_of(plc, mqtt):
    class Queue(list):
        def put(self, message):
            self.append(message)

        def empty(self):
            return not self

        def get(self, timeout):
            end = plc.now + timeout
            while not self and plc.now < end:
                plc.sleep(0.01)
                mqtt.Client.running.publish()
            if not self:
                raise Empty
            return self.pop(0)

    class Empty(Exception):
        pass

    return types.SimpleNamespace(Queue=Queue, Empty=Empty)


def run_opcua(plc, pump, monkeypatch):
    loaded = adapter("opcua_recording", plc, monkeypatch, asyncua=asyncua_of(plc))

    async def sleep(seconds):
        plc.sleep(seconds)

    monkeypatch.setattr(loaded.asyncio, "sleep", sleep)
    nodes = [f"{name}=ns=2;s={name}" for name in plc.values()]
    return loaded.main([pump, "opc.tcp://plc:4840", *nodes])


def run_modbus(plc, pump, monkeypatch):
    loaded = adapter("modbus_recording", plc, monkeypatch, pymodbus=types.ModuleType("pymodbus"),
                     pymodbus__client=pymodbus_of(plc))
    return loaded.main([pump, "plc", "START=di0", "STOP=di1", "PUMP=co0", "HORN=co1"])


def run_mqtt(plc, pump, monkeypatch):
    mqtt = paho_of(plc)
    paho, package = types.ModuleType("paho"), types.ModuleType("paho.mqtt")
    package.client = mqtt
    paho.mqtt = package
    loaded = adapter("mqtt_recording", plc, monkeypatch, paho=paho, paho__mqtt=package, paho__mqtt__client=mqtt)
    monkeypatch.setattr(loaded, "queue", queue_of(plc, mqtt))
    return loaded.main([pump, "broker", *[f"{name}=plant/{name}" for name in plc.values()]])


@pytest.mark.parametrize("run", [run_opcua, run_modbus, run_mqtt])
def test_adapters_accept_a_conforming_plc(run, pump, monkeypatch, capsys):
    assert run(Plc(3.0), pump, monkeypatch) == 0
    assert "pump: conforms\n" in capsys.readouterr().out


@pytest.mark.parametrize("run", [run_opcua, run_modbus, run_mqtt])
def test_adapters_end_at_a_deviation(run, pump, monkeypatch, capsys):
    plc = Plc(3.4)
    assert run(plc, pump, monkeypatch) == 1
    assert "pump: deviates\n" in capsys.readouterr().out
    assert plc.now < plc.end - 1


def test_modbus_reports_errors_and_wrong_addresses(pump, monkeypatch):
    plc = Plc(3.0)
    loaded = adapter("modbus_recording", plc, monkeypatch, pymodbus=types.ModuleType("pymodbus"),
                     pymodbus__client=pymodbus_of(plc, error=True))
    with pytest.raises(OSError, match="the server rejects the request"):
        loaded.main([pump, "plc", "START=di0", "STOP=di1", "PUMP=co0", "HORN=co1"])
    with pytest.raises(ValueError, match="`diN` or `coN`"):
        loaded.main([pump, "plc", "START=hr0"])
