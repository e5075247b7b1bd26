"""One USB serial adapter as the machine knows it: its entry in the tree of devices, and the messages that tell of it."""

import os
import shutil
import socket
import struct
import time

class Adapter:
    MULTICAST_UDEV = 2

    def __init__(self, run):
        self.run = run
        self.properties = {
            "MAJOR": 188,
            "ID_BUS": "usb",
            "ID_VENDOR_ID": "0403",
            "ID_MODEL_ID": "6001",
            "ID_MODEL": "Rig_Serial_Adapter",
            "ID_MODEL_ENC": "Rig\\x20Serial\\x20Adapter",
            # Without a serial number Chromium forgets the pilot's choice when the port goes.
            "ID_SERIAL_SHORT": "RIG0001",
        }
        self.sequence = 1_000_000
        self.name_it(0)

    def name_it(self, number):
        """The name that the machine gives it; one that is plugged in again quickly may get another."""
        self.name = f"ttyUSB{number}"
        self.node = f"{self.run}/dev/{self.name}"
        self.entry = f"{self.run}/sys/devices/{self.name}"
        self.link = f"{self.run}/sys/class/{self.name}"
        self.properties.update(MINOR=number, DEVNAME=self.node)

    def appear(self):
        os.makedirs(self.entry)
        os.symlink("../../../../class/tty", f"{self.entry}/subsystem")
        with open(f"{self.entry}/dev", "w") as file:
            file.write("{MAJOR}:{MINOR}\n".format(**self.properties))
        with open(f"{self.entry}/uevent", "w") as file:
            file.writelines(f"{name}={value}\n" for name, value in self.properties.items())
        os.symlink(f"../../devices/virtual/tty/{self.name}", self.link)
        self._tell("add")

    def disappear(self):
        os.unlink(self.link)
        shutil.rmtree(self.entry)
        self._tell("remove")

    def _tell(self, action):
        """Sends what udevd would send: libudev's header, with the hash that listeners filter by, then the properties."""
        self.sequence += 1
        properties = {
            "ACTION": action,
            "DEVPATH": f"/devices/virtual/tty/{self.name}",
            "SUBSYSTEM": "tty",
            "SEQNUM": self.sequence,
            "USEC_INITIALIZED": time.monotonic_ns() // 1000,
            **self.properties,
        }
        body = b"".join(f"{name}={value}\0".encode() for name, value in properties.items())
        header = b"libudev\0" + struct.pack(">I", 0xFEEDCAFE) + struct.pack("=III", 40, 40, len(body))
        header += struct.pack(">IIII", murmur2(b"tty"), 0, 0, 0)
        with socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 15) as kobject_uevent:
            kobject_uevent.bind((0, 0))
            try:
                kobject_uevent.sendto(header + body, (0, self.MULTICAST_UDEV))
            except ConnectionRefusedError:
                pass  # Nobody listens: Chromium has not started yet.


def murmur2(data):
    """MurmurHash2 with seed 0, by which libudev marks the subsystem of a message."""
    multiplier, mask = 0x5BD1E995, 0xFFFFFFFF
    value = len(data)
    whole = len(data) // 4 * 4
    for (word,) in struct.iter_unpack("<I", data[:whole]):
        word = word * multiplier & mask
        word = (word ^ word >> 24) * multiplier & mask
        value = (value * multiplier & mask) ^ word
    if data[whole:]:
        value = (value ^ int.from_bytes(data[whole:], "little")) * multiplier & mask
    value = (value ^ value >> 13) * multiplier & mask
    return value ^ value >> 15
