# SPDX-License-Identifier: MIT
"""A client of the Model Context Protocol over standard input and output, written from the specification (2025-06-18)."""
import json
import os
import queue
import subprocess
import threading

PROGRAM = os.environ["GRAFVERIF_PROGRAM"]
TIME_LIMIT = 60


class Client:
    """Starts `grafverif mcp ARGUMENTS` in `folder`, and sends requests and notifications to it."""

    def __init__(self, *arguments, folder, version="2025-06-18"):
        self.process = subprocess.Popen(
            [PROGRAM, "mcp", *arguments], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.arrived = queue.Queue()
        self.kept = []  # messages that arrived while another one was awaited
        self.last = 0
        self.reading = True
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()
        self.server = self.result("initialize", {
            "protocolVersion": version, "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}})
        self.notify("notifications/initialized")

    def _read(self):
        for line in self.process.stdout:
            self.arrived.put(json.loads(line))
            if not self.reading:
                return
        self.arrived.put(None)

    def send(self, message):
        self.write(json.dumps(message) + "\n")

    def write(self, text):
        self.process.stdin.write(text.encode())
        self.process.stdin.flush()

    def notify(self, method, params=None):
        self.send({"jsonrpc": "2.0", "method": method, "params": params or {}})

    def begin(self, method, params=None):
        """Sends a request and returns its id."""
        self.last += 1
        self.send({"jsonrpc": "2.0", "id": self.last, "method": method, "params": params or {}})
        return self.last

    def wait(self, matches):
        """Returns the first message that matches."""
        for message in self.kept:
            if matches(message):
                self.kept.remove(message)
                return message
        while True:
            message = self.arrived.get(timeout=TIME_LIMIT)
            if message is None:
                raise EOFError("the server has closed its output")
            if matches(message):
                return message
            self.kept.append(message)

    def response(self, request):
        return self.wait(lambda message: message.get("id") == request)

    def result(self, method, params=None):
        response = self.response(self.begin(method, params))
        if "error" in response:
            raise RuntimeError(response["error"])
        return response["result"]

    def begin_call(self, tool, progress_token=None, **arguments):
        params = {"name": tool, "arguments": arguments}
        if progress_token is not None:
            params["_meta"] = {"progressToken": progress_token}
        return self.begin("tools/call", params)

    def call(self, tool, **arguments):
        return self.response(self.begin_call(tool, **arguments))["result"]

    def children(self):
        """Returns the ids of the processes that the server has started."""
        found = []
        for name in os.listdir("/proc"):
            try:
                with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file:
                    parent = file.read().rsplit(")", 1)[1].split()[1]
            except (OSError, IndexError):
                continue
            if parent == str(self.process.pid):
                found.append(int(name))
        return found

    def stop_reading(self):
        """Closes the output of the server; its input stays open."""
        self.reading = False
        self.begin("ping")  # the next message ends the thread that reads
        self.reader.join(timeout=TIME_LIMIT)
        self.process.stdout.close()

    def kill(self):
        """Kills the server if it is still running."""
        self.process.kill()
        self.process.wait(timeout=TIME_LIMIT)
        self.reader.join(timeout=TIME_LIMIT)
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            try:
                stream.close()
            except BrokenPipeError:  # the last message was not sent
                pass

    def close(self):
        """Closes the input of the server as the specification requires, and returns its exit code."""
        self.process.stdin.close()
        code = self.process.wait(timeout=TIME_LIMIT)
        self.kill()
        return code


def violations(schema, value, where="result"):
    """Returns the rules of the JSON schema that the value violates, for the keywords that the server uses."""
    types = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "null": type(None)}
    known = {"type", "properties", "required", "items", "enum", "description", "additionalProperties", "minimum",
             "maximum", "minLength", "maxLength", "maxItems"}
    found = [f"{where}: unknown keyword {keyword}" for keyword in schema.keys() - known]
    names = schema.get("type", [])
    names = [names] if isinstance(names, str) else names
    if names and not any(isinstance(value, types[name]) and (name == "boolean" or not isinstance(value, bool))
                         for name in names):
        return found + [f"{where}: {value!r} is not of type {names}"]
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{where}: {value!r} is not one of {schema['enum']}")
    if isinstance(value, dict):
        found += [f"{where}: {name} is missing" for name in schema.get("required", []) if name not in value]
        for name, each in schema.get("properties", {}).items():
            if name in value:
                found += violations(each, value[name], f"{where}.{name}")
    if isinstance(value, list) and "items" in schema:
        for index, each in enumerate(value):
            found += violations(schema["items"], each, f"{where}[{index}]")
    return found
