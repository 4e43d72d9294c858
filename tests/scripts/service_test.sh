#!/bin/bash
# service_test: the unit is one that systemd takes, and leaves a program little that it could do.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
version=$(systemd-analyze --version 2>/dev/null | head -n 1)
number=${version#systemd }
[ "${number%%[!0-9]*}" -ge 252 ] 2>/dev/null || {
    echo "cannot ask about the unit: systemd-analyze 252 or later wanted, found: ${version:-none}; apt-get install systemd" >&2
    exit 1
}

# The program is not installed where a test runs: the unit is looked at with one that is there.
sed 's|^ExecStart=/usr/bin/metamer|ExecStart=/bin/true|' "$scripts/../config/metamer.service" >"$scratch/metamer.service"
expect "systemd-analyze verify" "" "$(systemd-analyze --man=no verify "$scratch/metamer.service" 2>&1 | grep metamer)"

# The exposure is 1.1 of 10: the screen, touch panels, the driver's compiler. docs/service.md goes through it.
systemd-analyze security --offline=yes --no-pager --threshold=11 "$scratch/metamer.service" >"$scratch/said" 2>&1 ||
    expect "exposure" "1.1 at most" "$(grep -E '✗|Overall' "$scratch/said")"
grep Overall "$scratch/said"

# What a line starts is named in full: the package's dependencies are held to it (scripts/package-test).
expect "commands without a path" "" "$(grep -E '^Exec[A-Za-z]*=[^/]' "$scripts/../config/metamer.service")"

# What the issue of running for months asks, line by line.
for line in Type=notify Restart=always StartLimitIntervalSec=0 WatchdogSec=30 MemoryHigh=384M MemoryMax=512M \
    DynamicUser=yes ProtectSystem=strict NoNewPrivileges=yes RuntimeDirectory=metamer IPAddressDeny=any \
    "SupplementaryGroups=video render input" "ExecStart=/usr/bin/metamer run --wait /etc/metamer/kiosk.ini"; do
    expect "$line" "$line" "$(grep -xF -- "$line" "$scripts/../config/metamer.service")"
done
done_expecting
