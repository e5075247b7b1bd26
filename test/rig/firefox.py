#!/usr/bin/env python3
"""
Firefox as it is installed, inside the box whose first process is RIG_BOX. It takes orders at a port that nobody outside
the box can reach: so this listens at the same port outside, and passes everything on.
"""

import os
import socket
import subprocess
import sys
import threading


def outside(arguments):
    listener = socket.create_server(("127.0.0.1", 0))
    listener.set_inheritable(True)  # It stays a door to outside, also for a process inside.
    os.environ["RIG_LISTENER"] = str(listener.fileno())
    enter = ["--target", os.environ["RIG_BOX"], "--user", "--mount", "--net", "--preserve-credentials"]
    os.execvp("nsenter", ["nsenter", *enter, sys.executable, "-B", __file__, *arguments])


def inside(arguments):
    listener = socket.socket(fileno=int(os.environ["RIG_LISTENER"]))
    port = listener.getsockname()[1]
    threading.Thread(target=relay, args=(listener, port), daemon=True).start()
    surroundings = {
        **os.environ,
        "SYSTEMD_DEVICE_VERIFY_SYSFS": "0",  # libudev: this tree of devices is not the kernel's own
        "LD_PRELOAD": os.environ["RIG_MODEM"],
    }
    # Of two arguments of this name Firefox takes the first.
    return subprocess.call(["firefox-esr", f"--remote-debugging-port={port}", *arguments], env=surroundings)


def relay(listener, port):
    while True:
        near, _ = listener.accept()
        far = socket.create_connection(("127.0.0.1", port))
        for ends in (near, far), (far, near):
            threading.Thread(target=pass_on, args=ends, daemon=True).start()


def pass_on(here, there):
    while data := here.recv(65536):
        there.sendall(data)
    there.shutdown(socket.SHUT_WR)


if "RIG_LISTENER" in os.environ:
    sys.exit(inside(sys.argv[1:]))
outside(sys.argv[1:])
