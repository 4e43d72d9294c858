#!/bin/bash
# figures_test BUILD: what docs/figures.md says of the fifteen lamps is what its command prints.
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
top=$(dirname "$scripts")

# Rows `LAMP MEAN GREATEST crayon-NAME` of the command, `| LAMP | MEAN | GREATEST | NAME |` of the page.
"$1/metamer" render "$top/config/crayons.ini" --output "$scratch/crayons.png" --table |
    sed -n 's/^\([^ ]*\)  *\([0-9.]*\)  *\([0-9.]*\)  crayon-\(.*\)$/\1 \2 \3 \4/p' | sort >"$scratch/printed"
sed -n 's/^| \([^ ]*\) | \([0-9.]*\) | \([0-9.]*\) | \([a-z-]*\) |$/\1 \2 \3 \4/p' "$top/docs/figures.md" |
    sort >"$scratch/told"
expect "fifteen lamps" 15 "$(wc -l <"$scratch/printed")"
expect "the table of docs/figures.md" "$(cat "$scratch/printed")" "$(cat "$scratch/told")"

done_expecting
