# SPDX-License-Identifier: MIT
"""Tests `grafverif mcp` as a process: its tools, limits, cancellation and termination."""
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from mcp_client import PROGRAM, Client, violations

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
LONG = "\n".join(
    ["grafcet slow {"] + [f"input i{k}; output o{k};" for k in range(16)] + ["initial step s;"]
    + [f"step a{k} {{ o{k}; }} transition t{k}: s -> a{k} when i{k}; transition u{k}: a{k} -> s when {k + 2}s/Xa{k};"
       for k in range(16)] + ["}", "closed_loop endless { controller slow;"]
    + [f"environment e{k} = free(OUT = i{k});" for k in range(16)] + ["property p: o0 leads to o1; }"])

TUNED = ("grafcet g { input A; output B; initial step 0; step 1 { B; } transition t: 0 -> 1 when A; }\n"
         "closed_loop l { controller g; constant WAIT = 1s; environment E = push_button(OUT = A, GAP = WAIT);\n"
         "property p: reachable B; }")

FAULTY = ("component held(output OUT) { initial location held with OUT := true; }\n"
          "grafcet g { input A; output B; initial step 0; step 1 { B; } transition t: 0 -> 1 when A; }\n"
          "closed_loop l { controller g; environment E = push_button(OUT = A); fault stuck of E: held();\n"
          "property p: reachable B; }")


class Mcp(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="grafverif-mcp-")
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copy(os.path.join(ROOT, "samples/oven_door/oven_door.grafcet"), self.folder)
        with open(os.path.join(self.folder, "long.grafcet"), "w", encoding="utf-8") as file:
            file.write(LONG)

    def begin(self, *arguments, **options):
        client = Client(*arguments, folder=self.folder, **options)
        self.addCleanup(client.kill)
        return client

    def await_children(self, client, count):
        for _ in range(600):
            if len(client.children()) == count:
                return
            time.sleep(0.05)
        self.fail(f"the server has {len(client.children())} child processes, expected {count}")

    def test_results_conform_to_their_schemas(self):
        client = self.begin()
        tools = {tool["name"]: tool for tool in client.result("tools/list")["tools"]}
        self.assertEqual(sorted(tools), ["analyse", "check", "compare", "complete", "draw", "explain", "faults", "read",
                                         "simulate", "tune"])
        door = {"file": "oven_door.grafcet"}
        calls = {"read": door, "draw": door, "check": door, "analyse": door, "explain": {**door, "property": "warned"},
                 "simulate": {**door, "commands": "wait 3s"}, "compare": {**door, "other": "oven_door.grafcet"},
                 "tune": {"text": TUNED, "over": ["WAIT=1s..2s"]}, "faults": {"text": FAULTY, "order": 1},
                 "complete": {**door, "line": 20, "column": 1}}
        requests = {name: client.begin_call(name, **arguments) for name, arguments in calls.items()}
        for name, request in requests.items():
            result = client.response(request)["result"]
            self.assertFalse(result["isError"], result)
            self.assertEqual(violations(tools[name]["inputSchema"], calls[name]), [])
            self.assertTrue(result["content"][0]["text"], name)
            if name != "draw":
                self.assertEqual(violations(tools[name]["outputSchema"], result["structuredContent"]), [])
        self.assertEqual(client.close(), 0)

    def test_a_cancelled_check_ends_without_a_response(self):
        client = self.begin()
        request = client.begin_call("check", progress_token="long", file="long.grafcet")
        self.await_children(client, 1)
        progress = client.wait(lambda message: message.get("method") == "notifications/progress")["params"]
        self.assertEqual((progress["progressToken"], progress["total"]), ("long", 60))
        client.notify("notifications/cancelled", {"requestId": request, "reason": "test"})
        self.await_children(client, 0)
        self.assertEqual(client.result("ping"), {})
        self.assertFalse([message for message in client.kept if message.get("id") == request])
        self.assertEqual(client.close(), 0)

    def test_limits_end_a_call_but_not_the_server(self):
        client = self.begin("--timeout", "100s")
        started = time.monotonic()
        result = client.call("check", file="long.grafcet", timeout=3)
        if not result["isError"]:  # on a loaded machine, the limit can end the composition, which is an error
            self.assertEqual(result["structuredContent"]["properties"][0]["verdict"], "unknown")
        self.assertIn("time limit", result["content"][0]["text"])
        self.assertLess(time.monotonic() - started, 50)
        result = client.call("check", file="long.grafcet", max_memory=40, timeout=100)
        self.assertIn("memory", result["content"][0]["text"])
        request = client.begin_call("check", file="long.grafcet", timeout=101)
        self.assertEqual(client.response(request)["error"]["code"], -32602)
        self.assertEqual(client.result("ping"), {})
        self.assertEqual(client.close(), 0)

    def test_the_server_ends_its_calls_when_the_client_closes_its_input(self):
        client = self.begin()
        for _ in range(3):
            client.begin_call("check", file="long.grafcet", timeout=600)
        self.await_children(client, 3)
        children = client.children()
        self.assertEqual(client.close(), 0)
        for child in children:
            self.assertFalse(os.path.exists(f"/proc/{child}"))

    def test_the_server_ends_when_the_client_does_not_read(self):
        client = self.begin()
        client.begin_call("check", progress_token=1, file="long.grafcet", timeout=600)
        self.await_children(client, 1)
        client.stop_reading()
        client.process.wait(timeout=60)
        self.assertEqual(client.process.returncode, 128 + signal.SIGPIPE)  # the exit code of every command

    def test_a_signal_ends_the_server(self):
        client = self.begin()
        client.begin_call("check", file="long.grafcet", timeout=600)
        self.await_children(client, 1)
        children = client.children()
        client.process.send_signal(signal.SIGTERM)
        self.assertEqual(client.process.wait(timeout=60), 3)
        self.assertFalse(os.path.exists(f"/proc/{children[0]}"))

    def test_hostile_input_does_not_end_the_server(self):
        client = self.begin()
        for line in ["nonsense", "[" * 100_000, "x" * 5_000_000, '"\\ud800"', "{}", "[]", "\0"]:
            client.write(line + "\n")
            self.assertIn(client.wait(lambda message: "error" in message)["error"]["code"], (-32700, -32600))
        for _ in range(5000):
            client.write('{"jsonrpc":"2.0","id":"flood","method":"ping"}\n')
        for _ in range(5000):
            client.response("flood")
        for path in ["/etc/passwd", "../x", "/dev/zero", "/proc/self/mem"]:
            self.assertIn("outside", client.call("check", file=path)["content"][0]["text"])
        self.assertEqual(client.close(), 0)

    def test_only_existing_folders_are_accepted(self):
        result = subprocess.run([PROGRAM, "mcp", "nowhere"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("cannot read `nowhere`: the folder does not exist", result.stderr)

    def test_the_session_of_the_page_is_real(self):
        with open(os.path.join(ROOT, "docs/how-to/mcp.md"), encoding="utf-8") as file:
            blocks = re.findall(r"```text\n(<?-->?.*?)```", file.read(), re.DOTALL)
        self.assertEqual(len(blocks), 1)
        lines = re.sub(r"\n +", " ", blocks[0]).strip().split("\n")
        client = None
        for line in lines:
            direction, message = line.split(" ", 1)
            message = json.loads(message)
            if direction == "-->" and message["method"] == "initialize":
                client = self.begin()  # begin() sends this request and the following notification
                answer = {"result": client.server}
            elif direction == "-->" and "id" in message:
                client.send(message)
                answer = client.response(message["id"])
            elif direction == "<--":
                self.assertTrue(contains(answer, message), f"{message}\n{answer}")
        self.assertEqual(client.close(), 0)


def contains(actual, shown):
    """True if `actual` has the members of `shown`. A text that ends with `...` matches every text with this beginning."""
    if isinstance(shown, dict):
        return isinstance(actual, dict) and all(name in actual and contains(actual[name], each) for name, each in shown.items()
                                                if name not in ("jsonrpc", "id"))
    if isinstance(shown, list):
        return isinstance(actual, list) and len(actual) >= len(shown) and all(map(contains, actual, shown))
    if isinstance(shown, str) and shown.endswith("..."):
        return isinstance(actual, str) and actual.startswith(shown[:-3])
    return actual == shown


if __name__ == "__main__":
    unittest.main()
