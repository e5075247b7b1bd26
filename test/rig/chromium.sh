#!/bin/sh
# Chromium as it is installed, inside the box whose first process is RIG_BOX.
export SYSTEMD_DEVICE_VERIFY_SYSFS=0 # libudev: this tree of devices is not the kernel's own
exec nsenter --target "$RIG_BOX" --user --mount --net --preserve-credentials chromium "$@"
