# SPDX-License-Identifier: MIT
"""Tests `serve` with faulty clients, which send invalid HTTP requests, other data, or nothing."""
import concurrent.futures
import contextlib
import json
import os
import pathlib
import resource
import signal
import socket
import subprocess
import time
import unittest
import urllib.error
import urllib.request

import browser

LAMP = """grafcet lamp { input ON, OFF; output LAMP; initial step 0; step 1 { LAMP; }
transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF || 3s/X1; }
"""


def has_ipv6():
    try:
        with socket.socket(socket.AF_INET6) as probe:
            probe.bind(("::1", 0))
            return True
    except OSError:
        return False


class Serve(unittest.TestCase):
    def setUp(self):
        self.work = browser.temporary_folder(self)
        self.file = self.work / "lamp.grafcet"
        self.file.write_text(LAMP)
        self.server = browser.Server(self.file)
        self.addCleanup(self.server.stop)

    def status(self, path="/state", host=None, token=True, body=None, **headers):
        """Returns the status and the body of the response."""
        request = urllib.request.Request(f"http://127.0.0.1:{self.server.port}{path}", data=body, headers=headers)
        if token:
            request.add_header("X-Grafverif-Token", self.server.token)
        if host:
            request.add_header("Host", host)
        try:
            with urllib.request.urlopen(request, timeout=30) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def raw(self, text, patience=10):
        """Sends `text` and returns everything received until the connection is closed."""
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=patience) as link:
            link.sendall(text)
            answer = b""
            try:
                while part := link.recv(65536):
                    answer += part
            except ConnectionError:
                pass
            return answer

    def state(self, wanted, known=0):
        """Returns the first state that satisfies `wanted`."""
        def look():
            nonlocal known
            state = json.loads(self.status(f"/state?after={known}")[1])
            if state:
                known = state["version"]
            return state if state and wanted(state) else None
        return browser.eventually(look, 20)

    def alive(self):
        self.assertEqual(self.status()[0], 200)

    def test_the_page_its_parts_and_the_state_are_served(self):
        status, page = self.status(f"/?token={self.server.token}", token=False)
        self.assertEqual(status, 200)
        self.assertIn("<h1", page)
        for part in ("live.js", "simulator.js", "marks.js", "dom.js", "live.css"):
            self.assertEqual(self.status(f"/web/{part}", token=False)[0], 200, part)
        self.assertEqual(self.status("/web/../secret", token=False)[0], 404)
        self.assertEqual(self.status("/nothing")[0], 404)
        self.state(lambda state: state["readable"])
        self.assertIn("<svg", json.loads(self.status("/drawings")[1])["drawings"][0])
        self.assertEqual(self.status("/drawings", token=False)[0], 403)
        self.assertIn("<html", self.status("/report?chart=la%6Dp")[1])
        self.assertEqual(self.status("/report?chart=nobody")[0], 409)
        state = self.state(lambda state: state["models"] and state["models"][0]["state"] == "done")
        self.assertEqual([chart["name"] for chart in state["charts"]], ["lamp"])

    def test_it_listens_on_this_machine_alone(self):
        if has_ipv6():
            with socket.create_connection(("::1", self.server.port), timeout=5):
                pass
        try:
            addresses = {address[4][0] for address in socket.getaddrinfo(socket.gethostname(), None)}
        except socket.gaierror:
            addresses = set()
        for address in addresses:
            if not address.startswith("127.") and address != "::1":
                with self.assertRaises(OSError):
                    socket.create_connection((address, self.server.port), timeout=2).close()

    def test_a_foreign_host_or_origin_or_no_token_is_refused(self):
        here = f"127.0.0.1:{self.server.port}"
        self.assertEqual(self.status(host="example.org")[0], 421)
        self.assertEqual(self.status(host=f"example.org:{self.server.port}")[0], 421)
        self.assertEqual(self.status(host="127.0.0.1:1")[0], 421)
        self.assertEqual(self.status(Origin="http://example.org")[0], 403)
        self.assertEqual(self.status(Origin="null")[0], 403)
        self.assertEqual(self.status(Origin=f"https://{here}")[0], 403)
        self.assertEqual(self.status(Origin=f"http://{here}")[0], 200)
        self.assertEqual(self.status(host=f"localhost:{self.server.port}")[0], 200)
        for path in ("/", "/state", "/simulate", "/state?token=", "/state?token=00"):
            self.assertEqual(self.status(path, token=False)[0], 403, path)
        self.assertEqual(self.status("/simulate", token=False, body=b"{}")[0], 403)
        two = f"GET /state HTTP/1.1\r\nHost: {here}\r\nHost: example.org\r\nX-Grafverif-Token: {self.server.token}\r\n\r\n"
        self.assertNotIn(b" 200 ", self.raw(two.encode()).split(b"\r\n")[0])

    def test_garbage_is_answered_and_nothing_crashes(self):
        self.assertEqual(self.status("/simulate", body=b"x" * (2 << 20))[0], 413)
        for body in (b"", b"[", b"null", b"\xff\xfe", b'{"moves": 3}', b'{"chart": "lamp", "moves": ["\\u0000"]}', b"[" * 500000):
            status, answer = self.status("/simulate", body=body)
            self.assertEqual(status, 200, body[:40])
            answer = json.loads(answer)
            self.assertTrue(answer.get("error") or answer.get("problem"), body[:40])
        self.assertEqual(self.status("/simulate")[0], 405)
        self.assertEqual(self.status("/state", body=b"{}")[0], 405)
        for text in (b"\r\n\r\n", b"HELLO\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00", b"\0" * 5000,
                     b"GET " + b"/" * 100000 + b" HTTP/1.1\r\n\r\n", b"GET / HTTP/1.1\r\nHost: " + b"a" * 100000 + b"\r\n\r\n",
                     b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 100000 + b"\r\n",
                     b"POST /simulate HTTP/1.1\r\nContent-Length: -1\r\n\r\n", b"POST /simulate HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n"):
            self.assertNotIn(b" 200 ", self.raw(text).split(b"\r\n")[0], text[:40])
        self.alive()

    def test_a_flood_without_token_does_not_displace_requests_with_one(self):
        done = self.state(lambda state: state["models"] and state["models"][0]["state"] == "done")
        asks = (f"GET /state?after={done['version']} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n"
                f"X-Grafverif-Token: {self.server.token}\r\n\r\n").encode()
        waiting = socket.create_connection(("127.0.0.1", self.server.port), timeout=30)
        self.addCleanup(waiting.close)
        waiting.sendall(asks)
        links = []
        self.addCleanup(lambda: [link.close() for link in links])
        for _ in range(5):
            links += [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(80)]
            for silent in links[::2]:
                with contextlib.suppress(OSError):
                    silent.sendall(b"GET /state HTTP/1.1\r\n")
            self.alive()
        self.file.write_text(LAMP + "nonsense")
        answer = b""
        while part := waiting.recv(65536):
            answer += part
        self.assertIn(b"nonsense", answer)

    def test_open_puts_no_token_on_a_command_line(self):
        opener = self.work / "bin" / "xdg-open"
        opener.parent.mkdir()
        opener.write_text('#!/bin/sh\nstat -c %a "$1" "${1%/*}" > "$OPENED.part"; echo "$@" >> "$OPENED.part"; cat "$1" >> "$OPENED.part"\n'
                          'mv "$OPENED.part" "$OPENED"\n')
        opener.chmod(0o755)
        opened = self.work / "opened"
        server = browser.Server(self.file, "--open", env={**os.environ, "PATH": f"{opener.parent}:{os.environ['PATH']}", "OPENED": str(opened)})
        self.addCleanup(server.stop)
        browser.eventually(opened.exists)
        file_mode, folder_mode, arguments, *page = opened.read_text().splitlines()
        self.assertEqual((file_mode, folder_mode), ("600", "700"))
        self.assertNotIn(server.token, arguments)
        self.assertIn(f"url={server.address}", "".join(page))
        server.stop()
        self.assertFalse(pathlib.Path(arguments).parent.exists())

    def test_idle_connections_time_out_and_do_not_block_the_server(self):
        links = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(200)]
        try:
            links[0].settimeout(20)
            self.assertEqual(links[0].recv(100), b"")  # the server closes it after a timeout
        finally:
            for link in links:
                link.close()
        browser.eventually(lambda: self.server.process.poll() is None and self.status()[0] == 200)

    def test_two_pages_receive_a_save_at_once_and_one_that_disconnects_does_not_affect_the_other(self):
        done = self.state(lambda state: state["models"] and state["models"][0]["state"] == "done")
        path = f"/state?after={done['version']}"
        gone = socket.create_connection(("127.0.0.1", self.server.port))
        gone.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\nX-Grafverif-Token: {self.server.token}\r\n\r\n".encode())
        with concurrent.futures.ThreadPoolExecutor(2) as pages:
            waiting = [pages.submit(self.status, path) for _ in range(2)]
            time.sleep(0.3)
            self.assertFalse(any(page.done() for page in waiting))
            gone.close()
            self.file.write_text(LAMP + "nonsense")
            for page in waiting:
                self.assertIn("nonsense", json.loads(page.result(timeout=20)[1])["diagnostics"])
        self.alive()

    def test_pages_that_go_away_while_they_wait_leave_their_places_at_once(self):
        done = self.state(lambda state: state["models"] and state["models"][0]["state"] == "done")
        asks = (f"GET /state?after={done['version']} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n"
                f"X-Grafverif-Token: {self.server.token}\r\n\r\n").encode()
        links = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(64)]
        for link in links:
            link.sendall(asks)
        time.sleep(0.5)  # until the server has received all requests
        links[0].sendall(b"what nobody reads")
        self.assertEqual(self.raw(asks), b"")  # rejected, because the maximum number of requests is pending
        for link in links[1:]:
            link.close()

        def answered():
            try:
                return self.status()[0] == 200
            except OSError:
                return False
        browser.eventually(answered, 10, "a place is free before the twenty seconds of those who left are over")
        self.file.write_text(LAMP + "nonsense")
        answer = b""
        while part := links[0].recv(65536):
            answer += part
        links[0].close()
        self.assertIn(b"nonsense", answer)  # the connection that remained open receives the response

    @unittest.skipIf(b"__ubsan_" in pathlib.Path(browser.PROGRAM).read_bytes(),
                     "the sanitizer needs a file of its own to look at an object")
    def test_it_does_not_spin_if_no_more_connections_can_be_opened(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (24, 24))
        server = browser.Server(self.file, preexec_fn=limit)
        self.addCleanup(server.stop)
        worked = lambda: sum(int(ticks) for ticks in pathlib.Path(f"/proc/{server.process.pid}/stat").read_text().split()[13:15])
        links = [socket.create_connection(("127.0.0.1", server.port), timeout=20) for _ in range(40)]
        time.sleep(1)
        before = worked()
        time.sleep(1.5)
        self.assertLess(worked() - before, 0.3 * os.sysconf("SC_CLK_TCK"), "it waits")
        for link in links:
            link.close()
        request = f"http://127.0.0.1:{server.port}/state?token={server.token}"
        browser.eventually(lambda: self.opened(request), what="an answer")

    @staticmethod
    def opened(address):
        try:
            with urllib.request.urlopen(address, timeout=30) as answer:
                return answer.status == 200
        except OSError:
            return False

    def test_no_save_is_missed_by_who_asks_again_at_once(self):
        began, known, reading = time.monotonic(), 0, 0
        for save in range(25):
            self.file.write_text(LAMP + f"// {save}\n")
            while True:
                state = json.loads(self.status(f"/state?after={known}")[1])
                known = state["version"]
                if state["reading"] > reading and state["models"] and state["models"][0]["state"] == "done":
                    reading = state["reading"]
                    break
        self.assertLess(time.monotonic() - began, 20, "an answer that is put off for good takes 20 s")

    def test_a_file_that_vanishes_comes_back(self):
        self.state(lambda state: state["readable"])
        self.file.unlink()
        state = self.state(lambda state: not state["readable"])
        self.assertIn("cannot-read", state["diagnostics"])
        fresh = self.work / "fresh"
        fresh.write_text(LAMP.replace("lamp", "light"))
        fresh.rename(self.file)
        self.state(lambda state: state["readable"] and state["charts"][0]["name"] == "light")

    def test_moves_are_played_and_nothing_is_kept(self):
        self.state(lambda state: state["readable"])
        ask = lambda moves: json.loads(self.status("/simulate", body=json.dumps({"chart": "lamp", "moves": moves}).encode())[1])
        self.assertEqual(ask(["ON = true"])["rows"][-1]["lit"], ["c0-step-1"])
        self.assertEqual(ask([])["rows"][-1]["lit"], ["c0-step-0"])
        self.assertEqual(sorted(each.name for each in self.work.iterdir()), ["lamp.grafcet"])

    def test_a_signal_ends_it_in_good_order_while_pages_wait(self):
        done = self.state(lambda state: state["models"] and state["models"][0]["state"] == "done")
        with concurrent.futures.ThreadPoolExecutor(1) as pages:
            waiting = pages.submit(self.raw, f"GET /state?after={done['version']} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n"
                                             f"X-Grafverif-Token: {self.server.token}\r\n\r\n".encode(), 30)
            time.sleep(0.2)
            self.server.process.send_signal(signal.SIGINT)
            self.assertEqual(self.server.process.wait(10), 0)
            waiting.result(timeout=10)

    def test_a_port_in_use_is_reported(self):
        done = subprocess.run([browser.PROGRAM, "serve", str(self.file), "--port", str(self.server.port)], capture_output=True, text=True, timeout=30)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, f"error: cannot listen on port {self.server.port}: another program uses this port; select another port with `--port` [cannot-listen]\n")
        for arguments, said in ((["--port", "70000"], "cannot-listen"), (["--port", "x"], "whole number")):
            done = subprocess.run([browser.PROGRAM, "serve", str(self.file), *arguments], capture_output=True, text=True, timeout=30)
            self.assertEqual(done.returncode, 2)
            self.assertIn(said, done.stderr)
        for file in ("-", str(self.work / "nothing"), str(self.work)):
            done = subprocess.run([browser.PROGRAM, "serve", file], capture_output=True, text=True, timeout=30, input="")
            self.assertEqual(done.returncode, 2)
            self.assertIn("cannot-read", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
