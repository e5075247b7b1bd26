#!/bin/sh
# box.sh SITE: the box in which Chromium meets the rig's serial port and no other, and the built page of SITE.
# `unshare` has made its namespaces before this starts: mounts and network, which end with the last process that is in
# them. So nothing outside is changed, and two boxes do not disturb each other. Chromium enters by chromium.sh.
set -e
# Under /dev, where Firefox believes that a serial port is one.
run=$(mktemp -d --tmpdir=/dev/shm sidus-rig-XXXXXX)
trap 'rm -rf "$run"' EXIT # if something below fails; else box.py does it
mkdir -p "$run/dev" "$run/sys/devices" "$run/sys/class" "$run/chromium/policies/managed"

# Where Chromium looks for serial ports, and for the drivers that have real ones.
mount --bind "$run/sys/devices" /sys/devices/virtual/tty
mount --bind "$run/sys/class" /sys/class/tty
{
  grep -v ' serial$' /proc/tty/drivers
  echo 'usbserial            /dev/ttyUSB   188 0-511 serial'
} >"$run/drivers"
mount --bind "$run/drivers" /proc/tty/drivers
# Where it looks for what the owner of the machine has decreed.
mount --bind "$run/chromium" /etc/chromium

rig=$(dirname "$0")
exec python3 -B "$rig/box.py" "$run" "$1" "$rig/policy.json"
