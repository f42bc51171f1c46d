"""A browser by the WebDriver protocol, with nothing but Python's own library."""

import base64
import json
import shutil
import socket
import subprocess
import time
import unittest
import urllib.request

FLAGS = ["--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--hide-scrollbars", "--force-device-scale-factor=1"]

KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Escape": "\ue00c", "PageUp": "\ue00e", "PageDown": "\ue00f", "End": "\ue010",
        "Home": "\ue011", "ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015"}


def programs():
    """Paths of chromium and its driver; None where one is missing."""
    browser = shutil.which("chromium")
    driver = shutil.which("chromedriver") or shutil.which("chromedriver", path="/usr/lib/chromium")
    return (browser, driver) if browser and driver else None


class BrowserTest(unittest.TestCase):
    """Tests that share one browser."""

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(*programs())

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()


class Browser:
    def __init__(self, browser, driver, size=(1280, 1000)):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.process = subprocess.Popen([driver, f"--port={port}"], stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        self.root = f"http://127.0.0.1:{port}"
        flags = FLAGS + [f"--window-size={size[0]},{size[1]}"]
        capabilities = {"browserName": "chrome",
                        "goog:chromeOptions": {"binary": browser, "args": flags},
                        "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
        self.wait(lambda: self.call("GET", "/status")["ready"], "the driver", 20, OSError)
        session = self.call("POST", "/session", {"capabilities": {"alwaysMatch": capabilities}})
        self.root += "/session/" + session["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        except OSError:
            pass
        self.process.terminate()
        self.process.wait(10)

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data=data, method=method,
                                         headers={"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["value"]

    @staticmethod
    def wait(condition, what, seconds=20, ignored=()):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                value = condition()
                if value:
                    return value
            except ignored:
                pass
            time.sleep(0.03)
        raise AssertionError(f"waited {seconds} s for {what}")

    def open(self, path):
        """A page, until it says that it is ready. Returns the milliseconds that it took."""
        self.log("browser"), self.log("performance")
        self.call("POST", "/url", {"url": path.resolve().as_uri()})
        return int(self.wait(lambda: self.run("return document.documentElement.dataset.ready"),
                             f"{path} to be ready", 30))

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def log(self, kind):
        return self.call("POST", "/se/log", {"type": kind})

    def requests(self):
        """Addresses that were asked for since the page was opened."""
        messages = [json.loads(entry["message"])["message"] for entry in self.log("performance")]
        return [m["params"]["request"]["url"] for m in messages
                if m["method"] == "Network.requestWillBeSent"]

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def frames(self):
        """Two frames later, so that what was asked for is drawn."""
        self.call("POST", "/execute/async", {"script": """
            const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(() => done(true)));""", "args": []})

    def picture(self, path):
        path.write_bytes(base64.b64decode(self.call("GET", "/screenshot")))

    def press(self, *keys):
        """Keys as a person presses them, where the focus is: "Home", "p"."""
        for key in keys:
            value = KEYS.get(key, key)
            self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [
                {"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]}]})

    def click(self, x, y):
        press = [{"type": "pointerMove", "x": int(x), "y": int(y)},
                 {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.call("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
             "actions": press}]})
