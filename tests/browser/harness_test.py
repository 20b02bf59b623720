# SPDX-License-Identifier: MIT
"""Tests of the browser harness: each check detects the faults that it must find."""
import browser


class Harness(browser.Case):
    allowed_errors = ("example.org", "shouted")

    def test_an_error_in_the_console_is_seen(self):
        page = self.work / "page.html"
        page.write_text("<!doctype html><title>t</title><script>console.error('shouted')</script>")
        self.page.open(page)
        self.assertIn("shouted", self.page.errors()[0])

    def test_a_request_that_leaves_the_machine_is_seen_and_reaches_no_server(self):
        page = self.work / "page.html"
        page.write_text("<!doctype html><title>t</title><img src='http://example.org/pixel.png' alt=''>")
        self.page.open(page)
        away = [address for address in self.page.requests() if browser.leaves_the_machine(address)]
        self.assertEqual(away, ["http://example.org/pixel.png"])

    def test_faint_texts_and_nameless_buttons_are_seen_in_both_schemes(self):
        page = self.work / "page.html"
        page.write_text("<!doctype html><title>t</title><style>:root { color-scheme: light dark }"
                        "p { color: #ccc } @media (prefers-color-scheme: dark) { p { color: #333 } }</style>"
                        "<h1>head</h1><p>faint</p><button></button>")
        self.page.open(page)
        for scheme in browser.SCHEMES:
            self.page.scheme(scheme)
            faint = self.page.script(browser.FAINT_TEXTS)
            self.assertEqual([text.split(": ")[1] for text in faint], ["faint"], scheme)
        self.assertEqual(len(self.page.script(browser.UNNAMED)), 3)  # the button, the page language, the main element

    def test_a_page_is_printed_and_served(self):
        (self.work / "page.html").write_text("<!doctype html><title>t</title><link rel=icon href='data:,'><h1>head</h1>")
        with browser.folder_served(self.work) as address:
            self.page.open(address + "page.html")
            self.assertEqual(self.page.text("h1"), "head")
        self.assertTrue(self.page.pdf().startswith(b"%PDF-"))


if __name__ == "__main__":
    browser.main()
