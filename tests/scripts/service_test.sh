#!/bin/bash
# service_test: the unit is one that systemd takes, and leaves a program little that it could do. Where there is no
# systemd-analyze of Debian 12 or later there is nothing to ask.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
version=$(systemd-analyze --version 2>/dev/null | sed -n '1s/systemd \([0-9]*\).*/\1/p')
[ "${version:-0}" -ge 252 ] || { echo "no systemd-analyze 252"; exit 77; }

# The program is not installed where a test runs: the unit is looked at with one that is there.
sed 's|^ExecStart=/usr/bin/metamer|ExecStart=/bin/true|' "$scripts/../config/metamer.service" >"$scratch/metamer.service"
expect "systemd-analyze verify" "" "$(systemd-analyze --man=no verify "$scratch/metamer.service" 2>&1 | grep metamer)"

# The exposure is 1.1 of 10: the screen, touch panels, the driver's compiler. docs/service.md goes through it.
systemd-analyze security --offline=yes --no-pager --threshold=11 "$scratch/metamer.service" >"$scratch/said" 2>&1 ||
    expect "exposure" "1.1 at most" "$(grep -E '✗|Overall' "$scratch/said")"
grep Overall "$scratch/said"

# What the issue of running for months asks, line by line.
for line in Type=notify Restart=always StartLimitIntervalSec=0 ProtectSystem=strict NoNewPrivileges=yes \
    "SupplementaryGroups=video render input" "ExecStart=/usr/bin/metamer run --wait /etc/metamer/kiosk.ini"; do
    expect "$line" "$line" "$(grep -xF -- "$line" "$scripts/../config/metamer.service")"
done
done_expecting
