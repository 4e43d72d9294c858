#!/bin/bash
# scripts/check-links takes this tree's pages, and names each link of a page that leads nowhere.
# shellcheck disable=SC2016 # backquotes are Markdown's
set -uo pipefail
# shellcheck source=tests/scripts/expect.sh
. "$(dirname "$0")/expect.sh"
top=$(dirname "$scripts")

expect_has "this tree's pages" "check-links: fine: " \
    "$("$scripts/check-links" "$top"/{README,CONTRIBUTING,CHANGELOG,LICENSE-DATA}.md "$top/docs" "$top/config" 2>&1)"

mkdir -p "$scratch/pages/there"
page=$scratch/pages/there/page.md
touch "$scratch/pages/sibling.png"

# says SENTENCE LINE...: of a page of these lines.
says() {
    local sentence=$1
    shift
    printf '%s\n' "$@" >"$page"
    expect "$*" "check-links: $sentence" "$("$scripts/check-links" "$scratch/pages" 2>&1)"
}
good="fine: 1 pages"
nowhere="links that lead nowhere: $page:"
says "$good" '[up](../sibling.png), [a part](../sibling.png#there), [a folder](../there), <img src="../sibling.png">'
says "$good" '[web](https://example.org/no), [here](#part), [mail](mailto:nobody@example.org)'
says "$good" '`[code](none.md)`' '```' '[more](none.md)' '```'
says "$nowhere none.md" '[one](none.md) and [another](../sibling.png)'
says "$nowhere none.png" '![a picture](none.png)'
says "$nowhere none.png" '<img src="none.png" width="9">'
says "$nowhere none.md#part" '[a part](none.md#part)'
says "$nowhere a.md; $page: b.md" '[`a`](a.md) [b](b.md "its title")'
says "$nowhere after.md" '```' '[code](none.md)' '```' '[after](after.md)'
ln -s ../nothing "$scratch/pages/there/link"
says "$nowhere link" '[a link to nothing](link)'

"$scripts/check-links" "$scratch/pages" >/dev/null 2>&1
expect "exit status where a link is broken" 1 $?
expect "no such place" "check-links: cannot find $scratch/none" "$("$scripts/check-links" "$scratch/pages" "$scratch/none" 2>&1)"
expect "no page" "check-links: cannot find a page in $scratch/pages/sibling.png: no *.md" \
    "$("$scripts/check-links" "$scratch/pages/sibling.png" 2>&1)"
done_expecting
