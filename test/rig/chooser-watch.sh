#!/bin/sh
# Tells whether Firefox's own port chooser is there, as chooser-watch.js does for Chromium: it is a window of this name.
# What it lists cannot be seen from outside and counts as one port, and Firefox has marked the first.
while :; do
  if xdotool search --onlyvisible --name '^Firefox$' >/dev/null 2>&1; then
    now='{ "shown": true, "rows": 1, "selected": 0 }'
  else
    now='{ "shown": false, "rows": 0, "selected": -1 }'
  fi
  [ "$now" = "$before" ] || echo "$now" || exit
  before=$now
  sleep 0.1
done
