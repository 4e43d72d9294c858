#!/bin/bash
# install_test BUILD: what `cmake --install` leaves works by itself: the program, and the exhibits with their maps.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"

cmake --install "$1" --prefix "$scratch/usr" >"$scratch/log" 2>&1 || expect "cmake --install" "exit 0" "$(cat "$scratch/log")"
cd "$scratch" || exit 1
expect_has "the version" "metamer 0." "$(usr/bin/metamer --version 2>&1)"
while IFS= read -r exhibit; do
    usr/bin/metamer check "$exhibit" >"$scratch/log" 2>&1 || expect "check $exhibit" "exit 0" "$(cat "$scratch/log")"
    checked=yes
done < <(find usr/share/metamer/config -name '*.ini' ! -path '*/strings/*')
expect "exhibits are installed" yes "${checked:-no}"
done_expecting
